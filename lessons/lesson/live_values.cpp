#include "lessons/lesson/live_values.h"

#include "lessons/lesson/condition.h"
#include "lessons/lesson/entry_names.h"
#include "lessons/object/kind.h"
#include "lessons/term/among_words.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"

#include <algorithm>

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

Value valueOf(const ExactVec3 &coordinate, CoordinateRole role) {
  return numbersIn(role) == 1 ? Value(Surd(coordinate.x))
                              : std::vector<Surd>{coordinate.x, coordinate.y, coordinate.z};
}

/// `i.S` for S where no entry is called so and one alone makes an S; else the name itself.
std::string withOwner(const std::string &name, const Evaluation &evaluation) {
  const std::string own = name.substr(0, name.find('.'));
  std::vector<std::string> owners;
  for (const EvaluatedEntry &entry : evaluation.entries)
    for (const OfferedObject &made : entry.offers)
      if (made.name == own)
        owners.push_back(entry.name);
  return owners.size() == 1 && !evaluation.find(own) ? owners.front() + "." + name : name;
}

bool lookAlike(const Term &a, const Term &b) { return readAlike(a, b) && showsRounded(a) == showsRounded(b); }

} // namespace

bool LiveNumber::operator==(const LiveNumber &other) const {
  return lookAlike(term, other.term) && size.has_value() == other.size.has_value() &&
         (!size || lookAlike(*size, *other.size));
}

LiveValue liveValue(const std::string &name, const Scene &scene, const Evaluation &evaluation,
                    LiveValues values) {
  const bool isHidden = values == LiveValues::Hidden;
  if (const auto value = findValue(evaluation, name))
    return isHidden ? hiddenValue : valueAmongWords(*value);
  if (const auto id = findCoordinate(scene, name)) {
    const Object &object = *findObject(scene, id->object);
    return valueAmongWords(valueOf(object[id->index], coordinatesOf(object)[id->index].role));
  }
  if (const auto made = valueMade(name, evaluation))
    return isHidden ? hiddenValue : valueAmongWords(valueOf(made->value, made->role));
  return noValue;
}

std::optional<CoordinateValue> valueMade(const std::string &name, const Evaluation &evaluation) {
  return coordinateValue(evaluation, withOwner(name, evaluation));
}

std::vector<std::string> liveNames(const Evaluation &evaluation) {
  std::vector<std::string> names;
  const auto add = [&](const std::string &name) {
    const bool hasValue = liveValue(name, evaluation.scene, evaluation) != LiveValue(noValue);
    if (hasValue && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const CoordinateId &id : coordinatesOf(evaluation.scene))
    add(shortName(evaluation.scene, id));
  for (const EvaluatedEntry &entry : evaluation.entries)
    for (const OfferedObject &made : entry.offers)
      if (entry.isConstruction())
        for (const CoordinateSpec &spec : coordinatesOf(made.given->object))
          add(coordinateId(made.given->id, spec));
  for (const OfferedValue &value : comparableValues(evaluation.scene)) {
    const auto dot = value.name.rfind('.');
    const std::string axis = dot == std::string::npos ? "" : value.name.substr(dot + 1);
    const bool isPart = axis == "x" || axis == "y" || axis == "z"; // words have vectors as a whole
    add(isPart ? value.name.substr(0, dot) : value.name);
  }
  return names;
}

std::string liveText(const std::string &name, const Evaluation &evaluation) {
  const LiveValue value = liveValue(name, evaluation.scene, evaluation);
  if (const auto *word = std::get_if<std::string>(&value))
    return name + " = " + *word;
  const auto &number = std::get<LiveNumber>(value);
  return name + (showsRounded(number.term) ? " " : " = ") + plainText(number);
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
