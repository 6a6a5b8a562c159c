// What terms look like, whatever the notation: which are tall, which are numbers, which are more than one
// piece.
#pragma once

#include "lessons/term/term.h"

#include <vector>

namespace halfspace {

/// A number as the term of digits that is written for it.
[[nodiscard]] const Term &shown(const Term &term);

/// Whether it is more than a number or a name, with or without a minus.
[[nodiscard]] bool isCompound(const Term &term);

/// Whether parentheses around it should stretch.
[[nodiscard]] bool isTall(const Term &term);

/// Whether nothing in it is higher than a fraction of digits: (−7/9)·(−2) − 28/9.
[[nodiscard]] bool isAsHighAsNumbers(const Term &term);

/// 3, −10/3.
[[nodiscard]] bool isWrittenInDigits(const Term &term);

/// A number, or the digits of one.
[[nodiscard]] bool isNumeral(const Term &term);

/// Whether a number is written in digits without a decimal mark.
[[nodiscard]] bool isInteger(const Term &number);

/// A number, or calculated from numbers alone without a vector.
[[nodiscard]] bool isNumeric(const Term &term);

/// A factor that is rounded to 1 says nothing before an unknown.
[[nodiscard]] bool isRoundedOne(const Term &factor);

/// √5 or 4√5, which need no parentheses before a slash.
[[nodiscard]] bool isOfRoots(const Term &term);

/// cos θ, where all that follows would seem to belong to the angle.
[[nodiscard]] bool isWordBeforeName(const Term &term);

/// max(a, b): the list has the parentheses.
[[nodiscard]] bool isOfList(const Term &application);

/// Whether an unknown stands among the summands, alone or with a coefficient.
[[nodiscard]] bool hasUnknown(const std::vector<Term> &summands);

/// 2·10³, (1/2)·3: numbers stand with a dot between them.
[[nodiscard]] bool standDotted(const Term &left, const Term &right);

} // namespace halfspace
