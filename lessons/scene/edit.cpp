#include "lessons/scene/edit.h"

#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kind.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/term/term.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

Problem refused(std::string sentence) { return {std::move(sentence), "", 0, ""}; }

Problem noEntry(const std::string &name) {
  return refused(words("There is no “{name}” in the scene.", {{"name", shortened(name)}}));
}

/// The scene, if it can be evaluated.
Result<Scene> checked(Scene scene) {
  if (auto problem = checkScene(scene))
    return *problem;
  return scene;
}

/// Applies one edit to a scene.
struct Applier {
  Scene scene;

  Result<Scene> operator()(const ChangeObject &edit) {
    const Object *object = findObject(scene, edit.name);
    if (!object)
      return noEntry(edit.name);
    if (kindOf(*object) != kindOf(edit.value))
      return refused(
          words("“{name}” is {kind} and stays one.", {{"name", edit.name}, {"kind", object->kind().noun()}}));
    if (const auto coordinate = refusedCoordinateOf(edit.value))
      return refused(coordinate->sentence);
    Object settled = edit.value;
    settled.kind().settle(settled);
    setObject(scene, edit.name, std::move(settled));
    return std::move(scene);
  }

  Result<Scene> operator()(const AddEntry &edit) {
    if (auto problem = refuseWrittenAlike(edit.entry.name))
      return *problem;
    scene.entries.insert(std::min(edit.index, scene.entries.size()), edit.entry);
    return checked(std::move(scene));
  }

  Result<Scene> operator()(const RemoveEntry &edit) {
    if (!scene.entries.find(edit.name))
      return noEntry(edit.name);
    const std::vector<std::string> dependents = dependentsOf(scene, edit.name);
    if (!dependents.empty() && !edit.withDependents)
      return refused(words("“{name}” is needed by {others}: remove them with it, or first.",
                           {{"name", edit.name}, {"others", listed(dependents)}}));
    std::set<std::string> going{dependents.begin(), dependents.end()};
    going.insert(edit.name);
    scene.entries.eraseIf([&](const Entry &entry) { return going.contains(entry.name); });
    std::erase_if(scene.labels,
                  [&](const auto &label) { return going.contains(std::string(entryOfMark(label.first))); });
    return std::move(scene);
  }

  Result<Scene> operator()(const ReplaceEntry &edit) {
    const auto place = scene.entries.placeOf(edit.name);
    if (!place)
      return noEntry(edit.name);
    if (edit.entry.name != edit.name)
      rename(*place, {edit.name, edit.entry.name});
    if (auto problem = edit.entry.name == edit.name ? std::nullopt : refuseWrittenAlike(edit.entry.name))
      return *problem;
    scene.entries.change(*place, [&](Entry &entry) { entry = edit.entry; });
    return checked(std::move(scene));
  }

  Result<Scene> operator()(const RenameEntry &edit) {
    const auto place = scene.entries.placeOf(edit.name);
    if (!place)
      return noEntry(edit.name);
    rename(*place, edit);
    if (auto problem = refuseWrittenAlike(edit.newName))
      return *problem;
    return checked(std::move(scene));
  }

  Result<Scene> operator()(const RebindRole &edit) {
    const auto place = scene.entries.placeOf(edit.name);
    if (!place)
      return noEntry(edit.name);
    if (std::holds_alternative<ConstructionUse>(scene.entries[*place].content))
      scene.entries.change(*place, [&](Entry &entry) {
        std::get<ConstructionUse>(entry.content).roles[edit.role] = edit.objects;
      });
    else if (edit.role == hostRole && edit.objects.ids.size() == 1)
      scene.entries.change(*place, [&](Entry &entry) { entry.on = edit.objects.ids.front(); });
    else
      return refused(words("“{name}” looks at nothing as its {role}.",
                           {{"name", edit.name}, {"role", shortened(edit.role)}}));
    return checked(std::move(scene));
  }

  Result<Scene> operator()(const MoveEntry &edit) {
    const auto place = scene.entries.placeOf(edit.name);
    if (!place)
      return noEntry(edit.name);
    Entry moved = scene.entries[*place];
    scene.entries.erase(*place);
    scene.entries.insert(std::min(edit.index, scene.entries.size()), std::move(moved));
    return checked(std::move(scene));
  }

  Result<Scene> operator()(const ChangeLabel &edit) {
    const std::string entry(entryOfMark(edit.mark));
    if (!scene.entries.find(entry))
      return noEntry(entry);
    if (auto problem = refuseLabel(scene.labels, edit.mark))
      return *problem;
    const LabelByHand label = edit.label.value_or(LabelByHand());
    if (label == LabelByHand())
      scene.labels.erase(edit.mark);
    else
      scene.labels[edit.mark] = {label.spot ? std::optional(settled(*label.spot)) : std::nullopt,
                                 label.isHidden};
    return std::move(scene);
  }

private:
  /// A new name that is written like another one, P_1 like P1: nobody could tell them apart. Scenes of files
  /// may have such.
  [[nodiscard]] std::optional<Problem> refuseWrittenAlike(const std::string &name) const {
    for (const Entry &entry : scene.entries)
      if (entry.name != name && writtenName(entry.name) == writtenName(name))
        return refused(words("“{name}” would be written like “{other}”, which is there already.",
                             {{"name", shortened(name)}, {"other", entry.name}}));
    return {};
  }

  void rename(std::size_t place, const RenameEntry &edit) {
    scene.entries.change(place, [&](Entry &entry) { entry.name = edit.newName; });
    for (std::size_t other = 0; other < scene.entries.size(); ++other)
      if (looksAt(scene.entries[other], edit.name))
        scene.entries.change(other, [&](Entry &entry) { followRename(entry, edit); });
    scene.labels = withEntryRenamed(scene.labels, edit.name, edit.newName);
  }

  static bool looksAt(const Entry &entry, const std::string &owner) {
    const std::vector<std::string> ids = referencesIn(entry);
    return std::any_of(ids.begin(), ids.end(), [&](const std::string &id) { return ownerOf(id) == owner; });
  }

  static void followRename(Entry &entry, const RenameEntry &edit) {
    for (std::string *object : referencesIn(entry))
      if (ownerOf(*object) == edit.name)
        object->replace(0, edit.name.size(), edit.newName);
  }

  static std::string listed(const std::vector<std::string> &names) {
    std::string list;
    for (const std::string &name : names)
      list += (list.empty() ? "" : ", ") + name;
    return list;
  }
};

} // namespace

Result<Scene> apply(Scene scene, const Edit &edit) { return std::visit(Applier{std::move(scene)}, edit); }

std::vector<Edit> editsToUnlist(const Scene &scene, const std::string &name) {
  std::vector<Edit> edits;
  for (const Entry &entry : scene.entries)
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      for (const auto &[role, objects] : use->roles)
        if (RoleObjects others = objects; std::erase(others.ids, name) > 0)
          edits.emplace_back(RebindRole{entry.name, role, std::move(others)});
  return edits;
}

std::vector<std::string> dependentsOf(const Scene &scene, const std::string &name) {
  std::set<std::string> known{name};
  std::vector<std::string> dependents;
  for (const Entry &entry : scene.entries)
    if (const auto ids = referencesIn(entry); std::any_of(
            ids.begin(), ids.end(), [&](const std::string &id) { return known.contains(ownerOf(id)); })) {
      known.insert(entry.name);
      dependents.push_back(entry.name);
    }
  return dependents;
}

} // namespace halfspace
