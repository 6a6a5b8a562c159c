// Drawings of lessons' steps, as they begin.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/shown.h"
#include "tests/picture/labels/vectors_only.h"
#include "widgets/exports/draw_shapes.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/lesson_picture.h"

namespace halfspace {

inline const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

inline ShapeList shapesOfStep(const Lesson &lesson, const LessonStep *step, View view, const Theme &theme) {
  const Evaluation evaluation = evaluate(lesson.scene);
  const Stage stage = stageOf(lesson.scene, boundObjectsOf(lesson.scene, evaluation));
  Composer composer(vectorsOnly());
  composer.setTheme(theme);
  composer.setContent(contentOf(&lesson, step, evaluation, stage));
  view.camera = homeOf(&lesson, evaluation, stage, view.size, view.pixelRatio);
  composer.setView(view);
  return composer.compose();
}

inline Drawing drawingOfStep(const Lesson &lesson, const LessonStep &step, const PaperLook &look = {},
                             double typeSize = 9) {
  const Theme &theme = *findTheme("print");
  const View view = viewOnPaper({1600, 1000}, look.width, typeSize, theme);
  Drawing drawing = drawingOf(shapesOfStep(lesson, &step, view, theme), look);
  drawing.title = lesson.title;
  drawing.description = shownIn(step, evaluate(lesson.scene)).description;
  return drawing;
}

} // namespace halfspace
