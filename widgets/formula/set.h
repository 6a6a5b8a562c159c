// The rooms of the layout: one function for each kind of atom. Each puts its shapes on the sheet and returns
// their box around an origin at the left end of the baseline.
#pragma once

#include "widgets/formula/math_tree.h"
#include "widgets/formula/sheet.h"

#include <optional>

namespace halfspace::math {

/// What a row is set for.
struct RowPlan {
  std::optional<AtomClass> before =
      std::nullopt;              ///< of what stands before the row, as if it were its first atom
  bool isOutermost = false;      ///< its atoms become the layout's pieces
  double *fenceHeight = nullptr; ///< the row is inside fences: how tall they are to be is written here
};

/// A row (lay_out_row.cpp). A single atom keeps its italics correction and stays a character.
[[nodiscard]] Box setRow(Sheet &sheet, const Row &row, SetStyle style, const RowPlan &plan = {});
/// A row as a whole: the italics correction is part of the width.
[[nodiscard]] Box setWhole(Sheet &sheet, const Row &row, SetStyle style);
/// One atom.
[[nodiscard]] Box setNode(Sheet &sheet, const Node &node, SetStyle style);

// By kind; kinds that only a row knows (tags, spaces …) come to nothing here.
[[nodiscard]] Box set(Sheet &sheet, const Symbol &symbol, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Words &words, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Group &group, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Tagged &tagged, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Colored &colored, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const StyleSwitch &styleSwitch, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Space &space, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Scripts &scripts, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Fraction &fraction, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Root &root, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Fenced &fenced, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const MiddleFence &middle, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const TallFence &fence, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Accent &accent, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Bar &bar, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Brace &brace, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Stack &stack, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const LongArrow &arrow, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Negated &negated, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Boxed &boxed, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Phantom &phantom, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Block &block, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Room &room, SetStyle style);
[[nodiscard]] Box set(Sheet &sheet, const Table &table, SetStyle style);

/// A fence as tall as asked for, centred on the axis; 0: a little room.
[[nodiscard]] Box setFence(Sheet &sheet, char32_t character, double height, SetStyle style);
/// A glyph, or several, at least `length` long. Vertical: standing on the baseline.
[[nodiscard]] Box setStretched(Sheet &sheet, GlyphId glyph, double length, Direction direction,
                               SetStyle style);
/// A base with limits above and below; null: none there.
[[nodiscard]] Box setLimits(Sheet &sheet, const Box &base, const Box *above, const Box *below,
                            SetStyle style);

} // namespace halfspace::math
