// Terms in words, to be read aloud: "t equals minus 30 over 9".
#pragma once

#include "lessons/term/chain.h"

#include <string>

namespace halfspace {

[[nodiscard]] std::string spoken(const Term &term);
[[nodiscard]] std::string spoken(const Chain &chain);

} // namespace halfspace
