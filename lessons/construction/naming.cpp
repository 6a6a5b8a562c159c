#include "lessons/construction/naming.h"

namespace halfspace {

Symbol Naming::own(Symbol letter) const {
  if (shared.contains(letter.letter + letter.subscript))
    letter.owner = entry;
  return letter;
}

Term madeName(const Naming &naming, const std::string &made, std::optional<TermValue> value) {
  return name(naming.made.at(made).symbol, std::move(value)).marked(naming.mark(made));
}

Term madeName(const Naming &naming, const std::string &made, const std::string &coordinate,
              std::optional<TermValue> value) {
  return name(naming.made.at(made).coordinates.at(coordinate), std::move(value))
      .marked(naming.mark(made + "." + coordinate));
}

} // namespace halfspace
