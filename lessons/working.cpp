#include "lessons/working.h"

#include <algorithm>

namespace halfspace {
namespace {

void keepTelling(Blank &blank) {
  std::vector<Mistake> telling;
  for (Mistake &mistake : blank.mistakes) {
    const bool known = std::any_of(telling.begin(), telling.end(),
                                   [&](const Mistake &other) { return other.value == mistake.value; });
    if (!known && !(mistake.value == blank.answer))
      telling.push_back(std::move(mistake));
  }
  blank.mistakes = std::move(telling);
}

} // namespace

Working withTellingMistakes(Working working) {
  for (WorkingLine &line : working.lines)
    if (line.blank)
      keepTelling(*line.blank);
  return working;
}

} // namespace halfspace
