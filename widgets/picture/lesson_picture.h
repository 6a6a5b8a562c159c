// Pictures of lessons' scenes.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/picture/camera.h"
#include "widgets/picture/scene_content.h"

namespace halfspace {

/// What is shown of a scene: by a step, or the whole of it where that is null; in scene units.
[[nodiscard]] Figure figureShown(const LessonStep *step, const Evaluation &evaluation);

/// What a picture shows of the scene of a lesson (null: of none) on a stage, as in figureShown.
[[nodiscard]] SceneContent contentOf(const Lesson *lesson, const LessonStep *step,
                                     const Evaluation &evaluation, const Stage &stage);

/// Where the lesson, or a scene that is of none (null), is looked at from at its beginning; see homeView.
[[nodiscard]] Camera homeOf(const Lesson *lesson, const Evaluation &evaluation, const Stage &stage,
                            PixelSize size, double pixelRatio);

} // namespace halfspace
