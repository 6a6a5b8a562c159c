#include "widgets/working/typeset_lines.h"

#include "widgets/formula/term_formula.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

Typesetter::Picture pictureOf(const Typesetter &typesetter, const math::Row &formula) {
  return formula.empty() ? nullptr : typesetter.picture(formula);
}

void setPiece(const Typesetter &typesetter, TypesetLine &line, LinePiece piece, TraceableFormula formula) {
  const auto index = static_cast<std::size_t>(piece);
  line.pieces[index] = pictureOf(typesetter, formula.row);
  line.numbers[index] = std::move(formula.numbers);
}

/// What can be taken from before is; `before` may be null.
TypesetLine typesetWhole(const Typesetter &typesetter, const WorkingLine &line, const TypesetLine *before) {
  TypesetLine typeset{line};
  for (const LinePiece piece : linePieces) {
    const auto index = static_cast<std::size_t>(piece);
    if (before && areInterchangeable(before->source, line, piece)) {
      typeset.pieces[index] = before->pieces[index];
      typeset.numbers[index] = before->numbers[index];
    } else {
      setPiece(typesetter, typeset, piece, formulaOf(line, piece));
    }
  }
  return typeset;
}

/// It waits with its numbers.
TypesetLine typesetSymbols(const Typesetter &typesetter, const WorkingLine &line) {
  TypesetLine typeset{line};
  typeset.isPartial = true;
  typeset.pieces[0] = pictureOf(typesetter, waitingFormulaOf(line));
  return typeset;
}

TypesetLine typesetWithGap(const Typesetter &typesetter, const WorkingLine &line, const Gap &gap,
                           const math::Room &room, const std::vector<Chain> &told) {
  TypesetLine typeset{line};
  typeset.isPartial = true;
  for (const LinePiece piece : linePieces)
    setPiece(typesetter, typeset, piece, formulaOf(line, piece, gap, room));
  typeset.told = pictureOf(typesetter, formulaOf(told));
  return typeset;
}

} // namespace

std::vector<TypesetLine> typesetLines(const Typesetter &typesetter, const ShownLines &shown,
                                      const std::function<math::Room(const std::string &lineId)> &roomOfGap,
                                      const std::vector<TypesetLine> &before) {
  const auto wholeBefore = [&](const std::string &id) -> const TypesetLine * {
    const auto found = std::find_if(before.begin(), before.end(),
                                    [&](const TypesetLine &each) { return each.source.id == id; });
    return found == before.end() || found->isPartial ? nullptr : &*found;
  };
  std::vector<TypesetLine> lines;
  for (const WorkingLine &line : shown.lines()) {
    if (const Gap *gap = shown.gapOf(line.id))
      lines.push_back(typesetWithGap(typesetter, line, *gap, roomOfGap(line.id), shown.toldFor(line, *gap)));
    else if (shown.hides(line.id))
      lines.push_back(typesetSymbols(typesetter, line));
    else
      lines.push_back(typesetWhole(typesetter, line, wholeBefore(line.id)));
  }
  return lines;
}

} // namespace halfspace
