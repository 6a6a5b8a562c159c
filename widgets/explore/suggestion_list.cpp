#include "widgets/explore/suggestion_list.h"

#include "widgets/repolish.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int mostRows = 10;
/// The share of the texts, at least, beside the details.
constexpr double textShare = 0.55;

} // namespace

SuggestionList::SuggestionList(QWidget &field)
    : QFrame(field.window()), m_field(field), m_sentence(new QLabel), m_rows(new QTreeWidget) {
  setObjectName("suggestions");
  m_sentence->setObjectName("entrySentence");
  m_sentence->setTextFormat(Qt::PlainText);
  m_sentence->setWordWrap(true);
  m_sentence->hide();
  m_rows->setAccessibleName(tr("Suggestions"));
  m_rows->setFocusPolicy(Qt::NoFocus);
  m_rows->setColumnCount(2);
  m_rows->setHeaderHidden(true);
  m_rows->setRootIsDecorated(false);
  m_rows->setUniformRowHeights(true);
  m_rows->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_rows->header()->setStretchLastSection(false);
  m_rows->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_rows->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_sentence);
  column->addWidget(m_rows);
  hide();
  field.installEventFilter(this);
  connect(m_rows, &QTreeWidget::itemPressed, this,
          [this](QTreeWidgetItem *item) { emit taken(m_rows->indexOfTopLevelItem(item)); });
}

void SuggestionList::say(const QString &sentence, bool isWrong) {
  m_sentence->setText(sentence);
  m_sentence->setVisible(!sentence.isEmpty());
  m_sentence->setProperty("wrong", isWrong);
  repolish(*m_sentence);
  place();
}

void SuggestionList::setSuggestions(const std::vector<Suggestion> &suggestions) {
  m_rows->clear();
  for (const Suggestion &suggestion : suggestions) {
    auto *row = new QTreeWidgetItem(m_rows, {suggestion.text, suggestion.detail});
    row->setForeground(1, palette().placeholderText());
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  }
  place();
}

bool SuggestionList::hasRows() const { return isVisible() && m_rows->topLevelItemCount() > 0; }

int SuggestionList::currentRow() const {
  return m_rows->currentItem() ? m_rows->indexOfTopLevelItem(m_rows->currentItem()) : -1;
}

void SuggestionList::setCurrentRow(int row) {
  m_rows->setCurrentItem(row >= 0 ? m_rows->topLevelItem(row) : nullptr);
  if (row < 0)
    m_rows->clearSelection();
}

void SuggestionList::stepBy(int rows) {
  const int count = m_rows->topLevelItemCount();
  const int next = currentRow() + rows;
  setCurrentRow(next >= -1 && next < count ? next : next < -1 ? count - 1 : -1);
}

void SuggestionList::place() {
  const int rows = std::min(m_rows->topLevelItemCount(), mostRows);
  const bool hasSentence = !m_sentence->text().isEmpty();
  m_rows->setVisible(rows > 0);
  m_rows->setFixedHeight(rows * std::max(m_rows->sizeHintForRow(0), 1));
  m_rows->header()->setMaximumSectionSize(static_cast<int>(m_field.width() * textShare));
  setVisible((rows > 0 || hasSentence) && m_field.isVisible());
  move(m_field.mapTo(window(), QPoint(0, m_field.height())));
  setFixedWidth(m_field.width());
  adjustSize();
  raise();
}

bool SuggestionList::eventFilter(QObject *watched, QEvent *event) {
  switch (event->type()) {
  case QEvent::Resize:
  case QEvent::Move:
    place();
    break;
  case QEvent::FocusOut:
  case QEvent::Hide:
    hide();
    break;
  default:
    break;
  }
  return QFrame::eventFilter(watched, event);
}

} // namespace halfspace
