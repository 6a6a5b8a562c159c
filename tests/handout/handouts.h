// What the tests of handouts share: lessons, fonts, requests.
#pragma once

#include "tests/exports/lesson_drawings.h"
#include "tests/handout/drawn_figures.h"

namespace halfspace {

inline const math::TextFaces &textFaces() {
  static const auto faces = math::readTextFaces(TEXT_FACES);
  return faces.value();
}

inline HandoutFonts handoutFonts() { return {math::fonts(), textFaces()}; }

/// A handout of all steps of a lesson as it begins.
struct WholeHandout {
  explicit WholeHandout(const Lesson &shown) : lesson(shown), evaluation(evaluate(shown.scene)) {}

  [[nodiscard]] HandoutRequest request() const {
    HandoutRequest request{lesson, evaluation, {}};
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      request.steps.push_back(i);
    request.drawFigure = figureDrawer(lesson, evaluation);
    return request;
  }

  const Lesson &lesson;
  Evaluation evaluation;
};

} // namespace halfspace
