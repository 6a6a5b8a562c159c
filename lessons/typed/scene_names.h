// What goes by which name in a scene, for those who type.
#pragma once

#include "lessons/scene/seen_objects.h"
#include "lessons/term/term.h"

#include <set>

namespace halfspace {

/// The objects of a scene that something can be said of, with the words of their kinds.
class SceneNames {
public:
  explicit SceneNames(const Scene &scene);

  /// Whether something goes by a name, or the name begins with that of an entry.
  [[nodiscard]] bool isName(std::string_view name) const;
  [[nodiscard]] bool isTaken(const std::string &name) const { return m_entries.contains(name); }
  /// Whether another entry can go by a name: none is spelled like it.
  [[nodiscard]] bool isFree(const std::string &name) const { return !m_written.contains(writtenName(name)); }
  /// The id of the object of a kind that is meant by a name: `Q`, `distance.F`, F where one entry alone makes
  /// an F, or `distance` where that makes one such object alone; empty where there is none.
  [[nodiscard]] std::string find(const std::string &name, std::string_view kind) const;
  /// The word of the kind of what goes by a name, whatever it is; empty for nothing. A use of a construction
  /// that makes several objects, or none, is of none.
  [[nodiscard]] std::string_view kindOf(const std::string &name) const;
  /// All names of all objects.
  [[nodiscard]] std::vector<std::string> names() const;
  /// What a name comes to in a formula, with its id; nothing where it is in none.
  struct Value {
    std::string id;
    CoordinateRole role{};
  };
  [[nodiscard]] std::optional<Value> value(const std::string &name) const;

private:
  /// The ids that a name can mean, the nearest first.
  [[nodiscard]] std::vector<std::string> idsFor(const std::string &name) const;

  std::set<std::string, std::less<>> m_entries; ///< all names of entries
  std::set<std::string> m_written;              ///< … as they are written
  std::vector<SeenObject> m_objects;            ///< in their order
};

/// Three numbers are a point where the name begins with a capital letter, else a vector.
[[nodiscard]] inline bool namesPoint(std::string_view name) {
  return name.front() >= 'A' && name.front() <= 'Z';
}

} // namespace halfspace
