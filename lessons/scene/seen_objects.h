// The objects of a scene as others look at them.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// An object that an entry is or makes, and the word of the kind that others look at: a bound object is a
/// point.
struct SeenObject {
  std::string id;
  std::string_view kind;
};

/// All of them, from top to bottom.
[[nodiscard]] std::vector<SeenObject> seenObjectsOf(const Scene &scene);

} // namespace halfspace
