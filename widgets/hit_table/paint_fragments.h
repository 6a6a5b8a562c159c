// A table of fragments on a painter.
#pragma once

#include "widgets/hit_table/fragment_columns.h"
#include "widgets/hit_table/fragment_numbers.h"

#include <QFont>

namespace halfspace {

/// What the columns need for these names and for all verdicts, in words of a font; `widestNumber` is in em.
[[nodiscard]] FragmentNeeds needsOf(const QStringList &names, const QFont &words, double widestNumber);

/// What is painted; all that it refers to must outlive it.
struct PaintedFragments {
  const FragmentRows &shown;
  LiveValues values;
  const FragmentNumbers &numbers;
  const MathPicture &start; ///< the letter at the rule where the ray begins
  const Theme &theme;
  std::size_t chosen;
  std::size_t hovered;
  bool hasFocus;
};

/// The head, the rows and the last line, in words of the painter's font.
void paintFragments(QPainter &painter, const PaintedFragments &fragments, const FragmentColumns &columns);

} // namespace halfspace
