#include "lessons/scene/scene_plan.h"

#include "lessons/scene/scene_looks.h"

namespace halfspace {

ScenePlan::ScenePlan(const Scene &scene) : letters(scene), looks(looksOf(scene)) {
  lookedAt.reserve(scene.entries.size());
  for (const Entry &entry : scene.entries) {
    std::vector<std::size_t> &places = lookedAt.emplace_back();
    for (const std::string &id : referencesIn(entry))
      if (const auto place = scene.entries.placeOf(ownerOf(id)))
        places.push_back(*place);
  }
}

bool haveSamePlan(const Scene &a, const Scene &b) {
  if (a.entries.size() != b.entries.size())
    return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    if (const auto &x = a.entries.shared(i), &y = b.entries.shared(i);
        x != y && !(areBuiltAlike(*x, *y) && x->color == y->color && x->line == y->line))
      return false;
  return true;
}

} // namespace halfspace
