// Scenes whose free objects are moved at random.
#pragma once

#include "lessons/scene/scene.h"

#include <random>

namespace halfspace {

/// The entries that have objects of these ids, and all that these follow.
[[nodiscard]] Scene sceneBehind(const Scene &scene, const std::vector<std::string> &ids);

/// Moves the free objects of scenes, each by itself, to places with short fractions. The same seed moves them
/// to the same places everywhere.
class SceneMover {
public:
  explicit SceneMover(std::uint64_t seed) : m_engine(seed) {}

  /// By a few units, so that most of what is there stays.
  [[nodiscard]] Scene movedNearby(Scene scene) { return moved(std::move(scene), true); }
  /// To anywhere in space.
  [[nodiscard]] Scene movedFar(Scene scene) { return moved(std::move(scene), false); }

private:
  [[nodiscard]] Scene moved(Scene scene, bool isNearby);
  [[nodiscard]] Object moved(Object object, bool isNearby);
  void moveWhole(Object &object, bool isNearby);
  [[nodiscard]] Rational number(const Rational &from, bool isNearby);
  [[nodiscard]] ExactVec3 vector(const ExactVec3 &from, bool isNearby);

  std::mt19937_64 m_engine;
};

} // namespace halfspace
