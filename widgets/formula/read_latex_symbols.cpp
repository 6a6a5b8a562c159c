// The commands of letters, operators and their alphabets.
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_reader.h"
#include "widgets/formula/latex_symbols.h"

#include <string>
#include <utility>

namespace halfspace::math {
namespace {

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

void readLetter(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, symbol(reader.inCurrentAlphabet(call.command.character)));
}

void readLargeOperator(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, largeOperator(call.command.character, call.command.scriptPlace));
}

void readFunction(LatexReader &reader, Row &row, const CommandCall &call) {
  Node name = function(std::string(call.command.text.empty() ? call.command.name : call.command.text),
                       call.command.scriptPlace);
  name.atomClass = call.command.atomClass;
  reader.add(row, std::move(name));
}

void readDots(LatexReader &reader, Row &row, const CommandCall &call) {
  constexpr char32_t dotOnAxis = U'⋅';
  constexpr int dotCount = 3;
  const bool isPlain = call.command.character == 0; // \dots, which look at what follows
  const char32_t dot =
      isPlain ? (isBetweenTerms(reader.tokens().peekMath()) ? dotOnAxis : U'.') : call.command.character;
  // TeX's dots stand further apart than those of one character.
  Row dots;
  for (int i = 0; i < dotCount; ++i)
    reader.add(dots, symbol(dot, AtomClass::Punct));
  reader.add(row, {Group{std::move(dots)}, AtomClass::Inner});
}

void readDiagonalDots(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  reader.add(row, symbol(U'⋱', AtomClass::Inner));
}

void readNot(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  Row base = reader.readArgument();
  const AtomClass atomClass = base.empty() ? AtomClass::Rel : classOf(base);
  const Symbol *only = base.size() == 1 ? std::get_if<Symbol>(&base.front().content) : nullptr;
  if (const char32_t one = only ? negated(only->character) : 0)
    reader.add(row, symbol(one, atomClass));
  else
    reader.add(row, {Negated{std::move(base)}, atomClass});
}

void readModulo(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  constexpr double roomBefore = 1;
  constexpr double roomInside = 1.0 / 3;
  Row modulus = reader.readArgument();
  reader.add(row, space(roomBefore));
  reader.add(row, symbol('(', AtomClass::Open));
  reader.add(row, words("mod"));
  reader.add(row, space(roomInside));
  detail::append(row, std::move(modulus));
  reader.add(row, symbol(')', AtomClass::Close));
}

void readClass(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, {Group{reader.readArgument()}, call.command.atomClass, call.command.scriptPlace});
}

void readAlphabet(LatexReader &reader, Row &row, const CommandCall &call) {
  const Within alphabet(reader.surroundings().alphabet, std::optional(call.command.alphabet));
  reader.addGroup(row, reader.readArgument());
}

void readAlphabetSwitch(LatexReader &reader, Row & /*row*/, const CommandCall &call) {
  reader.surroundings().alphabet = call.command.alphabet;
}

} // namespace halfspace::math
