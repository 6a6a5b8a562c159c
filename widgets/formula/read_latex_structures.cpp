// The commands that put formulas above, below, beside and into others: fractions, roots, fences, accents,
// arrows.
#include "lessons/words.h"
#include "widgets/formula/latex_arguments.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_errors.h"
#include "widgets/formula/latex_reader.h"

#include <utility>

namespace halfspace::math {
namespace {

/// What stands between `\left(` and `\right`.
Row readBetweenFences(LatexReader &reader) {
  const Within option(reader.surroundings().inOption, false);
  const Within fences(reader.surroundings().inFences, true);
  return reader.readRow();
}

} // namespace

void readFraction(LatexReader &reader, Row &row, const CommandCall &call) {
  Row numerator = reader.readArgument();
  Row denominator = reader.readArgument();
  reader.add(row, fraction(std::move(numerator), std::move(denominator), call.command.style));
}

void readContinuedFraction(LatexReader &reader, Row &row, const CommandCall &call) {
  Row numerator;
  readStrut(reader, numerator, call);
  detail::append(numerator, reader.readArgument());
  Row denominator = reader.readArgument();
  reader.add(row, fraction(std::move(numerator), std::move(denominator), Style::Display));
}

void readBinomial(LatexReader &reader, Row &row, const CommandCall &call) {
  Row over = reader.readArgument();
  Row under = reader.readArgument();
  reader.add(row,
             fenced('(',
                    math::row(Node{Fraction{std::move(over), std::move(under), false, call.command.style}}),
                    ')'));
  row.back().atomClass = AtomClass::Ord;
}

void readOver(LatexReader &reader, Row &row, const CommandCall &call) {
  Row numerator = std::exchange(row, {});
  Row denominator = reader.readRow();
  const bool hasBar = call.command.name == "over";
  reader.add(row, Node{Fraction{std::move(numerator), std::move(denominator), hasBar, {}}});
  if (call.command.name == "choose")
    row = math::row(fenced('(', std::move(row), ')'));
}

void readRoot(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  Row degree = reader.readOption().value_or(Row());
  reader.add(row, root(reader.readArgument(), std::move(degree)));
}

void readFenced(LatexReader &reader, Row &row, const CommandCall &call) {
  TokenStream &tokens = reader.tokens();
  const char32_t open = readFence(tokens, call.column);
  Row content = readBetweenFences(reader);
  if (!tokens.peekMath().isCommand("right"))
    failUnclosed(tokens, call.column, "\\left", "\\right");
  const Token right = tokens.take();
  const char32_t close = readFence(tokens, right.column);
  reader.add(row, fenced(open, std::move(content), close));
}

void readMiddle(LatexReader &reader, Row &row, const CommandCall &call) {
  if (!reader.surroundings().inFences)
    throw ReadError{call.column,
                    halfspace::words("`\\middle` can stand only between `\\left` and `\\right`.")};
  reader.add(row, {MiddleFence{readFence(reader.tokens(), call.column)}, AtomClass::Rel});
}

void readTallFence(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(
      row, {TallFence{readFence(reader.tokens(), call.column), call.command.amount}, call.command.atomClass});
}

void readAccent(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, accent(call.command.character, reader.readArgument()));
}

void readWideAccent(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, wideAccent(call.command.character, reader.readArgument()));
}

void readBar(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, bar(call.command.side, reader.readArgument()));
}

void readBrace(LatexReader &reader, Row &row, const CommandCall &call) {
  Node made = brace(call.command.side, reader.readArgument());
  std::get<Brace>(made.content).character = call.command.character;
  reader.add(row, std::move(made));
}

void readStack(LatexReader &reader, Row &row, const CommandCall &call) {
  Row small = reader.readArgument();
  Row base = reader.readArgument();
  Node made = call.command.side == Side::Above ? stack(std::move(base), std::move(small), {})
                                               : stack(std::move(base), {}, std::move(small));
  if (call.command.atomClass == AtomClass::Rel)
    made.atomClass = AtomClass::Rel;
  reader.add(row, std::move(made));
}

void readArrow(LatexReader &reader, Row &row, const CommandCall &call) {
  Row below = reader.readOption().value_or(Row());
  reader.add(row,
             {LongArrow{call.command.character, reader.readArgument(), std::move(below)}, AtomClass::Rel});
}

void readBoxed(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  reader.add(row, boxed(reader.readArgument()));
}

} // namespace halfspace::math
