// How a number is written for a learner.
#pragma once

#include "lessons/term/term.h"

#include <vector>

namespace halfspace {

struct WrittenNumber {
  /// A term of digits: −10/3 as the negation of a quotient, 5√2 as a product. A fraction has its sign in
  /// front.
  Term term;
  /// False: rounded to `shownDigits` significant digits, because the exact form is too long or unknown.
  bool exact = true;
};

/// Exact forms of more characters than this, not counting a sign in front and those of a root, are written
/// rounded.
inline constexpr std::size_t longestExactForm = 14;
inline constexpr int shownDigits = 6;
/// The same in sentences, where more would be read and forgotten: ≈ 0.6509.
inline constexpr int digitsAmongWords = 4;

/// Small fractions as such, others as decimals where those end; rounded where neither is short.
[[nodiscard]] WrittenNumber written(const Real &number);

/// The numbers of a list, one way for all of them: as they would stand alone where that is alike; else all as
/// decimals where every decimal ends, all as fractions where one does not, and all as rounded decimals where
/// one has to be rounded. Whole numbers go with all of these.
[[nodiscard]] std::vector<WrittenNumber> writtenAlike(const std::vector<Real> &numbers);

/// The value rounded to so many significant digits, as a term of digits; ∞ beyond all numbers. Digits before
/// the decimal point stay, up to `shownDigits`.
[[nodiscard]] Term rounded(double value, int most = shownDigits);

/// The number as `rounded` writes it; exact where nothing is lost.
[[nodiscard]] WrittenNumber decimalOf(const Surd &number, int most = shownDigits);

/// Whether some number in the term is written rounded.
[[nodiscard]] bool showsRounded(const Term &term);

} // namespace halfspace
