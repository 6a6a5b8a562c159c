#include "widgets/picture/lesson_picture.h"

#include "lessons/lesson/shown.h"
#include "widgets/picture/camera_views.h"

namespace halfspace {

Figure figureShown(const LessonStep *step, const Evaluation &evaluation) {
  return step ? shownIn(*step, evaluation).figure : figureOf(evaluation);
}

SceneContent contentOf(const Lesson *lesson, const LessonStep *step, const Evaluation &evaluation,
                       const Stage &stage) {
  SceneContent content;
  content.stage = stage;
  content.labels = evaluation.scene.labels;
  content.hasShadows = !lesson || lesson->hasShadows;
  content.figure = toStage(figureShown(step, evaluation), stage);
  return content;
}

Camera homeOf(const Lesson *lesson, const Evaluation &evaluation, const Stage &stage, PixelSize size,
              double pixelRatio) {
  return homeView(lesson ? lesson->camera : CameraView(), toStage(figureOf(evaluation), stage),
                  stage.hasAxes(), size, pixelRatio);
}

} // namespace halfspace
