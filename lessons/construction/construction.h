// A construction: one thing taught. Each stands in one file of lessons/construction/taught/, its name in
// the list of lessons/CMakeLists.txt, from which the table is generated.
#pragma once

#include "lessons/construction/construction_names.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/object/given.h"

#include <functional>
#include <span>

namespace halfspace {

/// A role: the name by which a construction knows an object that it looks at or makes, and that object's
/// kind.
struct ConstructionRole {
  std::string name;
  std::string_view kind;
  bool isList = false; ///< of several objects of the kind
};

/// A list role has one to so many objects.
inline constexpr std::size_t maxListedObjects = 8;

/// Whether so many objects can stand in the role.
[[nodiscard]] inline bool isCountOf(const ConstructionRole &role, std::size_t objects) {
  return objects >= 1 && objects <= (role.isList ? maxListedObjects : 1);
}

/// How many of the objects that a construction looks at stand in one of its roles: one; in its list role all
/// that the others leave over.
[[nodiscard]] inline std::size_t countIn(const ConstructionRole &role, std::size_t roles,
                                         std::size_t objects) {
  return role.isList ? objects + 1 - roles : 1;
}

using GivenObjects = std::span<const std::shared_ptr<const Given<Object>>>;

/// A construction as the table holds it, with the types of its input and output erased.
struct Construction {
  std::string_view id;
  std::string_view word;  ///< that asks for it or for others of its sort: intersect; may be empty
  std::string (*title)(); ///< what comes of it, in few words: where the lines meet
  std::vector<ConstructionRole> roles; ///< what it looks at
  std::vector<ConstructionRole> makes; ///< what later entries can look at, where the case has it
  std::vector<std::string> ownLetters; ///< of what else stands in its lines: w, f, t
  ConstructionNames names;             ///< of all that it can come to
  bool hasCrossings;                   ///< it looks at a ray and many triangles
  /// Evaluates objects in the order of the roles, those of a list one after the other; their kinds are those
  /// of the roles. Of the naming all but
  /// the letters for sentences is needed.
  std::function<std::shared_ptr<const Outcome>(Naming, GivenObjects)> evaluate;
};

/// The naming with its letters for sentences.
[[nodiscard]] Naming withLetters(Naming naming, const std::vector<ConstructionRole> &roles,
                                 GivenObjects objects);

/// In the place of a kind: a role that is a list of such objects. A construction has at most one.
template <class Kind> struct Several;

/// All constructions, in the order of the CMake list.
[[nodiscard]] const std::vector<Construction> &constructions();

/// The construction with this id, or null.
[[nodiscard]] const Construction *findConstruction(std::string_view id);

} // namespace halfspace
