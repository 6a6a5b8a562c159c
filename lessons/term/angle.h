// Angles in degrees, from their cosines.
#pragma once

#include "lessons/term/written.h"

namespace halfspace {

/// The angle from 0° to 180° whose cosine is this number, in degrees: exact where it is a whole number of
/// degrees, else rounded as among words. Of the cosines A + B·√n only those of multiples of 30°, 36° and 45°
/// belong to such angles (Niven's theorem and its like for square roots). Requires a term that is a number
/// from −1 to 1.
[[nodiscard]] WrittenNumber degreesOf(const Term &cosine);

} // namespace halfspace
