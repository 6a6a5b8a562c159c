#include "widgets/animation/staged_scene.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/lesson_picture.h"

#include <utility>

namespace halfspace {

StagedScene::StagedScene(AnimatedScene scene)
    : animated(std::move(scene)), evaluation(evaluate(animated.scene)),
      stage(stageOf(animated.scene, boundObjectsOf(animated.scene, evaluation))) {}

SceneContent StagedScene::content(const LessonStep *step) const {
  return contentOf(animated.lesson.get(), step, evaluation, stage);
}

SceneContent StagedScene::shown(const LessonStep *step) const {
  return animated.shown ? *animated.shown : content(step);
}

const LessonStep *StagedScene::step() const {
  return animated.lesson && animated.step ? &stepOf(*animated.lesson, *animated.step) : nullptr;
}

Camera StagedScene::camera() const {
  if (animated.camera)
    return *animated.camera;
  return homeOf(animated.lesson.get(), evaluation, stage, animated.size, ownPixelRatio(animated.size));
}

} // namespace halfspace
