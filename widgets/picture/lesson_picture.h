// Pictures of lessons' scenes.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"
#include "widgets/picture/scene_content.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// What is shown of a scene: by a step, or the whole of it where that is null; in scene units.
[[nodiscard]] Figure figureShown(const LessonStep *step, const Evaluation &evaluation);

/// What a picture shows of the scene of a lesson (null: of none) on a stage: of what it comes to, this.
[[nodiscard]] SceneContent contentOf(const Lesson *lesson, const Figure &shown, const Evaluation &evaluation,
                                     const Stage &stage);
/// … as in figureShown.
[[nodiscard]] inline SceneContent contentOf(const Lesson *lesson, const LessonStep *step,
                                            const Evaluation &evaluation, const Stage &stage) {
  return contentOf(lesson, figureShown(step, evaluation), evaluation, stage);
}

/// Where the lesson, or a scene that is of none (null), is looked at from at its beginning; see homeView.
[[nodiscard]] Camera homeOf(const Lesson *lesson, const Evaluation &evaluation, const Stage &stage,
                            PixelSize size, double pixelRatio);

/// Where the scene of a session is looked at from on a view: as somebody has put the camera, or as its lesson
/// (null: none) begins with what the scene comes to.
[[nodiscard]] Camera cameraFor(const Session &session, const Lesson *lesson, const Evaluation &evaluation,
                               const Stage &stage, const View &view);

} // namespace halfspace
