// The Greek letters, and ∞, as every notation writes them.
#pragma once

#include "lessons/sentence.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace {

struct GreekLetter {
  std::string_view letter; ///< in UTF-8
  Sentence name;           ///< as it is spoken: lambda
  std::string_view latex;  ///< the command without its backslash
  /// Whether files may spell it out where they name something.
  bool isSpelled = false;
};

inline constexpr std::array greekLetters{GreekLetter{"α", says("alpha"), "alpha", true},
                                         GreekLetter{"β", says("beta"), "beta", true},
                                         GreekLetter{"γ", says("gamma"), "gamma", true},
                                         GreekLetter{"δ", says("delta"), "delta", true},
                                         GreekLetter{"ε", says("epsilon"), "varepsilon", true},
                                         GreekLetter{"ζ", says("zeta"), "zeta"},
                                         GreekLetter{"η", says("eta"), "eta"},
                                         GreekLetter{"θ", says("theta"), "theta", true},
                                         GreekLetter{"ι", says("iota"), "iota"},
                                         GreekLetter{"κ", says("kappa"), "kappa"},
                                         GreekLetter{"λ", says("lambda"), "lambda", true},
                                         GreekLetter{"μ", says("mu"), "mu", true},
                                         GreekLetter{"ν", says("nu"), "nu"},
                                         GreekLetter{"ξ", says("xi"), "xi"},
                                         GreekLetter{"π", says("pi"), "pi"},
                                         GreekLetter{"ρ", says("rho"), "rho", true},
                                         GreekLetter{"σ", says("sigma"), "sigma", true},
                                         GreekLetter{"τ", says("tau"), "tau", true},
                                         GreekLetter{"φ", says("phi"), "varphi", true},
                                         GreekLetter{"χ", says("chi"), "chi"},
                                         GreekLetter{"ψ", says("psi"), "psi"},
                                         GreekLetter{"ω", says("omega"), "omega", true},
                                         GreekLetter{"Γ", says("Gamma"), "Gamma"},
                                         GreekLetter{"Δ", says("Delta"), "Delta"},
                                         GreekLetter{"Θ", says("Theta"), "Theta"},
                                         GreekLetter{"Λ", says("Lambda"), "Lambda"},
                                         GreekLetter{"Π", says("Pi"), "Pi"},
                                         GreekLetter{"Σ", says("Sigma"), "Sigma"},
                                         GreekLetter{"Φ", says("Phi"), "Phi"},
                                         GreekLetter{"Ψ", says("Psi"), "Psi"},
                                         GreekLetter{"Ω", says("Omega"), "Omega"},
                                         GreekLetter{"∞", says("infinity"), "infty"}};

/// The one for which something holds; null where there is none.
template <class Condition> [[nodiscard]] constexpr const GreekLetter *greekWhere(const Condition &isSo) {
  const auto found = std::find_if(greekLetters.begin(), greekLetters.end(), isSo);
  return found == greekLetters.end() ? nullptr : &*found;
}
[[nodiscard]] constexpr const GreekLetter *greekLetter(std::string_view letter) {
  return greekWhere([letter](const GreekLetter &each) { return each.letter == letter; });
}
/// By its LaTeX command, without the backslash.
[[nodiscard]] constexpr const GreekLetter *greekCommand(std::string_view command) {
  return greekWhere([command](const GreekLetter &each) { return each.latex == command; });
}

} // namespace halfspace
