// What the atoms of a row are to each other: which signs combine, which bars open, where a line can be
// broken.
#pragma once

#include "widgets/formula/layout.h"

#include <optional>
#include <vector>

namespace halfspace::math {

struct RowAtom {
  const Node *node = nullptr;
  AtomClass atomClass = AtomClass::Ord;
  int nesting = 0; ///< 1: opens a parenthesis, −1: closes one
};

/// TeX's rules 5 and 6: a sign with nothing to combine is an ordinary symbol. Beyond TeX, a bar where a term
/// is due opens, so that the sign in |−x| stands close. `before` is the class of what stands before the row.
void settle(std::vector<RowAtom> &atoms, std::optional<AtomClass> before);

/// Whether and how well a line can begin with an atom, inside so many parentheses, behind an atom of a class.
[[nodiscard]] Break breakBefore(const RowAtom &atom, int parentheses, std::optional<AtomClass> before);

} // namespace halfspace::math
