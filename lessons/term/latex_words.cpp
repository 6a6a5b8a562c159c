#include "lessons/term/latex_words.h"

#include "lessons/term/greek.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

struct TextLatex {
  std::string_view text;
  std::string_view latex;
};

/// What a sentence of ours may hold that LaTeX reads otherwise, or that pdflatex does not know.
constexpr std::array textCharacters{TextLatex{"\\", "\\textbackslash{}"},
                                    TextLatex{"^", "\\^{}"},
                                    TextLatex{"~", "\\~{}"},
                                    TextLatex{"&", "\\&"},
                                    TextLatex{"%", "\\%"},
                                    TextLatex{"$", "\\$"},
                                    TextLatex{"#", "\\#"},
                                    TextLatex{"_", "\\_"},
                                    TextLatex{"{", "\\{"},
                                    TextLatex{"}", "\\}"},
                                    TextLatex{"−", "$-$"},
                                    TextLatex{"·", "$\\cdot$"},
                                    TextLatex{"×", "$\\times$"},
                                    TextLatex{"⊥", "$^{\\perp}$"},
                                    TextLatex{"√", "$\\surd$"},
                                    TextLatex{"≈", "$\\approx$"},
                                    TextLatex{"≠", "$\\neq$"},
                                    TextLatex{"≤", "$\\leq$"},
                                    TextLatex{"≥", "$\\geq$"},
                                    TextLatex{"°", "$^{\\circ}$"},
                                    TextLatex{"∈", "$\\in$"},
                                    TextLatex{"⇒", "$\\Rightarrow$"},
                                    TextLatex{"→", "$\\to$"},
                                    TextLatex{"′", "$^{\\prime}$"},
                                    TextLatex{"₀", "$_{0}$"},
                                    TextLatex{"₁", "$_{1}$"},
                                    TextLatex{"₂", "$_{2}$"},
                                    TextLatex{"₃", "$_{3}$"},
                                    TextLatex{"⁰", "$^{0}$"},
                                    TextLatex{"¹", "$^{1}$"},
                                    TextLatex{"²", "$^{2}$"},
                                    TextLatex{"³", "$^{3}$"},
                                    TextLatex{"⁴", "$^{4}$"},
                                    TextLatex{"⁵", "$^{5}$"},
                                    TextLatex{"⁶", "$^{6}$"},
                                    TextLatex{"⁷", "$^{7}$"},
                                    TextLatex{"⁸", "$^{8}$"},
                                    TextLatex{"⁹", "$^{9}$"},
                                    TextLatex{"⁻", "$^{-}$"}};

/// Whether pdflatex can set a character that is not in the table: Latin letters (some of them in the T1
/// encoding alone) and the usual punctuation.
bool isKnownToPdflatex(std::string_view character) {
  constexpr std::string_view firstOther = "\u0180";
  constexpr std::string_view firstPunctuation = "\u2013";
  constexpr std::string_view lastPunctuation = "\u2026";
  // Bytes in UTF-8 are in the order of the characters.
  return character < firstOther || (character >= firstPunctuation && character <= lastPunctuation);
}

} // namespace

std::string latexWords(std::string_view text) {
  std::string latex;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, lengthOfFirst(text));
    const auto known = std::find_if(textCharacters.begin(), textCharacters.end(),
                                    [&](const TextLatex &each) { return each.text == character; });
    if (known != textCharacters.end())
      latex += known->latex;
    else if (const GreekLetter *greek = greekLetter(character))
      latex += "$\\" + std::string(greek->latex) + "$";
    else
      latex += isKnownToPdflatex(character) ? character : "?";
    text.remove_prefix(character.size());
  }
  return latex;
}

} // namespace halfspace
