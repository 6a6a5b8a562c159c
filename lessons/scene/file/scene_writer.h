// Scenes as JSON: what scene_reader.h reads.
#pragma once

#include "lessons/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace halfspace {

/// {"name":"E","plane":{"P0":["5","4","7"],"n":["1","2","2"]}}; coordinates are exact texts.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Scene &scene);

/// {"plane":{"P0":["5","4","7"],"n":["1","2","2"]}}
[[nodiscard]] nlohmann::ordered_json jsonOf(const Object &object);

/// {"E":"E","Q":"distance.F"}; several objects of a role are a list: {"planes":["E","F"]}.
[[nodiscard]] nlohmann::ordered_json rolesJson(const ConstructionUse &use);

} // namespace halfspace
