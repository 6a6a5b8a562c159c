// What the use of a construction is called in its scene.
#pragma once

#include "lessons/term/term.h"
#include "lessons/words.h"

#include <map>
#include <set>
#include <string>

namespace halfspace {

/// How an object that a construction makes is written.
struct MadeLetters {
  Symbol symbol;
  std::map<std::string, Symbol> coordinates{}; ///< by their names
  bool operator==(const MadeLetters &) const = default;
};

/// The names of one use of a construction.
struct Naming {
  std::string entry;                         ///< its own in the scene
  std::map<std::string, MadeLetters> made{}; ///< by the objects' names in the construction
  /// For sentences, the letters of what it looks at and makes: {E}, {Q}, {F}, {n}, and {E.n} where two roles
  /// have a coordinate n. Of the first object of a list role {planes0} and {planes0.n}.
  WordValues letters{};
  /// Those of the construction's own letters that something else in the scene has too.
  std::set<std::string> shared{};

  /// The id of one of its own marks: `distance.w`.
  [[nodiscard]] std::string mark(const std::string &own) const { return entry + "." + own; }

  /// A letter of the construction's own; where something else has it too, with the entry's name.
  [[nodiscard]] Symbol own(Symbol letter) const;

  bool operator==(const Naming &) const = default;
};

/// The name of a point that the construction makes, and the mark that it is; and that of a coordinate of
/// another object.
[[nodiscard]] Term madeName(const Naming &naming, const std::string &made, std::optional<TermValue> value);
[[nodiscard]] Term madeName(const Naming &naming, const std::string &made, const std::string &coordinate,
                            std::optional<TermValue> value);

} // namespace halfspace
