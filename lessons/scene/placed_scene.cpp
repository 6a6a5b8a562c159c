#include "lessons/scene/placed_scene.h"

#include <algorithm>

namespace halfspace {

std::vector<PlacedObject> boundObjectsOf(const Scene &scene, const Evaluation &evaluation) {
  std::vector<PlacedObject> bound;
  for (const Entry &entry : scene.entries)
    if (const EvaluatedEntry *evaluated = isBound(entry) ? evaluation.find(entry.name) : nullptr;
        evaluated && evaluated->missing.empty())
      bound.push_back({entry.name, evaluated->looksAt[0], evaluated->looksAt[1]});
  return bound;
}

PlacedScene::PlacedScene(Scene itself) : scene(std::move(itself)) {
  if (std::any_of(scene.entries.begin(), scene.entries.end(), isBound))
    bound = boundObjectsOf(scene, evaluate(scene));
}

PlacedScene::PlacedScene(Scene itself, const Evaluation &evaluation)
    : scene(std::move(itself)), bound(boundObjectsOf(scene, evaluation)) {}

} // namespace halfspace
