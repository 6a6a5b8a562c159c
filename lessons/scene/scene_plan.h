// What of a scene stays as it is however its objects are moved.
#pragma once

#include "lessons/scene/scene_letters.h"

namespace halfspace {

/// All that is told of a scene's entries without a look at the numbers of its objects. A drag changes none of
/// it, so that scenes which differ in those numbers alone share one.
struct ScenePlan {
  explicit ScenePlan(const Scene &scene);

  SceneLetters letters;
  std::vector<Look> looks; ///< of the entries' objects
  /// Where the entries stand that each looks at, or at what they make.
  std::vector<std::vector<std::size_t>> lookedAt;
};

/// Whether the plan of one scene is that of the other.
[[nodiscard]] bool haveSamePlan(const Scene &a, const Scene &b);

} // namespace halfspace
