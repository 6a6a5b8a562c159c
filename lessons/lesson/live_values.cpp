#include "lessons/lesson/live_values.h"

#include "lessons/lesson/condition.h"
#include "lessons/term/among_words.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"

namespace halfspace {
namespace {

/// Stands for a value that the present case does not have.
constexpr const char *noValue = "—";
/// Stands for a value that the learner is to find.
constexpr const char *hiddenValue = "?";

LiveValue valueAmongWords(const Value &value) {
  if (const auto *word = std::get_if<Word>(&value))
    return word->read;
  const auto term = termOf(value);
  if (!term)
    return noValue;
  LiveNumber shown{amongWords(*term)};
  const auto *number = std::get_if<Surd>(&value);
  if (number && !number->isRational() && !showsRounded(*term))
    shown.size = decimalOf(*number, digitsAmongWords).term;
  return shown;
}

bool lookAlike(const Term &a, const Term &b) { return readAlike(a, b) && showsRounded(a) == showsRounded(b); }

} // namespace

bool LiveNumber::operator==(const LiveNumber &other) const {
  return lookAlike(term, other.term) && size.has_value() == other.size.has_value() &&
         (!size || lookAlike(*size, *other.size));
}

LiveValue liveValue(const std::string &name, const Scene &scene, const Evaluation &evaluation,
                    LiveValues values) {
  if (const auto value = findValue(evaluation, name))
    return values == LiveValues::Hidden ? hiddenValue : valueAmongWords(*value);
  const auto id = findCoordinate(scene, name);
  if (!id)
    return noValue;
  const Object &object = *findObject(scene, id->object);
  const ExactVec3 &at = object[id->index];
  const bool isSingle = numbersIn(coordinatesOf(object)[id->index].role) == 1;
  return valueAmongWords(isSingle ? Value(Surd(at.x)) : std::vector<Surd>{at.x, at.y, at.z});
}

std::string plainText(const LiveNumber &number) {
  const std::string sign = showsRounded(number.term) ? "≈ " : "";
  return sign + plainText(number.term) + (number.size ? " ≈ " + plainText(*number.size) : "");
}

std::string latexOf(const LiveNumber &number) {
  const auto latex = [](const Term &term) { return latexOf(term, Fractions::Flat); };
  return (showsRounded(number.term) ? "\\approx " : "") + latex(number.term) +
         (number.size ? "\\approx " + latex(*number.size) : "");
}

} // namespace halfspace
