#include "widgets/lesson/hint_column.h"

#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace halfspace {

HintColumn::HintColumn(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_words(*this, [this] { showTold(); }),
      m_column(new QVBoxLayout(this)), m_next(new QToolButton), m_theme(themes().front()) {
  m_column->setContentsMargins(0, 0, 0, 0);
  m_column->addWidget(m_next, 0, Qt::AlignLeft);
  m_next->setObjectName("hint");
  m_next->setAutoRaise(true);
  m_next->setCursor(Qt::PointingHandCursor);
  m_next->setFocusPolicy(Qt::StrongFocus);
  connect(m_next, &QToolButton::clicked, this, &HintColumn::tellNext);
  showButton();
}

void HintColumn::setHints(std::vector<Lazy<FilledMarkdown>> hints) {
  m_hints = std::move(hints);
  m_words.renew();
  showButton();
}

void HintColumn::showTold() {
  for (std::size_t i = 0; i < m_told.size(); ++i)
    m_told[i]->setWords(*m_hints.at(i));
}

void HintColumn::setHeld(bool held) {
  for (RichLabel *label : m_told)
    label->setHeld(held);
}

void HintColumn::setTheme(const Theme &theme) {
  m_theme = theme;
  for (RichLabel *label : m_told)
    label->setInk(theme.ink, theme);
}

void HintColumn::tellNext() {
  addLabel();
  if (m_told.size() == m_hints.size()) // the button goes, and would hand its focus to a number field
    setFocus();
  showButton();
  emit told();
}

void HintColumn::addLabel() {
  auto *label = new RichLabel(m_typesetter);
  label->setInk(m_theme.ink, m_theme);
  label->setWords(*m_hints.at(m_told.size()));
  m_column->insertWidget(static_cast<int>(m_told.size()), label);
  label->show(); // at once: whoever hears of it scrolls there
  m_told.push_back(label);
  // One of the two has the focus then, and is what is spoken.
  m_next->setAccessibleDescription(label->plain());
  setAccessibleDescription(label->plain());
}

void HintColumn::showButton() {
  m_next->setText(m_told.empty() ? tr("Hint") : tr("Another hint"));
  m_next->setVisible(m_told.size() < m_hints.size());
}

} // namespace halfspace
