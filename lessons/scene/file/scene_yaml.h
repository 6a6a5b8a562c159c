// Scenes as the front matter of lessons has them: what scene_reader.h reads, in YAML.
#pragma once

#include "lessons/scene/scene.h"

#include <string>

namespace halfspace {

/// A line for each entry, `  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}`. Without labels by hand, for
/// which lessons have no place.
[[nodiscard]] std::string yamlOf(const Scene &scene);

} // namespace halfspace
