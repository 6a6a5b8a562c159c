// Scenes as documents: the same shape in .halfspace files and in the front matter of lessons.
//   {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}   {name: Q, point: [11, 15, 8]}
//   {name: P, point-on-line: {on: g, lambda: 1/2}}
//   {name: distance, construction: signed-distance, of: {E: E, Q: Q}}
//   {name: beyond, construction: signed-distance, of: {E: G, Q: distance.F}}
// What a construction makes goes by its entry's name and its own, or by its own where only one entry above
// makes it.
#pragma once

#include "lessons/reading/document.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// The scene that a list of entries spells, checked so that it can be evaluated. `path` is the list's own
/// field.
[[nodiscard]] Result<Scene> readScene(const DocumentNode &list, const std::string &file,
                                      const std::string &path);

} // namespace halfspace
