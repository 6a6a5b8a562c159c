#include "lessons/words.h"
#include "widgets/formula/latex_symbols.h"
#include "widgets/formula/nesting.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

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

bool isTagCharacter(char c) {
  return isAsciiLetter(static_cast<unsigned char>(c)) || isAsciiDigit(static_cast<unsigned char>(c)) ||
         c == '.' || c == '-' || c == '_';
}

/// No width, and as tall as a line of text.
Node strut() { return {Phantom{row(symbol('(')), false, false, true}}; }

/// Whether a command stands between two terms as an operation or relation does, so that `\dots` before it are
/// those on the axis.
bool isBetweenTerms(const Token &token) {
  AtomClass atomClass = AtomClass::Ord;
  if (token.kind == Token::Kind::Character)
    atomClass = typedSymbol(token.character).atomClass;
  else if (const SymbolCommand *found =
               token.kind == Token::Kind::Command ? symbolNamed(token.name) : nullptr)
    atomClass = found->atomClass;
  return atomClass == AtomClass::Bin || atomClass == AtomClass::Rel;
}

} // namespace

std::string LatexReader::readName() {
  const Token here = m_tokens.peekMath();
  if (!here.is('{'))
    throw ReadError{m_column, halfspace::words("A `{` is missing behind this command.")};
  std::string name;
  for (const Token &token : m_tokens.takeBetween('{', '}'))
    name += sourceOf(token);
  return name;
}

