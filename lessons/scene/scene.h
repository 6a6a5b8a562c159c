// A scene: an ordered list of named entries, each an object or a construction over entries above it.
#pragma once

#include "lessons/figure/look.h"
#include "lessons/formula/formula.h"
#include "lessons/object/object.h"
#include "lessons/scene/label_by_hand.h"
#include "lessons/scene/qualified_name.h"
#include "lessons/shared_list.h"

#include <map>
#include <variant>

namespace halfspace {

/// What stands in a role, by ids of objects above the entry: the name of an entry that is one, `Q`, or what
/// an entry makes, `distance.F`. One object; in a list role several, in their order.
struct RoleObjects {
  RoleObjects() = default;
  RoleObjects(const char *id) : ids{id} {} // NOLINT(google-explicit-constructor): most roles have one object
  RoleObjects(std::string id) : ids{std::move(id)} {}                // NOLINT(google-explicit-constructor)
  RoleObjects(std::vector<std::string> all) : ids(std::move(all)) {} // NOLINT(google-explicit-constructor)

  std::vector<std::string> ids{};
  bool operator==(const RoleObjects &) const = default;
};

/// The use of a construction: its id in the table of constructions, and what stands in each of its roles.
struct ConstructionUse {
  std::string id;
  std::map<std::string, RoleObjects> roles;
  bool operator==(const ConstructionUse &) const = default;
};

/// An object whose coordinates follow others: a formula for each of them, in the order of its kind. Of a
/// number there is one, that of its value: it has no bounds.
struct DerivedObject {
  const Kind *kind; ///< never null, and of coordinates alone
  std::vector<Formula> coordinates;
  bool operator==(const DerivedObject &) const = default;
};

/// What the host of a bound object is called in files and edits.
inline constexpr const char *hostRole = "on";

// What the colour and the lines of an object, and what is done with an entry's picture, are called in files.
inline constexpr const char *colorField = "color";
inline constexpr const char *strokeField = "stroke";
inline constexpr const char *labelField = "label";
inline constexpr const char *hiddenField = "hidden";
inline constexpr const char *lockedField = "locked";

struct Entry {
  std::string name;
  std::variant<Object, ConstructionUse, DerivedObject> content;
  std::string on{}; ///< the id of the object above that a bound object lies on
  /// Of an object, derived or not, or of the results of a construction; nothing where their place in the
  /// scene or what they are about decides.
  std::optional<Hue> color{};
  bool isHidden = false;            ///< nothing of it is drawn; others go on to look at it
  bool isLocked = false;            ///< an object that no hand moves
  std::optional<LineStyle> line{};  ///< of the same
  std::optional<LabelText> label{}; ///< nothing: numbers, and coordinates where they are written
  bool operator==(const Entry &) const = default;
};

/// The kind of the object that an entry is, derived or not; null for a construction.
[[nodiscard]] const Kind *kindOf(const Entry &entry);

/// Whether there is a picture of the entry, which can be coloured and hidden: of numbers there is none.
[[nodiscard]] bool isDrawn(const Entry &entry);

/// Whether the entry's picture has lines, which can be dashed: not so a point's, a ball's or a mesh's. A
/// construction's may have some.
[[nodiscard]] bool hasLines(const Entry &entry);

/// Whether the entry is an object that lies on another.
[[nodiscard]] inline bool isBound(const Entry &entry) { return !entry.on.empty(); }

/// Whether two entries differ in the numbers of their object and in its look alone, if at all.
[[nodiscard]] bool areBuiltAlike(const Entry &a, const Entry &b);

/// Evaluated from top to bottom: an entry sees only those above it, so there are no cycles. Copies of a scene
/// share their entries: one that an edit does not touch is the same in the scenes before and after it.
struct Scene {
  NamedList<Entry> entries;
  LabelsByHand labels{}; ///< of marks of its entries
  bool operator==(const Scene &) const = default;
};

/// Whether two scenes differ in the numbers of their objects and in their looks alone.
[[nodiscard]] bool areBuiltAlike(const Scene &a, const Scene &b);

/// The name of the entry that has an object: `distance` for the id `distance.F`, `Q` for `Q`.
[[nodiscard]] inline std::string ownerOf(std::string_view objectId) {
  const std::string_view entry = qualified(objectId).entry;
  return std::string(entry.empty() ? objectId : entry);
}

/// The ids of the objects that an entry looks at: those of its construction's roles, what it lies on, the
/// names in its formulas, which may be those of coordinates.
[[nodiscard]] std::vector<std::string> referencesIn(const Entry &entry);
[[nodiscard]] std::vector<std::string *> referencesIn(Entry &entry);

/// The object that goes by this name, or null.
[[nodiscard]] const Object *findObject(const Scene &scene, std::string_view name);
/// Puts another object in the place of the one of this name. Requires one.
void setObject(Scene &scene, std::string_view name, Object object);

/// A coordinate of a scene: `E.n`, or `Q` for a point.
struct CoordinateId {
  std::string object;
  std::size_t index = 0;
  bool operator==(const CoordinateId &) const = default;
};

/// All coordinates of the scene, from top to bottom; and those of the entry of this name, if that is an
/// object.
[[nodiscard]] std::vector<CoordinateId> coordinatesOf(const Scene &scene);
[[nodiscard]] std::vector<CoordinateId> coordinatesOf(const Scene &scene, std::string_view name);

/// The full name of a coordinate: `E.n`, or `Q` for a point.
[[nodiscard]] std::string fullName(const Scene &scene, const CoordinateId &id);

/// The name a learner reads: `n` where no other coordinate has it, else the full name.
[[nodiscard]] std::string shortName(const Scene &scene, const CoordinateId &id);

/// The coordinate that `name` means, a full name or a short one that only one coordinate has; else nothing.
[[nodiscard]] std::optional<CoordinateId> findCoordinate(const Scene &scene, std::string_view name);

} // namespace halfspace
