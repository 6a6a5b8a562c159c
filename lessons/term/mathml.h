// Terms as presentation MathML, for pages of the web.
#pragma once

#include "lessons/term/chain.h"

#include <string>

namespace halfspace {

/// A whole `<math>` element. A term that is a mark of the figure carries its id as `data-mark`.
[[nodiscard]] std::string mathMl(const Term &term);
[[nodiscard]] std::string mathMl(const Chain &chain);

} // namespace halfspace
