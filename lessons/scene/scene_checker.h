// Whether a scene can be evaluated.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/scene.h"

#include <unordered_map>
#include <unordered_set>

namespace halfspace {

struct ConstructionRole;

/// The longest name of an entry.
inline constexpr std::size_t maxNameLength = 32;
inline constexpr std::size_t maxSceneEntries = 1000;

/// Whether an entry can be called so: letters, digits, - and _, the first a letter, and not too many.
[[nodiscard]] bool canBeName(std::string_view name);

/// The problem of a scene with more entries.
[[nodiscard]] Problem tooManyEntries();

/// Says which coordinate is beyond what the object's kind allows, and what would fit.
[[nodiscard]] std::optional<Problem> refuseUnfitting(const Object &object);

/// Takes the entries of a scene from top to bottom and says what is wrong with one: its name, a coordinate
/// beyond the limits, a construction that does not exist or looks at what is not above it or of another kind.
class SceneChecker {
public:
  /// What is wrong with the next entry; the problem's field is counted from the entry.
  [[nodiscard]] std::optional<Problem> check(const Entry &entry);

  /// The id of an object above that goes by a name: `distance.F` for F where one entry alone makes an F and
  /// none is called so. A name of none stays what it is.
  [[nodiscard]] std::string idOf(const std::string &name) const;

private:
  /// The ids of what can be looked at as this kind.
  [[nodiscard]] std::vector<std::string> objectsOfKind(std::string_view kind) const;
  [[nodiscard]] std::optional<Problem> checkName(const std::string &name) const;
  /// Whether there is an object of a kind above that goes by an id.
  [[nodiscard]] std::optional<Problem> checkReference(const std::string &field, const std::string &id,
                                                      std::string_view kind) const;
  [[nodiscard]] std::optional<Problem> checkHost(const Entry &entry, const Object &object) const;
  /// Whether each formula speaks of what is above, and comes to what its coordinate is.
  [[nodiscard]] std::optional<Problem> checkDerived(const DerivedObject &derived) const;
  [[nodiscard]] std::optional<Problem> checkFormula(const CoordinateSpec &spec, const std::string &field,
                                                    const Formula &formula) const;
  [[nodiscard]] std::optional<FormulaShape> shapeNamed(std::string_view name) const;
  [[nodiscard]] std::optional<Problem> checkRole(const ConstructionRole &role,
                                                 const ConstructionUse &use) const;
  [[nodiscard]] std::optional<Problem> checkUse(const ConstructionUse &use) const;

  std::unordered_map<std::string, std::string_view> m_kinds;          ///< of what can be looked at, by id
  std::unordered_map<std::string, std::vector<std::string>> m_makers; ///< of what is made, by its own name
  std::unordered_set<std::string> m_names;                            ///< of the entries
};

/// What is wrong with the first entry that something is wrong with.
[[nodiscard]] std::optional<Problem> checkScene(const Scene &scene);

} // namespace halfspace
