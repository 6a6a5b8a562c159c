// The mistakes that a formula invites, found by calculating it wrongly.
#pragma once

#include "lessons/construction/working.h"

namespace halfspace {

/// What the last symbolic side of the chain comes to when one thing is done wrongly: a difference the wrong
/// way round, a part left out, a fraction upside down or not divided, a root or a division by a length
/// forgotten, a part subtracted that is to be added, a minus sign lost, one name taken for another. The
/// likeliest first; some may come to the right answer, or to nothing.
[[nodiscard]] std::vector<WrongTerm> usualMistakes(const Chain &chain);

} // namespace halfspace
