// A lesson, or some of its steps, as a handout.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/exports/drawing.h"
#include "widgets/handout/handout_look.h"
#include "widgets/handout/set_words.h"

#include <functional>
#include <vector>

namespace halfspace {

/// How a figure is to be drawn; lengths are in points.
struct FigureSize {
  double width = 0;
  double typeSize = 0; ///< of its labels
};

/// Draws what is shown of the scene: in space, and behind that flat, where the lesson has such a picture.
/// Where nothing is drawn the step has no figure.
using FigureDrawer = std::function<std::vector<Drawing>(const Figure &shown, const FigureSize &size)>;

struct HandoutRequest {
  const Lesson &lesson;
  const Evaluation &evaluation;   ///< of the scene that is shown
  std::vector<std::size_t> steps; ///< of the lesson, counted from 0, in the order of the handout
  HandoutPaper paper = HandoutPaper::A4;
  int columns = 1; ///< 1 or 2
  /// Whether what a learner is asked is told: the right choice, what a task shows, the numbers of lines that
  /// are left to be worked out. Without them there is room to write instead.
  bool hasAnswers = false;
  FigureDrawer drawFigure{}; ///< not null
};

/// The file: a PDF, without its session. The same request gives the same bytes.
[[nodiscard]] std::string handoutOf(const HandoutRequest &request, const HandoutFonts &fonts);

} // namespace halfspace
