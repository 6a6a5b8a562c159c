#include "lessons/construction/naming.h"

namespace halfspace {

Term madeName(const Naming &naming, const std::string &made, std::optional<TermValue> value) {
  return name(naming.made.at(made), std::move(value)).marked(naming.mark(made));
}

} // namespace halfspace
