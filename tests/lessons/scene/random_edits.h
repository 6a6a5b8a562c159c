// Edits of scenes at random.
#pragma once

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/scene/edit.h"

#include <random>

namespace halfspace::test {

/// Makes edits at random, sensible ones and others.
class RandomEdits {
public:
  explicit RandomEdits(std::uint64_t seed) : m_engine(seed) {}

  Edit next(const Scene &scene) {
    switch (below(8)) {
    case 0:
      return anyChange(scene);
    case 1:
      return AddEntry{below(scene.entries.size() + 1), anyEntry(scene)};
    case 2:
      return RemoveEntry{anyName(scene), below(3) == 0};
    case 3:
      return RenameEntry{anyName(scene), newName()};
    case 4:
      return anyRebinding(scene);
    case 5:
      return anyLabel(scene);
    case 6:
      return anyReplacement(scene);
    default:
      return MoveEntry{anyName(scene), below(scene.entries.size() + 1)};
    }
  }

private:
  std::size_t below(std::size_t end) { return m_engine() % end; }
  int small() { return static_cast<int>(below(19)) - 9; }
  ExactVec3 vector() {
    const int x = small();
    const int y = small();
    return {x, y, small()};
  }
  std::string newName() { return "N" + std::to_string(below(40)); }
  std::string anyName(const Scene &scene) {
    return scene.entries.empty() ? "none" : scene.entries[below(scene.entries.size())].name;
  }
  std::string anyReference(const Scene &scene) {
    const std::string name = anyName(scene);
    return below(2) == 0 ? name : name + "." + (below(2) == 0 ? "F" : "H");
  }
  /// Mostly one, for a list role too.
  RoleObjects anyReferences(const Scene &scene) {
    RoleObjects objects = anyReference(scene);
    while (below(4) == 0)
      objects.ids.push_back(anyReference(scene));
    return objects;
  }
  /// Mostly of the kind that the object is of.
  Edit anyChange(const Scene &scene) {
    const std::string name = anyName(scene);
    const Object *object = findObject(scene, name);
    return ChangeObject{name, object && below(4) > 0 ? objectOf(kindOf(*object)) : anyObject()};
  }
  /// By anything, or by the same with another look.
  Edit anyReplacement(const Scene &scene) {
    const std::string name = anyName(scene);
    const Entry *old = scene.entries.find(name);
    Entry entry = old && below(3) > 0 ? *old : anyEntry(scene);
    entry.color = below(2) == 0 ? std::nullopt : std::optional(static_cast<Hue>(below(hueCount)));
    entry.line.reset();
    if (hasLines(entry) && below(2) == 0)
      entry.line = static_cast<LineStyle>(below(lineStyleCount));
    entry.label = below(2) == 0 ? std::nullopt : std::optional(static_cast<LabelText>(below(labelTextCount)));
    entry.isHidden = below(2) == 0;
    entry.isLocked = below(2) == 0;
    return ReplaceEntry{name, std::move(entry)};
  }
  /// Of a mark that may be there; one that was moved is hidden or put back now and then.
  Edit anyLabel(const Scene &scene) {
    const std::string mark = anyReference(scene);
    if (below(4) == 0)
      return ChangeLabel{mark, {}};
    const LabelSpot spot{{small() / 7.0, small() * 30.0}, static_cast<LabelSpot::Side>(below(3))};
    return ChangeLabel{mark, LabelByHand{spot, below(3) == 0}};
  }
  /// Of a role that there is, where there is one: to anything, or to what a construction looks at already.
  Edit anyRebinding(const Scene &scene) {
    std::vector<const Entry *> uses;
    for (const Entry &entry : scene.entries)
      if (std::holds_alternative<ConstructionUse>(entry.content))
        uses.push_back(&entry);
    if (uses.empty() || below(8) == 0)
      return anyNewHost(scene);
    const auto rolesOf = [](const Entry *entry) { return std::get<ConstructionUse>(entry->content).roles; };
    const Entry *use = uses[below(uses.size())];
    const auto roles = rolesOf(use);
    const std::string role = std::next(roles.begin(), static_cast<int>(below(roles.size())))->first;
    const auto others = rolesOf(uses[below(uses.size())]);
    const auto other = others.find(role);
    return RebindRole{use->name, role, other == others.end() ? anyReferences(scene) : other->second};
  }
  Edit anyNewHost(const Scene &scene) {
    for (const Entry &entry : scene.entries)
      if (isBound(entry) && below(2) == 0)
        return RebindRole{entry.name, hostRole, hostFor(std::get<Object>(entry.content).kind(), scene)};
    return RebindRole{anyName(scene), hostRole, anyReference(scene)};
  }
  Object anyObject() { return objectOf(kinds()[below(kinds().size())].word); }
  Object objectOf(std::string_view kind) {
    Object object = *makeObject(kind);
    for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i)
      for (int axis = 0; axis < numbersIn(coordinatesOf(object)[i].role); ++axis)
        coordinate(object, i)[axis] = small();
    object.kind().settle(object);
    return object;
  }
  /// On something of the right kind, where there is one.
  Entry anyBoundEntry(const Scene &scene, std::string name) {
    std::vector<const Kind *> bound;
    for (const Kind &kind : kinds())
      if (kind.binding)
        bound.push_back(&kind);
    const Kind &kind = *bound[below(bound.size())];
    return {std::move(name), objectOf(kind.word), hostFor(kind, scene)};
  }
  std::string hostFor(const Kind &kind, const Scene &scene) {
    std::vector<std::string> fitting;
    for (const Entry &entry : scene.entries)
      if (const auto *object = std::get_if<Object>(&entry.content);
          object && kindOf(*object) == kind.binding->host)
        fitting.push_back(entry.name);
    return fitting.empty() ? anyReference(scene) : fitting[below(fitting.size())];
  }
  Entry anyEntry(const Scene &scene) {
    std::string name = newName();
    if (below(2) == 0)
      return {std::move(name), anyObject()};
    if (below(3) == 0)
      return anyBoundEntry(scene, std::move(name));
    const Construction &construction = constructions()[below(constructions().size())];
    ConstructionUse use{std::string(construction.id), {}};
    for (const ConstructionRole &role : construction.roles)
      use.roles[role.name] = role.isList ? anyReferences(scene) : RoleObjects(anyReference(scene));
    return {std::move(name), std::move(use)};
  }

  std::mt19937_64 m_engine;
};

} // namespace halfspace::test
