#include "widgets/formula/set_formula.h"

#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/formula/lay_out.h"

namespace halfspace::math {
namespace {

/// Of a source that is no formula, so many characters are shown.
constexpr std::size_t longestSource = 60;

/// A text on one line, without spaces at its ends, and cut off where it is long.
std::string onOneLine(std::string_view text) {
  std::string line;
  std::size_t characters = 0;
  for (text = trimmed(text); !text.empty() && characters < longestSource; ++characters) {
    const std::string_view rest = trimmed(text);
    const auto spaces = static_cast<std::size_t>(rest.data() - text.data());
    const std::size_t length = spaces > 0 ? spaces : lengthOfFirst(text);
    line += spaces > 0 ? " " : text.substr(0, length);
    text.remove_prefix(length);
  }
  return printable(text.empty() ? line : line + "…");
}

Layout setSource(std::string_view source, const MathFonts &fonts) {
  return layOut(Row{words(onOneLine(source), Alphabet::Mono)}, fonts);
}

SetFormula setOrShow(const Row &formula, std::string_view source, const MathFonts &fonts) {
  Layout layout = layOut(formula, fonts);
  const bool fits = layout.width < largestFormula && layout.ascent + layout.depth < largestFormula;
  if (fits) // said this way round, so that a size that is no number does not pass
    return {std::move(layout)};
  return {setSource(source, fonts), halfspace::words("The formula is too large.")};
}

} // namespace

SetFormula setLatex(std::string_view latex, const MathFonts &fonts, const Macros &macros) {
  const auto read = readLatex(latex, macros);
  if (const auto *formula = std::get_if<Row>(&read))
    return setOrShow(*formula, latex, fonts);
  const auto &error = std::get<ReadError>(read);
  return {setSource(latex, fonts), error.sentence, error.column};
}

SetFormula setFormula(const Row &formula, const MathFonts &fonts) { return setOrShow(formula, "…", fonts); }

} // namespace halfspace::math
