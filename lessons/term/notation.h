// What the notations may be asked for.
#pragma once

namespace halfspace {

struct Notation {
  char decimalMark = '.';     ///< or a comma; lists are then parted by semicolons
  bool flatFractions = false; ///< 1/2, as among words, where taller ones would tear the lines apart
};

} // namespace halfspace
