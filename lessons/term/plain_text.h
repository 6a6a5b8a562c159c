// Terms as one line of plain text: t = ((P₀ − Q)·n)/(r·n) = −30/9.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/notation.h"

#include <string>

namespace halfspace {

[[nodiscard]] std::string plainText(const Term &term, Notation notation = {});
[[nodiscard]] std::string plainText(const Chain &chain, Notation notation = {});
[[nodiscard]] std::string plainText(const Symbol &symbol);

} // namespace halfspace
