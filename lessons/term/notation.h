// What the notations may be asked for.
#pragma once

namespace halfspace {

struct Notation {
  char decimalMark = '.'; ///< or a comma; lists are then parted by semicolons
};

} // namespace halfspace
