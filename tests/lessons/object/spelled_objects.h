// Scenes of objects as lesson files spell them.
#pragma once

#include "lessons/scene/file/scene_reader.h"
#include "tests/lessons/scenes.h"

#include <stdexcept>

namespace halfspace::test {

/// The scene of some entries: `{name: S, sphere: {c: [1, 2, 3], R: 4}}`, one after the other.
inline Scene spelledScene(const std::string &entries) {
  const auto list = parseYaml("[" + entries + "]", "test", 1, 8);
  auto scene = list ? readScene(*list, "test", "scene") : Result<Scene>(list.problem());
  if (!scene)
    throw std::invalid_argument(scene.problem().text());
  return std::move(*scene);
}

/// An entry of one object of each kind that has an extent, called K.
inline std::string spelledEntry(const std::string &kind) {
  static const std::map<std::string, std::string> coordinates{
      {"point", "[1, 2, 3]"},
      {"vector", "{A: [1, 2, 3], v: [0, 0, 2]}"},
      {"line", "{A: [1, 2, 3], v: [0, 0, 2]}"},
      {"ray", "{Q: [1, 2, 3], r: [0, 0, 2]}"},
      {"segment", "{A: [1, 2, 3], B: [5, 2, 3]}"},
      {"plane", "{P0: [1, 2, 3], n: [0, 0, 2]}"},
      {"plane-through-points", "{P0: [0, 0, 0], P1: [3, 0, 0], P2: [0, 3, 0]}"},
      {"triangle", "{P0: [0, 0, 0], P1: [3, 0, 0], P2: [0, 3, 0]}"},
      {"polygon", "{P0: [0, 0, 0], P1: [4, 0, 0], P2: [4, 4, 0], P3: [0, 4, 0]}"},
      {"tetrahedron", "{P0: [0, 0, 0], P1: [4, 0, 0], P2: [0, 4, 0], P3: [0, 0, 4]}"},
      {"prism", "{P0: [0, 0, 0], h: [0, 0, 5], P1: [3, 0, 0], P2: [0, 3, 0]}"},
      {"box", "{P0: [1, 2, 3], a: 4, b: 5, c: 6}"},
      {"screen", "{P0: [1, 2, 3], u: [4, 0, 0], v: [0, 0, -3], w: 4, h: 3}"},
      {"sphere", "{c: [1, 2, 3], R: 4}"},
      {"number", "{value: 1, from: 0, to: 3, step: 1/2}"}};
  return "{name: K, " + kind + ": " + coordinates.at(kind) + "}";
}

/// The only object of a scene.
inline Object spelledObject(const std::string &kind) {
  return *findObject(spelledScene(spelledEntry(kind)), "K");
}

} // namespace halfspace::test
