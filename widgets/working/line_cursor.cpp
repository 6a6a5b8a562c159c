#include "widgets/working/line_cursor.h"

#include <algorithm>

namespace halfspace {

const Term *LineCursor::chosenNumber() const {
  return m_chosen ? m_layout.numbers().numberAt(*m_chosen) : nullptr;
}

void LineCursor::goTo(std::optional<std::size_t> line) {
  m_line = line;
  if (m_chosen)
    endChoice();
  if (line)
    emit reached(m_layout.roomOf(*line));
  emit changed();
}

void LineCursor::goToLineOf(const NumberPlace &number) {
  m_line = m_layout.numbers().lineOf(number);
  endChoice();
}

void LineCursor::endChoice() {
  m_chosen.reset();
  emit choiceChanged();
  emit changed();
}

void LineCursor::followLines() {
  if (m_line && *m_line >= m_layout.lines().size())
    m_line.reset();
}

bool LineCursor::useKey(int key) {
  switch (key) {
  case Qt::Key_Down:
    return step(1);
  case Qt::Key_Up:
    return step(-1);
  case Qt::Key_Right:
    return chooseBeside(1);
  case Qt::Key_Left:
    return chooseBeside(-1);
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return useChosen();
  default:
    return false;
  }
}

bool LineCursor::step(int way) {
  const std::size_t count = m_layout.lines().size();
  const std::size_t next = !m_line ? (way > 0 ? 0 : count - 1) : *m_line + static_cast<std::size_t>(way);
  if (next >= count) // beyond the last, or before the first
    return m_goOn && m_goOn(way);
  goTo(next);
  return true;
}

bool LineCursor::comeIn(int way) {
  const std::size_t count = m_layout.lines().size();
  if (count == 0 || !m_block.isVisible())
    return false;
  m_block.setFocus();
  goTo(way > 0 ? 0 : count - 1);
  return true;
}

bool LineCursor::chooseBeside(int way) {
  const std::size_t line = m_line.value_or(0);
  const std::vector<NumberPlace> shown = m_layout.numbers().inLine(line);
  if (shown.empty())
    return false;
  const auto chosen = m_chosen ? std::find(shown.begin(), shown.end(), *m_chosen) : shown.end();
  const auto last = static_cast<std::ptrdiff_t>(shown.size()) - 1;
  const std::ptrdiff_t next = chosen == shown.end()
                                  ? (way > 0 ? 0 : last)
                                  : std::clamp(chosen - shown.begin() + way, std::ptrdiff_t{0}, last);
  goTo(line);
  m_chosen = shown[static_cast<std::size_t>(next)];
  if (const auto boxes = m_layout.numbers().boxesOf(*m_chosen); !boxes.empty())
    emit reached(boxes.front().toAlignedRect());
  emit choiceChanged();
  emit changed();
  return true;
}

bool LineCursor::useChosen() {
  if (!m_chosen || !m_layout.numbers().lineOf(*m_chosen))
    return false;
  emit chosenUsed(*m_chosen);
  return true;
}

} // namespace halfspace
