// Terms as one line of plain text: t = ((P₀ − Q)·n)/(r·n) = −30/9.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/written.h"

#include <string>

namespace halfspace {

[[nodiscard]] std::string plainText(const Term &term);
[[nodiscard]] std::string plainText(const Chain &chain);
/// The sides from `begin` on, each but the chain's first with the relation before it.
[[nodiscard]] std::string plainText(const Chain &chain, std::size_t begin, std::size_t end);
/// The whole chain with a question mark in place of a part of it.
[[nodiscard]] std::string plainTextWithout(const Term &part, const Chain &chain);
/// Whether a minus stands right before that question mark, which who fills it in is not to write once more.
[[nodiscard]] bool isBehindMinus(const Term &part, const Chain &chain);
[[nodiscard]] std::string plainText(const Symbol &symbol);

/// The value behind the relation that it allows: ` = 10`, ` ≈ 3.16228`.
[[nodiscard]] std::string relatedText(const Term &value);
[[nodiscard]] std::string relatedText(const WrittenNumber &number);

} // namespace halfspace
