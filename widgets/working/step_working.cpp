#include "widgets/working/step_working.h"

#include <QApplication>

#include <algorithm>
#include <utility>

namespace halfspace {

StepWorking::StepWorking(const Typesetter &typesetter, QObject *parent)
    : QObject(parent), m_typesetter(typesetter) {}

WorkingBlock *StepWorking::addBlock() {
  auto *block = new WorkingBlock(m_typesetter);
  block->setLook(m_look);
  block->setHeld(m_held);
  connect(block, &WorkingBlock::markHovered, this, [this](const QString &mark) {
    m_hovered = mark;
    emit markHovered(mark);
  });
  connect(block, &WorkingBlock::traceRequested, this, &StepWorking::trace);
  connect(block, &WorkingBlock::traceDropped, this, &StepWorking::endTrace);
  connect(block, &WorkingBlock::reached, this,
          [this, block](const QRect &place) { emit reached(block, place); });
  connect(&block->blanks(), &BlankFields::answered, this, &StepWorking::answered);
  connect(&block->blanks(), &BlankFields::showRequested, this, &StepWorking::showRequested);
  m_coordinates.repeat(block->coordinates());
  block->keys().setGoOn([this, block](int way) { return goOn(*block, way); });
  connect(block, &QObject::destroyed, this, [this, block] { std::erase(m_blocks, block); });
  m_blocks.push_back(block);
  return block;
}

void StepWorking::dropBlocks() {
  for (WorkingBlock *block : m_blocks) {
    block->disconnect(this);
    block->blanks().disconnect(this);
    block->coordinates().disconnect(&m_coordinates);
    block->keys().setGoOn({});
  }
  m_blocks.clear();
  if (!std::exchange(m_hovered, {}).isEmpty())
    emit markHovered({}); // the pointer is on none of their terms any more
}

bool StepWorking::goOn(const WorkingBlock &from, int way) {
  const auto count = static_cast<std::ptrdiff_t>(m_blocks.size());
  auto next = std::find(m_blocks.begin(), m_blocks.end(), &from) - m_blocks.begin() + way;
  while (next >= 0 && next < count && !m_blocks[static_cast<std::size_t>(next)]->keys().comeIn(way))
    next += way;
  return next >= 0 && next < count;
}

void StepWorking::setWorking(const Working &working, const std::vector<std::size_t> &linesIn,
                             const Fade &fade, const LineRemarks &remarks) {
  m_working = working;
  const bool wasTyping = isTyping();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < m_blocks.size(); ++i) {
    const std::size_t end = begin + (i < linesIn.size() ? linesIn[i] : 0);
    m_blocks[i]->setWorking(working, fade, remarks, {begin, end});
    m_blocks[i]->setVisible(end > begin);
    begin = end;
  }
  if (wasTyping && !isTyping()) // the last blank of its block is filled in
    focusField();
  followTrace();
}

std::vector<ToldLine> StepWorking::toldLines() const {
  std::vector<ToldLine> lines;
  for (const WorkingBlock *block : m_blocks)
    if (block->isVisibleTo(block->window())) {
      const std::vector<ToldLine> more = block->toldLines();
      lines.insert(lines.end(), more.begin(), more.end());
    }
  return lines;
}

bool StepWorking::isTyping() const {
  const QWidget *focused = QApplication::focusWidget();
  return std::any_of(m_blocks.begin(), m_blocks.end(), [&](const WorkingBlock *block) {
    return focused && focused != block && block->isAncestorOf(focused);
  });
}

void StepWorking::setTheme(const Theme &theme) {
  m_look.theme = theme;
  showLook();
}

void StepWorking::setInkOf(std::function<QColor(const QString &markId)> inkOf) {
  m_look.inkOf = std::move(inkOf);
  showLook();
}

void StepWorking::setHighlighted(const std::set<std::string> &markIds) {
  if (markIds == m_look.highlighted)
    return;
  m_look.highlighted = markIds;
  showLook();
}

void StepWorking::showLook() {
  for (WorkingBlock *block : m_blocks)
    block->setLook(m_look);
}

void StepWorking::setHeld(bool held) {
  m_held = held;
  for (WorkingBlock *block : m_blocks)
    block->setHeld(held);
}

void StepWorking::forgetAnswers() {
  for (WorkingBlock *block : m_blocks)
    block->blanks().forget();
}

const Term *StepWorking::tracedTerm() const {
  if (m_tracedNumber)
    for (const WorkingBlock *block : m_blocks)
      if (const Term *number = block->shownNumbers().numberAt(*m_tracedNumber))
        return number;
  return nullptr;
}

void StepWorking::trace(const NumberPlace &number) {
  m_tracedNumber = number;
  followTrace();
}

void StepWorking::endTrace() {
  m_tracedNumber.reset();
  for (WorkingBlock *block : m_blocks)
    block->keys().endChoice();
  followTrace();
}

void StepWorking::followTrace() {
  const Term *number = tracedTerm();
  Provenance traced =
      number ? provenanceOf(*number, m_tracedNumber->line, m_wholeWorking ? m_wholeWorking() : m_working)
             : Provenance();
  for (WorkingBlock *block : m_blocks)
    block->setTrace({m_tracedNumber, traced.lines});
  if (traced == m_traced)
    return;
  m_traced = std::move(traced);
  emit traceChanged();
}

void StepWorking::focusField() {
  for (WorkingBlock *block : m_blocks)
    if (block->blanks().focusFirst())
      return;
  const bool isInBlock = std::any_of(m_blocks.begin(), m_blocks.end(),
                                     [](const WorkingBlock *block) { return block->hasFocus(); });
  if (!m_blocks.empty() && !isInBlock)
    m_blocks.front()->setFocus();
}

} // namespace halfspace
