// The Greek letters, and ∞, as every notation writes them.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace {

struct GreekLetter {
  std::string_view letter; ///< in UTF-8
  const char *name;        ///< in English: lambda
  std::string_view latex;  ///< the command without its backslash
  /// Whether files may spell it out where they name something.
  bool isSpelled = false;
};

inline constexpr std::array greekLetters{GreekLetter{"α", "alpha", "alpha", true},
                                         GreekLetter{"β", "beta", "beta", true},
                                         GreekLetter{"γ", "gamma", "gamma", true},
                                         GreekLetter{"δ", "delta", "delta", true},
                                         GreekLetter{"ε", "epsilon", "varepsilon", true},
                                         GreekLetter{"ζ", "zeta", "zeta"},
                                         GreekLetter{"η", "eta", "eta"},
                                         GreekLetter{"θ", "theta", "theta", true},
                                         GreekLetter{"ι", "iota", "iota"},
                                         GreekLetter{"κ", "kappa", "kappa"},
                                         GreekLetter{"λ", "lambda", "lambda", true},
                                         GreekLetter{"μ", "mu", "mu", true},
                                         GreekLetter{"ν", "nu", "nu"},
                                         GreekLetter{"ξ", "xi", "xi"},
                                         GreekLetter{"π", "pi", "pi"},
                                         GreekLetter{"ρ", "rho", "rho", true},
                                         GreekLetter{"σ", "sigma", "sigma", true},
                                         GreekLetter{"τ", "tau", "tau", true},
                                         GreekLetter{"φ", "phi", "varphi", true},
                                         GreekLetter{"χ", "chi", "chi"},
                                         GreekLetter{"ψ", "psi", "psi"},
                                         GreekLetter{"ω", "omega", "omega", true},
                                         GreekLetter{"Γ", "Gamma", "Gamma"},
                                         GreekLetter{"Δ", "Delta", "Delta"},
                                         GreekLetter{"Θ", "Theta", "Theta"},
                                         GreekLetter{"Λ", "Lambda", "Lambda"},
                                         GreekLetter{"Π", "Pi", "Pi"},
                                         GreekLetter{"Σ", "Sigma", "Sigma"},
                                         GreekLetter{"Φ", "Phi", "Phi"},
                                         GreekLetter{"Ψ", "Psi", "Psi"},
                                         GreekLetter{"Ω", "Omega", "Omega"},
                                         GreekLetter{"∞", "infinity", "infty"}};

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
