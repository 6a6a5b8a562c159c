// The numbers of a table of fragments, set in type.
#pragma once

#include "widgets/hit_table/fragment_rows.h"
#include "widgets/typeset/typesetter.h"

#include <array>

namespace halfspace {

/// Writes the three columns of numbers, each of them in one way: where one number would be too long, written
/// exactly, all are rounded, and the head says so.
class FragmentNumbers {
public:
  using OfRow = std::array<Typesetter::Picture, 3>; ///< null where there is none

  /// The typesetter must outlive it.
  explicit FragmentNumbers(const Typesetter &typesetter);

  void write(const FragmentRows &shown, LiveValues values);

  [[nodiscard]] const OfRow &ofRow(std::size_t row) const { return m_rows.at(row); }
  /// λ, s and t; with ≈ above rounded numbers.
  [[nodiscard]] const MathPicture &head(std::size_t column) const;
  /// Of a number as wide as they get, in em.
  [[nodiscard]] double greatestWidth() const { return m_widest->width(); }

private:
  void writeColumn(std::size_t column, const FragmentRows &shown, LiveValues values);
  /// What stands in the place of a row's numbers.
  [[nodiscard]] Typesetter::Picture placeholderOf(const FragmentRow &row, LiveValues values) const;

  const Typesetter &m_typesetter;
  std::vector<OfRow> m_rows;
  std::array<bool, 3> m_areRounded{}; ///< the columns
  OfRow m_heads;
  OfRow m_roundedHeads;
  Typesetter::Picture m_unknown;
  Typesetter::Picture m_none; ///< where the plane is not crossed in a point
  Typesetter::Picture m_widest;
};

} // namespace halfspace
