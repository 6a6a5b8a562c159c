#include "widgets/lesson/contents_drawer.h"

#include "widgets/colors.h"
#include "widgets/verdict.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr int stateRole = Qt::UserRole + 1;
/// What is looked through when a lesson is searched: of lessons alone.
constexpr int soughtRole = Qt::UserRole + 2;
constexpr int headingRole = Qt::UserRole + 3; ///< whether it is a chapter
/// How wide the drawer is, in letters.
constexpr int lettersInDrawer = 52;
/// Left and right of a title, as in the style sheet, in em.
constexpr double titlePadding = 0.45 + 2.4;
/// The id stands so far from the left and the bottom, likewise.
constexpr double idIndent = 0.45;
constexpr double idMargin = 0.4;
/// The mark of what is done stands so far from the right edge, likewise.
constexpr double markDistance = 1.0;
constexpr double markRadius = 0.55;
/// Of the size of a title.
constexpr double smallWords = 0.88;

QFont smallFont(QFont font) {
  font.setPointSizeF(font.pointSizeF() * smallWords);
  return font;
}

/// A title, wrapped within the style sheet's padding, which Qt leaves out of account, and below it the
/// lesson's id; at its right the mark that says whether the lesson is done.
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
    const QSize words = QStyledItemDelegate::sizeHint(narrower, index);
    return isLesson(index) ? words + QSize(0, QFontMetrics(smallFont(option.font)).height()) : words;
  }

  void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override {
    const double em = QFontInfo(option.font).pixelSize();
    QStyledItemDelegate::paint(painter, option, index);
    const QPointF center(option.rect.right() - markDistance * em, option.rect.center().y() + 0.5);
    const auto state = static_cast<LessonState>(index.data(stateRole).toInt());
    if (isLesson(index))
      paintId(*painter, option, index.data(Qt::UserRole).toString());
    if (state != LessonState::New)
      paintVerdict(*painter, center, markRadius * em,
                   state == LessonState::Done ? Verdict::Right : Verdict::Open, m_theme);
  }

private:
  static bool isLesson(const QModelIndex &index) { return index.flags() & Qt::ItemIsEnabled; }

  void paintId(QPainter &painter, const QStyleOptionViewItem &option, const QString &id) const {
    const double em = QFontInfo(option.font).pixelSize();
    const int textMargin = option.widget->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
    const QRectF room = QRectF(option.rect).adjusted(idIndent * em + textMargin, 0, 0, -idMargin * em);
    painter.save();
    painter.setFont(smallFont(option.font));
    painter.setPen(toQColor(m_theme.mutedInk));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignBottom, id);
    painter.restore();
  }

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

bool isLesson(const QListWidgetItem &item) { return item.flags() & Qt::ItemIsEnabled; }

bool hasAll(const QString &text, const QStringList &words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

/// Of the keys that a line of text has no use for.
bool movesInList(const QKeyEvent &key) {
  switch (key.key()) {
  case Qt::Key_Up:
  case Qt::Key_Down:
  case Qt::Key_PageUp:
  case Qt::Key_PageDown:
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return true;
  default:
    return false;
  }
}

} // namespace

ContentsDrawer::ContentsDrawer(QWidget *parent)
    : QFrame(parent), m_search(new QLineEdit), m_list(new QListWidget), m_theme(themes().front()) {
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
  m_search->setObjectName("lessonSearch");
  m_search->setPlaceholderText(tr("Search"));
  m_search->setAccessibleName(tr("Search the lessons"));
  m_search->setClearButtonEnabled(true);
  m_search->installEventFilter(this);
  m_list->setFocusPolicy(Qt::ClickFocus); // its keys are the search's too
  connect(m_search, &QLineEdit::textChanged, this, &ContentsDrawer::search);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(heading);
  layout->addWidget(m_search);
  layout->addWidget(m_list, 1);
  connect(m_list, &QListWidget::itemClicked, this, &ContentsDrawer::choose);
  connect(m_list, &QListWidget::itemActivated, this, &ContentsDrawer::choose);
  parent->installEventFilter(this);
  hide();
}

void ContentsDrawer::choose(const QListWidgetItem *item) {
  if (!isLesson(*item)) // a chapter can be clicked all the same
    return;
  close();
  emit lessonChosen(item->data(Qt::UserRole).toString());
}

void ContentsDrawer::search(const QString &words) {
  const QStringList sought = words.split(u' ', Qt::SkipEmptyParts);
  QListWidgetItem *first = nullptr;
  QListWidgetItem *chapter = nullptr;
  bool isFound = false;
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem &item = *m_list->item(i);
    const bool isHeading = item.data(headingRole).toBool();
    if (isLesson(item))
      isFound = hasAll(item.data(soughtRole).toString(), sought);
    item.setHidden(isHeading || !isFound); // a chapter is there as soon as one of its lessons is
    if (isHeading)
      chapter = &item;
    else if (isFound && chapter)
      chapter->setHidden(false);
    if (isFound && !first && isLesson(item))
      first = &item;
  }
  if (first && (!m_list->currentItem() || m_list->currentItem()->isHidden()))
    m_list->setCurrentItem(first);
}

void ContentsDrawer::addWords(const QString &words, bool isHeading) {
  auto *item = new QListWidgetItem(words, m_list);
  item->setFlags(Qt::NoItemFlags);
  item->setForeground(toQColor(m_theme.mutedInk));
  QFont font = smallFont(m_list->font());
  font.setBold(isHeading);
  item->setFont(font);
  item->setData(headingRole, isHeading);
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
    item->setData(soughtRole, QStringList{lesson.title, lesson.chapter, lesson.id}.join(u' '));
    item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop); // the id is below it
    item->setData(Qt::AccessibleTextRole,
                  state.isEmpty() ? lesson.title
                                  : tr("%1, %2", "a lesson and its state").arg(lesson.title, state));
    if (lesson.id == current)
      m_list->setCurrentItem(item);
    if (!lesson.needs.isEmpty())
      addWords(tr("after %1", "the lessons that come first").arg(lesson.needs.join(tr(", "))), false);
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
  m_search->clear();
  raise();
  show();
  m_before = window()->focusWidget();
  m_search->setFocus();
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
  if (watched == m_search && event->type() == QEvent::KeyPress &&
      movesInList(static_cast<const QKeyEvent &>(*event))) {
    QCoreApplication::sendEvent(m_list, event);
    return true;
  }
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
