// Determinants by one of their columns.
#pragma once

#include "lessons/construction/working.h"

namespace halfspace {

/// D = |a b c| with the numbers of three vectors, and then the numbers of one of these columns, counted from
/// 0, each times what is left without its row and column.
[[nodiscard]] WorkingLine expansionLine(const Term &letter, const std::vector<Term> &vectors,
                                        std::size_t column, std::string sentence);

} // namespace halfspace
