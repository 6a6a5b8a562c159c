#include "lessons/typed/object_supply.h"

#include "lessons/formula/read_formula.h"
#include "lessons/object/solid.h"

#include <algorithm>

namespace halfspace {

ObjectSupply::ObjectSupply(const Scene &scene, char decimalMark)
    : m_mark(decimalMark), m_objects(seenObjectsOf(scene)) {
  std::reverse(m_objects.begin(), m_objects.end());
  std::stable_partition(m_objects.begin(), m_objects.end(),
                        [](const SeenObject &each) { return qualified(each.id).entry.empty(); });
}

std::vector<SeenObject> ObjectSupply::fitting(const ArgumentPlace &place, std::string_view beginning,
                                              const std::set<std::string> &without) const {
  std::vector<SeenObject> found;
  for (const SeenObject &object : m_objects)
    if (object.id.starts_with(beginning) && canStandFor(place.kind, object.kind) &&
        !without.contains(object.id))
      found.push_back(object);
  return found;
}

std::optional<FilledPlaces> ObjectSupply::filled(const std::vector<ArgumentPlace> &places,
                                                 std::set<std::string> without) const {
  FilledPlaces result;
  for (auto place = places.begin(); place != places.end(); ++place) {
    const auto alike = static_cast<std::size_t>(std::count_if(
        place, places.end(), [&](const ArgumentPlace &each) { return each.kind == place->kind; }));
    if (const std::vector<SeenObject> objects = fitting(*place, "", without); !objects.empty()) {
      result.arguments.push_back(objects[std::min(alike, objects.size()) - 1].id);
      without.insert(result.arguments.back());
    } else if (place->otherwise) {
      result.arguments.push_back(toText(*place->otherwise, m_mark));
      ++result.madeUp;
    } else {
      return {};
    }
  }
  return result;
}

} // namespace halfspace
