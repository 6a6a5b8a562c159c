// Primes behind letters: v′, what becomes of v. A letter's prime stands in its text; only formulas set it
// apart, as a script.
#pragma once

#include "lessons/term/term.h"

namespace halfspace {

inline constexpr std::string_view primeSign = "′";

[[nodiscard]] inline bool isPrimed(std::string_view letter) { return letter.ends_with(primeSign); }

/// The letter without its prime.
[[nodiscard]] inline std::string withoutPrime(std::string_view letter) {
  return std::string(letter.substr(0, letter.size() - (isPrimed(letter) ? primeSign.size() : 0)));
}

/// v′ for v, with all else that the symbol has.
[[nodiscard]] inline Symbol primed(Symbol symbol) {
  symbol.letter += primeSign;
  return symbol;
}

} // namespace halfspace
