// The steps between a formula and its result, written once for all of them. None changes what a term comes
// to.
#pragma once

#include "lessons/term/term.h"

namespace halfspace {

/// The term as a number, a list of numbers, or, where unknowns are left, collected by them: 9t + 30, and
/// in lists (11 − t, 15 + 3t, 8 + 2t), as they count from a start. Each number remembers the term that it
/// came from. A term that comes to nothing stays as it is.
[[nodiscard]] Term calculated(const Term &term);

/// factor·term with the factor calculated and its sign in front: −(2/3) v.
[[nodiscard]] Term multipleOf(const Term &factor, const Term &term);

/// Numbers for all names, and nothing calculated: n·(Q − P₀) as (1, 2, 2)·((11, 15, 8) − (5, 4, 7)).
[[nodiscard]] Term namesPutIn(const Term &term);

/// The numbers that the formula is made of: names, products of vectors and norms are calculated, while sums,
/// products, fractions, powers and the outermost operation stand. f(Q)/|n| as 30/3, n·(Q − P₀) as
/// (1, 2, 2)·(6, 11, 1).
[[nodiscard]] Term numbersPutIn(const Term &term);

/// Numbers for all names, and products of vectors coordinate by coordinate: u·v as 1·4 + 2·5 + 3·6, u×v as
/// (2·6 − 3·5, 3·4 − 1·6, 1·5 − 2·4); determinants along their first column.
[[nodiscard]] Term multipliedOut(const Term &term);

/// Multiples of sums summand by summand, without those that are 0: 1(11 − t) + 2(15 + 3t) + 0(8 + 2t) as
/// 11 − t + 30 + 6t.
[[nodiscard]] Term distributed(const Term &term);

/// The numbers of a determinant: |a b c| with a column of numbers for each of the vectors, which has the
/// vector's mark.
[[nodiscard]] Term columnsPutIn(const Term &determinant);

/// A determinant of two rows and more by one of its columns: each of its numbers times what is left without
/// its row and column, with alternating signs. 1|4 6; 7 9| − 2|…| + 3|…|.
[[nodiscard]] Term expandedAlong(const Term &determinant, std::size_t column);

} // namespace halfspace
