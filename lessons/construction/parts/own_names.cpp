#include "lessons/construction/parts/own_names.h"

namespace halfspace {

Term ownName(const Naming &naming, Symbol letter, std::optional<TermValue> value) {
  return name(naming.own(std::move(letter)), std::move(value));
}

Term drawnName(const Naming &naming, Symbol letter, std::optional<TermValue> value) {
  const std::string id = naming.mark(letter.letter + letter.subscript);
  return ownName(naming, std::move(letter), std::move(value)).marked(id);
}

} // namespace halfspace
