// What the notations may be asked for.
#pragma once

namespace halfspace {

struct Notation {
  char decimalMark = '.';      ///< or a comma; lists are then parted by semicolons
  bool smallFractions = false; ///< as among words, where tall ones would tear the lines apart
};

} // namespace halfspace
