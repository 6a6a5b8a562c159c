#include "lessons/typed/open_places.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Puts an argument into the first place that takes it; false where none does.
bool take(const std::string &argument, OpenPlaces &open, const SceneNames &names) {
  for (std::vector<ArgumentPlace> *places : {&open.needed, &open.possible})
    for (auto place = places->begin(); place != places->end(); ++place)
      if (const std::string id = names.find(argument, place->kind); !id.empty()) {
        open.used.insert(id);
        if (places == &open.needed) {
          if (place->isList)
            open.possible.push_back(*place);
          open.needed.erase(place);
        }
        return true;
      }
  return false;
}

} // namespace

std::optional<OpenPlaces> openPlaces(const Signature &signature,
                                     const std::vector<std::string_view> &arguments,
                                     const SceneNames &names) {
  OpenPlaces open{signature.places};
  for (const std::string_view argument : arguments)
    if (const std::string text(argument); signature.isInAnyOrder) {
      if (!take(text, open, names))
        return {};
    } else if (open.needed.empty()) {
      return {};
    } else {
      open.used.insert(names.find(text, open.needed.front().kind));
      open.needed.erase(open.needed.begin());
    }
  return open;
}

} // namespace halfspace
