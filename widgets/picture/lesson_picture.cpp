#include "widgets/picture/lesson_picture.h"

#include "lessons/lesson/shown.h"
#include "widgets/picture/camera_views.h"

namespace halfspace {

Figure figureShown(const LessonStep *step, const Evaluation &evaluation) {
  return step ? shownIn(*step, evaluation).figure : figureOf(evaluation);
}

SceneContent contentOf(const Lesson *lesson, const Figure &shown, const Evaluation &evaluation,
                       const Stage &stage) {
  SceneContent content;
  content.stage = stage;
  content.labels = evaluation.scene.labels;
  content.hasShadows = !lesson || lesson->hasShadows;
  content.figure = toStage(shown, stage);
  return content;
}

Camera homeOf(const Lesson *lesson, const Evaluation &evaluation, const Stage &stage, PixelSize size,
              double pixelRatio) {
  return homeView(lesson ? lesson->camera : CameraView(), toStage(figureOf(evaluation), stage),
                  stage.hasAxes(), size, pixelRatio);
}

Camera cameraFor(const Session &session, const Lesson *lesson, const Evaluation &evaluation,
                 const Stage &stage, const View &view) {
  if (session.view)
    return cameraOf(*session.view);
  return homeOf(lesson, evaluation, stage, view.size, view.pixelRatio);
}

} // namespace halfspace
