#include "widgets/explore/entry_bar.h"

#include "widgets/colors.h"

#include <QVBoxLayout>

namespace halfspace {
namespace {

constexpr QMargins barMargins(10, 6, 10, 6);
constexpr int gap = 4;

} // namespace

EntryBar::EntryBar(QWidget *parent) : QWidget(parent), m_field(new EntryField), m_row(new QHBoxLayout) {
  setObjectName("entryBar");
  setAttribute(Qt::WA_StyledBackground);
  m_field->setObjectName("entryField");
  m_field->setAccessibleName(tr("Type a line, or what you want to do"));
  m_field->setPlaceholderText(tr("Type an entry, as Q = (11, 15, 8), or what you want to do"));
  m_row->setSpacing(gap);
  m_row->addWidget(m_field, 1);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(barMargins);
  column->setSpacing(gap);
  column->addLayout(m_row);
  setFocusProxy(m_field);
  connect(m_field, &QLineEdit::textEdited, this, &EntryBar::edited);
  connect(m_field, &EntryField::stepped, this, &EntryBar::step);
  connect(m_field, &EntryField::entering, this, &EntryBar::enter);
  connect(m_field, &EntryField::dismissed, this, &EntryBar::left);
  connect(m_field, &EntryField::linesPasted, this, &EntryBar::linesPasted);
  connect(m_field, &EntryField::completing, this,
          [this] { emit completed(std::max(suggestions().currentRow(), 0)); });
}

void EntryBar::addTool(QWidget &tool) { m_row->addWidget(&tool); }

void EntryBar::setText(const QString &text, EntryField::Part selected) {
  m_field->setText(text);
  if (selected.length > 0)
    m_field->setSelection(selected.begin, selected.length);
  else
    m_field->setCursorPosition(selected.begin);
}

void EntryBar::takeFocus() {
  m_field->setFocus(Qt::ShortcutFocusReason);
  m_field->selectAll();
}

SuggestionList &EntryBar::suggestions() {
  if (!m_suggestions) {
    m_suggestions = new SuggestionList(*m_field);
    connect(m_suggestions, &SuggestionList::taken, this, &EntryBar::taken);
  }
  return *m_suggestions;
}

void EntryBar::setSuggestions(const std::vector<Suggestion> &all, bool isFirstChosen) {
  suggestions().setSuggestions(all);
  m_field->setCanComplete(
      std::any_of(all.begin(), all.end(), [](const Suggestion &each) { return each.isLine; }));
  suggestions().setCurrentRow(isFirstChosen && !all.empty() ? 0 : -1);
}

void EntryBar::say(const QString &sentence) { suggestions().say(sentence, false); }

void EntryBar::complain(const QString &sentence, EntryField::Part part) {
  suggestions().say(sentence, true);
  m_field->setFault(part);
}

void EntryBar::setTheme(const Theme &theme) { m_field->setFaultInk(toQColor(theme.warning)); }

void EntryBar::step(int rows) {
  if (suggestions().hasRows() && (rows > 0 || suggestions().currentRow() >= 0))
    suggestions().stepBy(rows);
  else
    emit recalled(rows);
}

void EntryBar::enter() {
  const int row = suggestions().hasRows() ? suggestions().currentRow() : -1;
  if (row >= 0)
    emit taken(row);
  else
    emit entered();
}

} // namespace halfspace
