// A scene with its bound objects where they are.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// A bound object at its place, and what it lies on.
struct PlacedObject {
  std::string name; ///< the entry's
  std::shared_ptr<const Given<Object>> point;
  std::shared_ptr<const Given<Object>> host;
};

/// The bound objects of a scene that have a place in what it comes to.
[[nodiscard]] std::vector<PlacedObject> boundObjectsOf(const Scene &scene, const Evaluation &evaluation);

struct PlacedScene {
  /// Of any scene: it is evaluated where it has bound objects.
  PlacedScene(Scene scene); // NOLINT(google-explicit-constructor): it is the scene, told more fully
  /// With what the scene comes to.
  PlacedScene(Scene scene, const Evaluation &evaluation);

  Scene scene;
  std::vector<PlacedObject> bound; ///< those that have a place now
  ExactVec3 origin{0};             ///< where the scene has its origin
};

} // namespace halfspace
