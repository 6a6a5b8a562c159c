#include "widgets/working/block_layout.h"

#include <QCoreApplication>

namespace halfspace {
namespace {

struct RemarkWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::RemarkWords)
};

QString textOf(const LineRemark &remark) {
  return remark.isOfNow ? remark.text : RemarkWords::tr("Before the change: %1").arg(remark.text);
}

} // namespace

void BlockLayout::clear() {
  m_lines.clear();
  m_placed = {};
}

void BlockLayout::setRemarks(LineRemarks remarks) {
  m_remarks = std::move(remarks);
  m_remarkTexts.clear();
  for (const auto &[line, remark] : m_remarks)
    m_remarkTexts[line] = textOf(remark);
}

void BlockLayout::setHeld(bool held) {
  if (!held) {
    m_held.reset();
    return;
  }
  m_held.emplace();
  hold();
}

void BlockLayout::hold() {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    (*m_held)[m_lines[i].source.id] = m_placed.lines[i];
}

void BlockLayout::forgetHeights() {
  if (m_held)
    m_held->clear();
}

void BlockLayout::place(const QFont &font, double width) {
  m_placed = placeWorking(m_lines, m_remarkTexts, m_sentences, font, width, m_held ? *m_held : HeldLines());
  if (m_held)
    hold();
}

double BlockLayout::heightIn(const QFont &font, double width) const {
  return placeWorking(m_lines, m_remarkTexts, m_sentences, font, width).size.height();
}

const LineRemark *BlockLayout::remarkOf(std::size_t line) const {
  const auto remark = m_remarks.find(m_lines.at(line).source.id);
  return remark == m_remarks.end() ? nullptr : &remark->second;
}

std::optional<std::size_t> BlockLayout::lineAt(QPointF position) const {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_placed.lines[i].box.contains(position))
      return i;
  return std::nullopt;
}

QString BlockLayout::markAt(QPointF position) const {
  const auto line = lineAt(position);
  if (!line)
    return {};
  QString found;
  for (const PlacedFormula &formula : m_placed.lines[*line].formulas)
    for (const auto &[mark, box] : formula.picture->markBoxes()) // the innermost comes last
      if (touchedRoom(formula.toWorking(box)).contains(position))
        found = mark;
  return found;
}

} // namespace halfspace
