// Terms as formulas to be laid out.
#pragma once

#include "lessons/lesson/live_values.h"
#include "lessons/lesson/practice.h"
#include "lessons/term/chain.h"
#include "lessons/term/fractions.h"
#include "widgets/formula/math_tree.h"

namespace halfspace {

/// A term that is a mark of the figure is tagged with the mark's id.
[[nodiscard]] math::Row formulaOf(const Term &term, Fractions fractions = Fractions::Stacked);

/// The value behind the relation that it allows: = 10, ≈ 3.16228.
[[nodiscard]] math::Row relatedFormula(const Term &value, Fractions fractions = Fractions::Stacked);

/// 10, or ≈ 3.142, or √2 ≈ 1.414.
[[nodiscard]] math::Row formulaOf(const LiveNumber &number);

[[nodiscard]] math::Row formulaOf(const Symbol &symbol);

/// A formula with the numbers of which it can be asked where they come from: each is tagged with its index.
struct TraceableFormula {
  math::Row row;
  std::vector<Term> numbers{};
};

/// A piece of a worked line; empty where the line has no such piece.
[[nodiscard]] TraceableFormula formulaOf(const WorkingLine &line, LinePiece piece);

/// The same with room for a field in place of what is left out: of a result, behind the symbols.
[[nodiscard]] TraceableFormula formulaOf(const WorkingLine &line, LinePiece piece, const Gap &gap,
                                         const math::Room &room);

/// Statements, or parts of them, parted by commas; empty for none.
[[nodiscard]] math::Row formulaOf(const std::vector<Chain> &statements);
[[nodiscard]] math::Row formulaOf(const std::vector<ChainPart> &parts);

/// See waitingText.
[[nodiscard]] math::Row waitingFormulaOf(const WorkingLine &line);

} // namespace halfspace
