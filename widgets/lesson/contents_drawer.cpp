#include "widgets/lesson/contents_drawer.h"

#include "widgets/colors.h"
#include "widgets/verdict.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr int stateRole = Qt::UserRole + 1;
/// How wide the drawer is, in letters.
constexpr int lettersInDrawer = 52;
/// Left and right of a title, as in the style sheet, in em.
constexpr double titlePadding = 0.45 + 2.4;
/// The mark of what is done stands so far from the right edge, likewise.
constexpr double markDistance = 1.0;
constexpr double markRadius = 0.55;
/// Of the size of a title.
constexpr double smallWords = 0.88;

/// A title, wrapped within the style sheet's padding, which Qt leaves out of account; at its right the mark
/// that says whether the lesson is done.
class LessonDelegate : public QStyledItemDelegate {
public:
  LessonDelegate(const Theme &theme, QObject *parent) : QStyledItemDelegate(parent), m_theme(theme) {}

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override {
    QStyleOptionViewItem narrower = option;
    const double em = QFontInfo(option.font).pixelSize();
    const int taken = static_cast<int>(std::ceil(titlePadding * em));
    // There may be a scroll bar later: a title is not measured anew for it.
    const int scrollBar =
        option.widget->style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, option.widget);
    narrower.rect.setWidth(option.rect.width() - taken - scrollBar);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }

  void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override {
    const double em = QFontInfo(option.font).pixelSize();
    QStyledItemDelegate::paint(painter, option, index);
    const QPointF center(option.rect.right() - markDistance * em, option.rect.center().y() + 0.5);
    const auto state = static_cast<LessonState>(index.data(stateRole).toInt());
    if (state != LessonState::New)
      paintVerdict(*painter, center, markRadius * em,
                   state == LessonState::Done ? Verdict::Right : Verdict::Open, m_theme);
  }

private:
  const Theme &m_theme;
};

QString wordFor(LessonState state) {
  switch (state) {
  case LessonState::New:
    return {};
  case LessonState::Begun:
    return ContentsDrawer::tr("begun");
  case LessonState::Done:
    break;
  }
  return ContentsDrawer::tr("done");
}

} // namespace

ContentsDrawer::ContentsDrawer(QWidget *parent)
    : QFrame(parent), m_list(new QListWidget), m_theme(themes().front()) {
  setObjectName("contents");
  setAutoFillBackground(true);
  setAttribute(Qt::WA_NoMousePropagation); // a press on its heading is not one beside it
  m_list->setObjectName("lessonList");
  m_list->setItemDelegate(new LessonDelegate(m_theme, m_list));
  m_list->setWordWrap(true);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setTextElideMode(Qt::ElideNone);
  m_list->setResizeMode(QListView::Adjust); // wrap anew at every width
  m_list->setAccessibleName(tr("Lessons"));
  auto *heading = new QLabel(tr("Lessons"));
  heading->setObjectName("contentsHeading");
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(heading);
  layout->addWidget(m_list, 1);
  const auto choose = [this](const QListWidgetItem *item) {
    if (!(item->flags() & Qt::ItemIsEnabled)) // a chapter can be clicked all the same
      return;
    close();
    emit lessonChosen(item->data(Qt::UserRole).toString());
  };
  connect(m_list, &QListWidget::itemClicked, this, choose);
  connect(m_list, &QListWidget::itemActivated, this, choose);
  parent->installEventFilter(this);
  hide();
}

void ContentsDrawer::addWords(const QString &words, bool isHeading) {
  auto *item = new QListWidgetItem(words, m_list);
  item->setFlags(Qt::NoItemFlags);
  item->setForeground(toQColor(m_theme.mutedInk));
  QFont font = m_list->font();
  font.setPointSizeF(font.pointSizeF() * smallWords);
  font.setBold(isHeading);
  item->setFont(font);
}

void ContentsDrawer::setLessons(const std::vector<Entry> &lessons, const QString &current) {
  m_list->clear();
  QString chapter;
  for (const Entry &lesson : lessons) {
    if (lesson.chapter != chapter)
      addWords(lesson.chapter, true);
    chapter = lesson.chapter;
    auto *item = new QListWidgetItem(lesson.title, m_list);
    const QString state = wordFor(lesson.state);
    item->setData(Qt::UserRole, lesson.id);
    item->setData(stateRole, static_cast<int>(lesson.state));
    item->setData(Qt::AccessibleTextRole,
                  state.isEmpty() ? lesson.title
                                  : tr("%1, %2", "a lesson and its state").arg(lesson.title, state));
    if (lesson.id == current)
      m_list->setCurrentItem(item);
    if (!lesson.needs.isEmpty())
      addWords(tr("After: %1", "the lessons that come first").arg(lesson.needs.join(tr("; "))), false);
  }
}

void ContentsDrawer::setTheme(const Theme &theme) {
  m_theme = theme;
  arrange();
}

void ContentsDrawer::open() {
  if (isVisible())
    return;
  arrange();
  raise();
  show();
  m_before = window()->focusWidget();
  m_list->setFocus();
  qApp->installEventFilter(this);
  emit openChanged(true);
}

void ContentsDrawer::close() {
  if (!isVisible())
    return;
  qApp->removeEventFilter(this);
  if (m_before)
    m_before->setFocus();
  hide();
  emit openChanged(false);
}

void ContentsDrawer::arrange() {
  const int width = lettersInDrawer * fontMetrics().averageCharWidth();
  setGeometry(0, 0, std::min(width, parentWidget()->width()), parentWidget()->height());
}

bool ContentsDrawer::eventFilter(QObject *watched, QEvent *event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize)
    arrange();
  const auto *widget = qobject_cast<QWidget *>(watched);
  if (isVisible() && event->type() == QEvent::MouseButtonPress && widget && widget->window() == window() &&
      widget != this && !isAncestorOf(widget)) {
    close();
    return true; // the press was for the drawer
  }
  return QFrame::eventFilter(watched, event);
}

void ContentsDrawer::keyPressEvent(QKeyEvent *event) {
  if (event->key() == Qt::Key_Escape)
    close();
  else
    QFrame::keyPressEvent(event);
}

} // namespace halfspace
