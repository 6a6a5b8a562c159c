// Labels by hand as sessions write them: {"Q":{"at":[1.5,-2.25],"side":"left"},"E":{"hidden":true}}.
#pragma once

#include "lessons/reading/document.h"
#include "lessons/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace halfspace {

/// What they are called in sessions.
inline constexpr const char *labelsField = "labels";

/// Requires at least one label.
[[nodiscard]] nlohmann::ordered_json jsonOf(const LabelsByHand &labels);

/// The labels that a node spells, all of marks of the scene's entries. `session` keeps the problem where they
/// are none, or too many.
[[nodiscard]] LabelsByHand readLabels(const DocumentNode &node, const Scene &scene, FieldReader &session);

} // namespace halfspace
