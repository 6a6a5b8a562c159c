// Terms as sentences have them.
#pragma once

#include "lessons/term/term.h"

namespace halfspace {

/// The same with rounded numbers of `digitsAmongWords` digits: ≈ 0.6509.
[[nodiscard]] Term amongWords(const Term &term);

} // namespace halfspace
