// Whatever the bytes: where they are a lesson, a handout of it with lines, tables and code that end
// somewhere.
#include "widgets/handout/lesson_handout.h"

#include <cstdint>
#include <cstdlib>

namespace {

using namespace halfspace;

/// Nothing is drawn: figures are fuzzed elsewhere.
std::vector<Drawing> nothing(const Figure &, const FigureSize &) { return {}; }

void demand(bool holds) {
  if (!holds)
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const auto formulas = math::readMathFonts(MATH_FONT, TEXT_FONT);
  static const auto words = math::readTextFaces(TEXT_FACES);
  const auto lesson = parseLesson(std::string_view(reinterpret_cast<const char *>(data), size), "fuzz");
  if (!lesson)
    return 0;
  const Evaluation evaluation = evaluate(lesson->scene);
  HandoutRequest request{*lesson, evaluation, {}};
  for (std::size_t i = 0; i < lesson->steps.size(); ++i)
    request.steps.push_back(i);
  request.drawFigure = nothing;
  for (const int columns : {1, 2}) {
    request.columns = columns;
    request.hasAnswers = columns == 2;
    const std::string file = handoutOf(request, {*formulas, *words});
    demand(file.starts_with("%PDF-") && file.ends_with("%%EOF\n"));
  }
  return 0;
}
