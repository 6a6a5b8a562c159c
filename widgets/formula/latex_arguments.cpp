#include "widgets/formula/latex_arguments.h"

#include "lessons/words.h"
#include "widgets/formula/latex_symbols.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace halfspace::math {
namespace {

/// How long lengths may be that a formula asks for, in em: more is no formula.
constexpr double longestLength = 100;

struct Unit {
  std::string_view name;
  double em;
};
/// For a type of 10 pt, as TeX's own.
constexpr std::array<Unit, 8> units{{{"em", 1},
                                     {"ex", 0.431},
                                     {"mu", 1.0 / 18},
                                     {"pt", 0.1},
                                     {"px", 0.1},
                                     {"cm", 2.845},
                                     {"mm", 0.2845},
                                     {"in", 7.227}}};

struct NamedColor {
  std::string_view name;
  Color color;
};
/// LaTeX's (package xcolor).
constexpr std::array<NamedColor, 19> namedColors{{{"black", {0, 0, 0}},
                                                  {"blue", {0, 0, 255}},
                                                  {"brown", {191, 128, 64}},
                                                  {"cyan", {0, 255, 255}},
                                                  {"darkgray", {64, 64, 64}},
                                                  {"gray", {128, 128, 128}},
                                                  {"green", {0, 255, 0}},
                                                  {"lightgray", {191, 191, 191}},
                                                  {"lime", {191, 255, 0}},
                                                  {"magenta", {255, 0, 255}},
                                                  {"olive", {128, 128, 0}},
                                                  {"orange", {255, 128, 0}},
                                                  {"pink", {255, 191, 191}},
                                                  {"purple", {191, 0, 64}},
                                                  {"red", {255, 0, 0}},
                                                  {"teal", {0, 128, 128}},
                                                  {"violet", {128, 0, 128}},
                                                  {"white", {255, 255, 255}},
                                                  {"yellow", {255, 255, 0}}}};

/// `#rrggbb`
std::optional<Color> hexColor(std::string_view text) {
  constexpr std::size_t digits = 6;
  if (!text.starts_with('#') || text.size() != digits + 1)
    return std::nullopt;
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  const auto byte = [value](unsigned shift) { return static_cast<std::uint8_t>((value >> shift) & 0xFFU); };
  return Color{byte(16), byte(8), byte(0)};
}

} // namespace

std::string readName(TokenStream &tokens, std::size_t column) {
  const Token here = tokens.peekMath();
  if (!here.is('{'))
    throw ReadError{column, halfspace::words("A `{` is missing behind this command.")};
  std::string name;
  for (const Token &token : tokens.takeBetween('{', '}'))
    name += sourceOf(token);
  return name;
}

double lengthOf(const std::string &text, std::size_t column) {
  const std::size_t begin = text.find_first_not_of(" +");
  const std::string_view trimmed = begin == std::string::npos ? "" : std::string_view(text).substr(begin);
  double number = 0;
  const auto [end, error] = std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), number);
  std::string_view unit = trimmed.substr(static_cast<std::size_t>(end - trimmed.data()));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  unit = unit.substr(0, unit.find(' '));
  const auto found =
      std::find_if(units.begin(), units.end(), [unit](const Unit &each) { return each.name == unit; });
  if (error != std::errc() || found == units.end() || !(std::abs(number * found->em) <= longestLength))
    throw ReadError{column,
                    halfspace::words("`{text}` is no length: write it as `2em` or `5pt`.", {{"text", text}})};
  return number * found->em;
}

double readLength(TokenStream &tokens, std::size_t column) {
  return lengthOf(readName(tokens, column), column);
}

std::string readBareLength(TokenStream &tokens) {
  constexpr std::size_t unitLetters = 2;
  constexpr std::size_t longest = 32;
  std::string text;
  for (std::size_t letters = 0; letters < unitLetters && text.size() < longest;) {
    const Token &token = tokens.peekMath();
    if (token.kind != Token::Kind::Character || token.is('{') || token.is('}'))
      break;
    letters += isAsciiLetter(token.character) ? 1U : 0U;
    text += sourceOf(tokens.take());
  }
  return text;
}

char32_t readFence(TokenStream &tokens, std::size_t column) {
  const Token token = tokens.takeMath();
  if (token.isEnd())
    throw ReadError{column, halfspace::words("A bracket is missing behind this command.")};
  if (token.is('.'))
    return 0;
  char32_t fence = token.is('<') ? U'⟨' : token.is('>') ? U'⟩' : token.character;
  if (token.is('{') || token.is('}'))
    fence = 0;
  if (const SymbolCommand *found = token.kind == Token::Kind::Command ? symbolNamed(token.name) : nullptr)
    fence = found->character;
  if (!isFence(fence))
    throw ReadError{token.column,
                    halfspace::words("`{command}` is no bracket.", {{"command", sourceOf(token)}})};
  return fence;
}

Color readColorValue(TokenStream &tokens, std::size_t column) {
  const std::string name = readName(tokens, column);
  if (const auto color = hexColor(name))
    return *color;
  const auto found = std::find_if(namedColors.begin(), namedColors.end(),
                                  [&name](const NamedColor &each) { return each.name == name; });
  if (found == namedColors.end())
    throw ReadError{column, halfspace::words("The colour `{colour}` is unknown: write it as `#rrggbb`.",
                                             {{"colour", name}})};
  return found->color;
}

} // namespace halfspace::math
