// Figures of lessons for handouts, as they begin.
#pragma once

#include "tests/picture/labels/vectors_only.h"
#include "widgets/exports/draw_flat.h"
#include "widgets/exports/draw_shapes.h"
#include "widgets/handout/lesson_handout.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/picture/lesson_picture.h"

namespace halfspace {

/// Draws the scene of a lesson; both must outlive it.
inline FigureDrawer figureDrawer(const Lesson &lesson, const Evaluation &evaluation) {
  return [&](const Figure &shown, const FigureSize &size) {
    const Theme &theme = *findTheme("print");
    const PaperLook look{size.width};
    const Stage stage = stageOf(evaluation.scene, boundObjectsOf(evaluation.scene, evaluation));
    View view = viewOnPaper({1600, 1000}, size.width, size.typeSize, theme);
    std::vector<Drawing> drawings;
    Composer composer(vectorsOnly());
    composer.setTheme(theme);
    SceneContent content;
    content.stage = stage;
    content.figure = toStage(shown, stage);
    composer.setContent(std::move(content));
    view.camera = homeOf(&lesson, evaluation, stage, view.size, view.pixelRatio);
    composer.setView(view);
    drawings.push_back(drawingOf(composer.compose(), look));
    if (const auto frame = flatFrame(lesson.flat, evaluation.scene)) {
      const FlatPicture flat(*frame, stage, figureOf(evaluation), shown);
      const View fitted = flat.fitted(view);
      drawings.push_back(flatDrawingOf(flat.seenFrom(fitted), theme, fitted, look, vectorsOnly()));
    }
    return drawings;
  };
}

} // namespace halfspace
