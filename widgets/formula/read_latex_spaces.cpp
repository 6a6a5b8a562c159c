// The commands of spaces, of what takes room without being seen, and of sizes.
#include "lessons/words.h"
#include "widgets/formula/latex_arguments.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_reader.h"

namespace halfspace::math {

void readSpace(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, space(call.command.amount));
}

void readGivenSpace(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.tokens().takeIf('*');
  reader.add(row, space(readLength(reader.tokens(), call.column)));
}

void readKern(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, space(lengthOf(readBareLength(reader.tokens()), call.column)));
}

void readPhantom(LatexReader &reader, Row &row, const CommandCall &call) {
  const bool isSmash = call.command.name == "smash";
  const bool keepsHeight = call.command.name == "phantom" || call.command.name == "vphantom";
  reader.add(row, {Phantom{reader.readArgument(), isSmash, call.command.name != "vphantom", keepsHeight}});
}

void readLap(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, {Phantom{reader.readArgument(), true, false, true, call.command.align}});
}

void readBlock(LatexReader &reader, Row &row, const CommandCall &call) {
  const double width = readLength(reader.tokens(), call.column);
  const double height = readLength(reader.tokens(), call.column);
  if (width < 0 || height < 0)
    throw ReadError{call.column, halfspace::words("A box cannot be smaller than nothing.")};
  reader.add(row, {Block{width, height}});
}

void readStrut(LatexReader &reader, Row &row, const CommandCall & /*call*/) {
  // No width, and as tall as a line of text.
  reader.add(row, {Phantom{math::row(symbol('(')), false, false, true}});
}

void readStyle(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.add(row, styleSwitch(call.command.style.value_or(Style::Text)));
}

} // namespace halfspace::math
