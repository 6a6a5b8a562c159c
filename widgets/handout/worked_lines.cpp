#include "widgets/handout/worked_lines.h"

#include "lessons/scene/evaluation.h"
#include "lessons/term/plain_text.h"
#include "widgets/formula/term_formula.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Room for a number that is written by hand.
constexpr math::Room roomToWrite{5, 1, 0.35};

math::Row wholeRow(const WorkingLine &line) {
  math::Row row;
  for (const LinePiece piece : linePieces)
    row = math::row(std::move(row), formulaOf(line, piece).row);
  return row;
}

math::Row rowWithGap(const WorkingLine &line, const Gap &gap) {
  math::Row row;
  for (const LinePiece piece : linePieces)
    row = math::row(std::move(row), formulaOf(line, piece, gap, roomToWrite).row);
  return row;
}

class LineBlocks {
public:
  LineBlocks(const LinesInWorking &lines, const Fade &fade, const FormulaSetting &setting)
      : m_lines(lines), m_fade(fade), m_setting(setting) {}

  HandoutBlocks make() {
    const bool hasNames = hasSeveralEntries();
    for (std::size_t i = m_lines.begin; i < m_lines.end; ++i) {
      if (hasNames && beginsEntry(i))
        m_blocks.push_back(
            {ParagraphBlock{inlineText(entryAt(i), {.emphasized = true}), TextSize::Small}, true});
      add(m_lines.working.lines[i]);
    }
    return std::move(m_blocks);
  }

private:
  [[nodiscard]] std::string entryAt(std::size_t line) const {
    return entryOf(m_lines.working.lines[line].id);
  }
  [[nodiscard]] bool beginsEntry(std::size_t line) const {
    return line == m_lines.begin || entryAt(line) != entryAt(line - 1);
  }
  [[nodiscard]] bool hasSeveralEntries() const {
    for (std::size_t i = m_lines.begin + 1; i < m_lines.end; ++i)
      if (beginsEntry(i))
        return true;
    return false;
  }

  void add(const WorkingLine &line) {
    if (const auto gap = m_fade.gaps.find(line.id); gap != m_fade.gaps.end())
      return addWithGap(asDemand(line), gap->second);
    if (m_fade.waiting.contains(line.id)) {
      const WorkingLine waiting = asDemand(line);
      return addFormula(waitingFormulaOf(waiting), waitingText(waiting));
    }
    addFormula(wholeRow(line), plainText(line));
    if (line.sentence.empty())
      return;
    m_blocks.back().keepsWithNext = true;
    m_blocks.push_back({ParagraphBlock{inlineText(line.sentence)}});
  }

  void addWithGap(const WorkingLine &line, const Gap &gap) {
    addFormula(rowWithGap(line, gap), questionText(line, gap));
    const std::vector<Chain> told = toldFor(line, gap, m_lines.working);
    if (told.empty())
      return;
    std::string plain;
    for (const Chain &chain : told)
      plain += (plain.empty() ? "" : ", ") + plainText(chain);
    m_blocks.back().keepsWithNext = true;
    addFormula(formulaOf(told), plain);
  }

  void addFormula(const math::Row &row, std::string plain) {
    m_blocks.push_back({FormulaBlock{inlineFormula(row, std::move(plain), m_setting)}});
  }

  const LinesInWorking &m_lines;
  const Fade &m_fade;
  const FormulaSetting &m_setting;
  HandoutBlocks m_blocks;
};

} // namespace

HandoutBlocks workedLines(const LinesInWorking &lines, const Fade &fade, const FormulaSetting &setting) {
  return LineBlocks(lines, fade, setting).make();
}

} // namespace halfspace
