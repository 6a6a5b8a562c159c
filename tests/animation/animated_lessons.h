// Our lessons, to be shown in motion.
#pragma once

#include "widgets/animation/motion.h"

#include <gtest/gtest.h>

namespace halfspace::test {

inline AnimatedScene animated(const std::string &lesson) {
  static const LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
  const Lesson &found = *library.find(lesson);
  AnimatedScene scene;
  scene.lesson = std::make_shared<const Lesson>(found);
  scene.scene = found.scene;
  scene.size = {320, 200};
  return scene;
}

/// Null, and a failure, where the scene has no such motion.
inline std::unique_ptr<Motion> motionOf(const std::string &kind, const AnimatedScene &scene,
                                        std::optional<double> seconds = {}) {
  auto motion = findMotionKind(kind)->make(scene, seconds);
  if (motion)
    return std::move(*motion);
  ADD_FAILURE() << motion.problem().text();
  return nullptr;
}

} // namespace halfspace::test
