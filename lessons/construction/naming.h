// What the use of a construction is called in its scene.
#pragma once

#include "lessons/term/term.h"
#include "lessons/words.h"

#include <map>
#include <string>

namespace halfspace {

/// The names of one use of a construction.
struct Naming {
  std::string entry; ///< its own in the scene
  /// The letters of the objects that it makes, by their names in the construction.
  std::map<std::string, Symbol> made{};
  /// For sentences, the letters of what it looks at and makes: {E}, {Q}, {F}, {n}, and {E.n} where two roles
  /// have a coordinate n.
  WordValues letters{};

  /// The id of one of its own marks: `distance.w`.
  [[nodiscard]] std::string mark(const std::string &own) const { return entry + "." + own; }

  bool operator==(const Naming &) const = default;
};

/// The name of an object that the construction makes, and the mark that it is.
[[nodiscard]] Term madeName(const Naming &naming, const std::string &made, std::optional<TermValue> value);

} // namespace halfspace
