#include "lessons/scene/seen_objects.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"

namespace halfspace {

std::vector<SeenObject> seenObjectsOf(const Scene &scene) {
  std::vector<SeenObject> found;
  for (const Entry &entry : scene.entries)
    if (const Kind *kind = kindOf(entry))
      found.push_back({entry.name, kind->binding ? PointObject::kind : kind->word});
    else if (const Construction *construction = findConstruction(std::get<ConstructionUse>(entry.content).id))
      for (const ConstructionRole &made : construction->makes)
        found.push_back({entry.name + "." + made.name, made.kind});
  return found;
}

} // namespace halfspace
