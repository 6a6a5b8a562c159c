// A scene that an animation shows, with what it comes to.
#pragma once

#include "widgets/animation/motion.h"

namespace halfspace {

/// Made once, at the beginning of a motion.
struct StagedScene {
  explicit StagedScene(AnimatedScene animated);

  /// What a picture shows by a step, or of the whole figure where that is null.
  [[nodiscard]] SceneContent content(const LessonStep *step) const;
  /// The same, but what the animated scene is said to show wherever something is said.
  [[nodiscard]] SceneContent shown(const LessonStep *step) const;
  /// The step that is asked for; null where none is, or there is none.
  [[nodiscard]] const LessonStep *step() const;
  /// From where it is looked at.
  [[nodiscard]] Camera camera() const;

  AnimatedScene animated;
  Evaluation evaluation; ///< of its scene
  Stage stage;           ///< which stays, whatever moves
};

} // namespace halfspace
