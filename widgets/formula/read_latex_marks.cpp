// The commands of marks and colours, and of what has no place in a formula.
#include "lessons/words.h"
#include "widgets/formula/latex_arguments.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_reader.h"

#include <algorithm>
#include <string>
#include <utility>

namespace halfspace::math {
namespace {

bool isTagCharacter(char c) {
  return isAsciiLetter(static_cast<unsigned char>(c)) || isAsciiDigit(static_cast<unsigned char>(c)) ||
         c == '.' || c == '-' || c == '_';
}

} // namespace

void readMark(LatexReader &reader, Row &row, const CommandCall &call) {
  std::string tag = readName(reader.tokens(), call.column);
  if (tag.empty() || !std::all_of(tag.begin(), tag.end(), isTagCharacter))
    throw ReadError{call.column,
                    halfspace::words("The mark `{mark}` is not made of letters, digits, `.`, `-` and `_`.",
                                     {{"mark", tag}})};
  reader.add(row, tagged(std::move(tag), reader.readArgument()));
}

void readColor(LatexReader &reader, Row &row, const CommandCall &call) {
  const Color color = readColorValue(reader.tokens(), call.column);
  reader.add(row, colored(color, reader.readArgument()));
}

void readNothing(LatexReader & /*reader*/, Row & /*row*/, const CommandCall & /*call*/) {}

void readLabel(LatexReader &reader, Row & /*row*/, const CommandCall &call) {
  (void)readName(reader.tokens(), call.column);
}

void readMisplaced(LatexReader & /*reader*/, Row & /*row*/, const CommandCall &call) {
  throw ReadError{call.column, halfspace::words("`\\{command}` cannot stand here.",
                                                {{"command", std::string(call.command.name)}})};
}

} // namespace halfspace::math
