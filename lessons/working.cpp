#include "lessons/working.h"

#include "lessons/words.h"

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

/// A fraction with the sign of its numerator in front, as results have it.
std::string withSignInFront(std::string latex) {
  constexpr std::string_view negative = "= \\frac{-";
  if (latex.starts_with(negative))
    latex.replace(0, negative.size(), "= -\\frac{");
  return latex;
}

} // namespace

Blank fractionBlank(const Rational &p, const Rational &q) {
  Blank blank{Rational(p / q)};
  if (p != 0)
    blank.mistakes.push_back({Rational(q / p), words("{answer} is the fraction upside down.")});
  blank.mistakes.push_back({p, words("{answer} is only the numerator: it is not divided yet.")});
  return blank;
}

Working withTrueRelations(Working working) {
  for (WorkingLine &line : working.lines)
    if (line.numbers.starts_with("\\approx") && line.result.starts_with("="))
      line.result.replace(0, 1, "\\approx");
  return working;
}

Working withoutRepetitions(Working working) {
  for (WorkingLine &line : working.lines)
    if (withSignInFront(line.numbers) == line.result)
      line.numbers.clear();
  return working;
}

Working withTellingMistakes(Working working) {
  for (WorkingLine &line : working.lines)
    if (line.blank)
      keepTelling(*line.blank);
  return working;
}

} // namespace halfspace
