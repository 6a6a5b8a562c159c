#include "widgets/working/step_working.h"

#include <QApplication>

#include <algorithm>

namespace halfspace {

StepWorking::StepWorking(const Typesetter &typesetter, QObject *parent)
    : QObject(parent), m_typesetter(typesetter), m_theme(themes().front()) {}

WorkingBlock *StepWorking::addBlock() {
  auto *block = new WorkingBlock(m_typesetter);
  block->setTheme(m_theme);
  block->setInkOf(m_inkOf);
  block->setHighlighted(m_highlighted);
  block->setHeld(m_held);
  connect(block, &WorkingBlock::markHovered, this, &StepWorking::markHovered);
  connect(block, &WorkingBlock::answered, this, &StepWorking::answered);
  connect(block, &WorkingBlock::showRequested, this, &StepWorking::showRequested);
  connect(block, &WorkingBlock::traceRequested, this, &StepWorking::trace);
  connect(block, &WorkingBlock::traceDropped, this, &StepWorking::endTrace);
  connect(block, &WorkingBlock::reached, this,
          [this, block](const QRect &place) { emit reached(block, place); });
  connect(block, &WorkingBlock::typing, this, &StepWorking::typing);
  connect(block, &WorkingBlock::coordinateTyped, this, &StepWorking::coordinateTyped);
  connect(block, &WorkingBlock::coordinateStepped, this, &StepWorking::coordinateStepped);
  connect(block, &WorkingBlock::scrubStarted, this, &StepWorking::scrubStarted);
  connect(block, &WorkingBlock::scrubbed, this, &StepWorking::scrubbed);
  connect(block, &WorkingBlock::scrubEnded, this, &StepWorking::scrubEnded);
  block->setGoOn([this, block](int way) { return goOn(*block, way); });
  connect(block, &QObject::destroyed, this, [this, block] { std::erase(m_blocks, block); });
  m_blocks.push_back(block);
  return block;
}

void StepWorking::dropBlocks() {
  for (WorkingBlock *block : m_blocks) {
    block->disconnect(this);
    block->setGoOn({});
  }
  m_blocks.clear();
  emit markHovered({}); // the pointer is on none of their terms any more
}

bool StepWorking::goOn(const WorkingBlock &from, int way) {
  const auto count = static_cast<std::ptrdiff_t>(m_blocks.size());
  auto next = std::find(m_blocks.begin(), m_blocks.end(), &from) - m_blocks.begin() + way;
  while (next >= 0 && next < count && !m_blocks[static_cast<std::size_t>(next)]->comeIn(way))
    next += way;
  return next >= 0 && next < count;
}

void StepWorking::setWorking(const Working &working, const std::vector<std::size_t> &linesIn,
                             const Fade &fade, const std::map<std::string, LineRemark> &remarks) {
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

bool StepWorking::isTyping() const {
  const QWidget *focused = QApplication::focusWidget();
  return std::any_of(m_blocks.begin(), m_blocks.end(), [&](const WorkingBlock *block) {
    return focused && focused != block && block->isAncestorOf(focused);
  });
}

void StepWorking::setTheme(const Theme &theme) {
  m_theme = theme;
  for (WorkingBlock *block : m_blocks)
    block->setTheme(theme);
}

void StepWorking::setInkOf(std::function<QColor(const QString &markId)> inkOf) {
  m_inkOf = std::move(inkOf);
  for (WorkingBlock *block : m_blocks)
    block->setInkOf(m_inkOf);
}

void StepWorking::setHighlighted(const std::set<std::string> &markIds) {
  m_highlighted = markIds;
  for (WorkingBlock *block : m_blocks)
    block->setHighlighted(markIds);
}

void StepWorking::setHeld(bool held) {
  m_held = held;
  for (WorkingBlock *block : m_blocks)
    block->setHeld(held);
}

void StepWorking::forgetAnswers() {
  for (WorkingBlock *block : m_blocks)
    block->forgetAnswers();
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
    block->endChoice();
  followTrace();
}

void StepWorking::followTrace() {
  const Term *number = tracedTerm();
  Provenance traced =
      number ? provenanceOf(*number, m_tracedNumber->line, m_wholeWorking ? m_wholeWorking() : m_working)
             : Provenance();
  for (WorkingBlock *block : m_blocks)
    block->setTrace(m_tracedNumber, traced.lines);
  if (traced == m_traced)
    return;
  m_traced = std::move(traced);
  emit traceChanged();
}

std::optional<TypedCoordinate> StepWorking::typed() const {
  for (const WorkingBlock *block : m_blocks)
    if (auto typed = block->typed())
      return typed;
  return {};
}

QString StepWorking::enterTyped() {
  QString refused;
  for (WorkingBlock *block : m_blocks)
    if (const QString why = block->enterTyped(); refused.isEmpty())
      refused = why;
  return refused;
}

void StepWorking::dropTyped() {
  for (WorkingBlock *block : m_blocks)
    block->dropTyped();
}

void StepWorking::focusField() {
  for (WorkingBlock *block : m_blocks)
    if (block->focusField())
      return;
  const bool isInBlock = std::any_of(m_blocks.begin(), m_blocks.end(),
                                     [](const WorkingBlock *block) { return block->hasFocus(); });
  if (!m_blocks.empty() && !isInBlock)
    m_blocks.front()->setFocus();
}

} // namespace halfspace
