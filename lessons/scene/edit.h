// What can be done to a scene: a closed set of edits.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// Gives an object another value of its kind.
struct ChangeObject {
  std::string name; ///< the entry's
  Object value;
};

/// Puts a new entry before the entry at an index, or behind all.
struct AddEntry {
  std::size_t index;
  Entry entry;
};

/// Takes an entry away, with what was done to the labels of its marks. Refused where others look at it,
/// unless they go with it.
struct RemoveEntry {
  std::string name;
  bool withDependents = false;
};

/// Puts another entry in the place of one; those that look at that look at the new one, whatever its name is.
struct ReplaceEntry {
  std::string name; ///< of the one that goes
  Entry entry;
};

/// Gives an entry another name; those that look at it follow, and so do the labels of its marks.
struct RenameEntry {
  std::string name;
  std::string newName;
};

/// Lets a construction look at another object in a role, or a bound object lie on another. Of a list role it
/// replaces the whole list.
struct RebindRole {
  std::string name;    ///< the entry's
  std::string role;    ///< of a bound object `hostRole`
  RoleObjects objects; ///< `Q`, or `distance.F` for what another construction makes
};

/// Moves an entry to an index, counted without it. Refused where it would stand above what it looks at, or
/// below what looks at it.
struct MoveEntry {
  std::string name;
  std::size_t index;
};

/// Puts the label of a mark somewhere else, or hides it; nothing: as if nobody had touched it.
struct ChangeLabel {
  std::string mark; ///< its id; the entry that it belongs to must be there, the mark may be of another case
  std::optional<LabelByHand> label{};
};

using Edit = std::variant<ChangeObject, AddEntry, RemoveEntry, ReplaceEntry, RenameEntry, RebindRole,
                          MoveEntry, ChangeLabel>;

/// The scene after an edit; or why it is refused. What comes out can be evaluated if what went in could.
[[nodiscard]] Result<Scene> apply(Scene scene, const Edit &edit);

/// The edits after which no list of a scene has this object among others. One is refused that would leave a
/// list empty.
[[nodiscard]] std::vector<Edit> editsToUnlist(const Scene &scene, const std::string &name);

/// The names of the entries that look at an entry or at what it makes, and of those that look at them in
/// turn, from top to bottom.
[[nodiscard]] std::vector<std::string> dependentsOf(const Scene &scene, const std::string &name);

} // namespace halfspace