double LatexReader::lengthOf(const std::string &text, std::size_t column) const {
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

/// A length without braces: up to the two letters of its unit.
std::string LatexReader::readBareLength() {
  constexpr std::size_t unitLetters = 2;
  constexpr std::size_t longest = 32;
  std::string text;
  for (std::size_t letters = 0; letters < unitLetters && text.size() < longest;) {
    const Token &token = m_tokens.peekMath();
    if (token.kind != Token::Kind::Character || token.is('{') || token.is('}'))
      break;
    letters += isAsciiLetter(token.character) ? 1U : 0U;
    text += sourceOf(m_tokens.take());
  }
  return text;
}

char32_t LatexReader::readFence() {
  const std::size_t column = m_column;
  const Token token = m_tokens.takeMath();
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

void LatexReader::readLetter(Row &row, const Command &command) {
  add(row, symbol(inCurrentAlphabet(command.character)));
}

void LatexReader::readLargeOperator(Row &row, const Command &command) {
  add(row, largeOperator(command.character, command.scriptPlace));
}

void LatexReader::readFunction(Row &row, const Command &command) {
  Node name = function(std::string(command.text.empty() ? command.name : command.text), command.scriptPlace);
  name.atomClass = command.atomClass;
  add(row, std::move(name));
}

void LatexReader::readDots(Row &row, const Command &command) {
  constexpr char32_t dotOnAxis = U'⋅';
  constexpr int dotCount = 3;
  const bool isPlain = command.character == 0; // \dots, which look at what follows
  const char32_t dot = isPlain ? (isBetweenTerms(m_tokens.peekMath()) ? dotOnAxis : U'.') : command.character;
  // TeX's dots stand further apart than those of one character.
  Row dots;
  for (int i = 0; i < dotCount; ++i)
    add(dots, symbol(dot, AtomClass::Punct));
  add(row, {Group{std::move(dots)}, AtomClass::Inner});
}

void LatexReader::readDiagonalDots(Row &row, const Command & /*command*/) {
  add(row, symbol(U'⋱', AtomClass::Inner));
}

void LatexReader::readAlphabet(Row &row, const Command &command) {
  const auto around = std::exchange(m_alphabet, command.alphabet);
  Row content = readArgument();
  m_alphabet = around;
  if (content.size() == 1)
    row.push_back(std::move(content.front()));
  else
    add(row, group(std::move(content)));
}

void LatexReader::readAlphabetSwitch(Row & /*row*/, const Command &command) { m_alphabet = command.alphabet; }

void LatexReader::readStyle(Row &row, const Command &command) {
  add(row, styleSwitch(command.style.value_or(Style::Text)));
}

void LatexReader::readSpace(Row &row, const Command &command) { add(row, space(command.amount)); }

void LatexReader::readGivenSpace(Row &row, const Command & /*command*/) {
  const std::size_t column = m_column;
  m_tokens.takeIf('*');
  add(row, space(lengthOf(readName(), column)));
}

void LatexReader::readKern(Row &row, const Command & /*command*/) {
  const std::size_t column = m_column;
  add(row, space(lengthOf(readBareLength(), column)));
}

void LatexReader::readFraction(Row &row, const Command &command) {
  Row numerator = readArgument();
  Row denominator = readArgument();
  add(row, fraction(std::move(numerator), std::move(denominator), command.style));
}

void LatexReader::readContinuedFraction(Row &row, const Command & /*command*/) {
  Row numerator = math::row(strut(), readArgument());
  Row denominator = readArgument();
  add(row, fraction(std::move(numerator), std::move(denominator), Style::Display));
}

void LatexReader::readBinomial(Row &row, const Command &command) {
  Row over = readArgument();
  Row under = readArgument();
  add(row,
      fenced('(', math::row(Node{Fraction{std::move(over), std::move(under), false, command.style}}), ')'));
  row.back().atomClass = AtomClass::Ord;
}

void LatexReader::readOver(Row &row, const Command &command) {
  Row numerator = std::exchange(row, {});
  Row denominator = readRow();
  const bool hasBar = command.name == "over";
  add(row, Node{Fraction{std::move(numerator), std::move(denominator), hasBar, {}}});
  if (command.name == "choose")
    row = math::row(fenced('(', std::move(row), ')'));
}

void LatexReader::readRoot(Row &row, const Command & /*command*/) {
  Row degree = readOption().value_or(Row());
  add(row, root(readArgument(), std::move(degree)));
}

void LatexReader::readFenced(Row &row, const Command & /*command*/) {
  const std::size_t column = m_column;
  const char32_t open = readFence();
  const bool inOption = std::exchange(m_inOption, false);
  ++m_fences;
  Row content = readRow();
  --m_fences;
  m_inOption = inOption;
  if (!m_tokens.peekMath().isCommand("right"))
    failUnclosed(column, "\\left", "\\right");
  m_column = m_tokens.take().column;
  const char32_t close = readFence();
  add(row, fenced(open, std::move(content), close));
}

void LatexReader::readMiddle(Row &row, const Command & /*command*/) {
  if (m_fences == 0)
    throw ReadError{m_column, halfspace::words("`\\middle` can stand only between `\\left` and `\\right`.")};
  add(row, {MiddleFence{readFence()}, AtomClass::Rel});
}

void LatexReader::readTallFence(Row &row, const Command &command) {
  add(row, {TallFence{readFence(), command.amount}, command.atomClass});
}

void LatexReader::readAccent(Row &row, const Command &command) {
  add(row, accent(command.character, readArgument()));
}

void LatexReader::readWideAccent(Row &row, const Command &command) {
  add(row, wideAccent(command.character, readArgument()));
}

void LatexReader::readBar(Row &row, const Command &command) { add(row, bar(command.side, readArgument())); }

void LatexReader::readBrace(Row &row, const Command &command) {
  Node made = brace(command.side, readArgument());
  std::get<Brace>(made.content).character = command.character;
  add(row, std::move(made));
}

void LatexReader::readStack(Row &row, const Command &command) {
  Row small = readArgument();
  Row base = readArgument();
  Node made = command.side == Side::Above ? stack(std::move(base), std::move(small), {})
                                          : stack(std::move(base), {}, std::move(small));
  if (command.atomClass == AtomClass::Rel)
    made.atomClass = AtomClass::Rel;
  add(row, std::move(made));
}

void LatexReader::readArrow(Row &row, const Command &command) {
  Row below = readOption().value_or(Row());
  add(row, {LongArrow{command.character, readArgument(), std::move(below)}, AtomClass::Rel});
}

void LatexReader::readNot(Row &row, const Command & /*command*/) {
  Row base = readArgument();
  const AtomClass atomClass = base.empty() ? AtomClass::Rel : classOf(base);
  const Symbol *only = base.size() == 1 ? std::get_if<Symbol>(&base.front().content) : nullptr;
  if (const char32_t one = only ? negated(only->character) : 0)
    add(row, symbol(one, atomClass));
  else
    add(row, {Negated{std::move(base)}, atomClass});
}

void LatexReader::readClass(Row &row, const Command &command) {
  add(row, {Group{readArgument()}, command.atomClass, command.scriptPlace});
}

void LatexReader::readBoxed(Row &row, const Command & /*command*/) { add(row, boxed(readArgument())); }

void LatexReader::readPhantom(Row &row, const Command &command) {
  const bool isSmash = command.name == "smash";
  const bool keepsHeight = command.name == "phantom" || command.name == "vphantom";
  add(row, {Phantom{readArgument(), isSmash, command.name != "vphantom", keepsHeight}});
}

void LatexReader::readLap(Row &row, const Command &command) {
  add(row, {Phantom{readArgument(), true, false, true, command.align}});
}

void LatexReader::readBlock(Row &row, const Command & /*command*/) {
  const std::size_t column = m_column;
  const double width = lengthOf(readName(), column);
  const double height = lengthOf(readName(), column);
  if (width < 0 || height < 0)
    throw ReadError{column, halfspace::words("A box cannot be smaller than nothing.")};
  add(row, {Block{width, height}});
}

void LatexReader::readStrut(Row &row, const Command & /*command*/) { add(row, strut()); }

void LatexReader::readModulo(Row &row, const Command & /*command*/) {
  constexpr double roomBefore = 1;
  constexpr double roomInside = 1.0 / 3;
  Row modulus = readArgument();
  add(row, space(roomBefore));
  add(row, symbol('(', AtomClass::Open));
  add(row, words("mod"));
  add(row, space(roomInside));
  detail::append(row, std::move(modulus));
  add(row, symbol(')', AtomClass::Close));
}

void LatexReader::readMark(Row &row, const Command & /*command*/) {
  const std::size_t column = m_column;
  std::string tag = readName();
  if (tag.empty() || !std::all_of(tag.begin(), tag.end(), isTagCharacter))
    throw ReadError{column,
                    halfspace::words("The mark `{mark}` is not made of letters, digits, `.`, `-` and `_`.",
                                     {{"mark", tag}})};
  add(row, tagged(std::move(tag), readArgument()));
}

Color LatexReader::readColorValue() {
  const std::size_t column = m_column;
  const std::string name = readName();
  if (const auto color = hexColor(name))
    return *color;
  const auto found = std::find_if(namedColors.begin(), namedColors.end(),
                                  [&name](const NamedColor &each) { return each.name == name; });
  if (found == namedColors.end())
    throw ReadError{column, halfspace::words("The colour `{colour}` is unknown: write it as `#rrggbb`.",
                                             {{"colour", name}})};
  return found->color;
}

void LatexReader::readColor(Row &row, const Command & /*command*/) {
  const Color color = readColorValue();
  add(row, colored(color, readArgument()));
}

void LatexReader::readNothing(Row & /*row*/, const Command & /*command*/) {}

void LatexReader::readLabel(Row & /*row*/, const Command & /*command*/) { (void)readName(); }

void LatexReader::readMisplaced(Row & /*row*/, const Command &command) {
  throw ReadError{m_column, halfspace::words("`\\{command}` cannot stand here.",
                                             {{"command", std::string(command.name)}})};
}

} // namespace halfspace::math
