#include "lessons/typed/entry_summary.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/typed/write_line.h"

namespace halfspace {
namespace {

std::string coordinateText(const Given<Object> &given, std::size_t index) {
  const NamedValue value = listed({}, coordinateTerm(given, index));
  return plainText(termOf(value.value).value());
}

std::string coordinatesText(const Given<Object> &given) {
  const auto &specs = coordinatesOf(given.object);
  std::string text;
  for (std::size_t index = 0; index < given.object.size(); ++index) {
    text += text.empty() ? "" : ", ";
    if (!specs[index].goesByObject())
      text += plainText(given.letters[index]) + " = ";
    text += coordinateText(given, index);
  }
  return text;
}

std::string objectText(const Given<Object> &given) {
  if (kindOf(given.object) == PlaneObject::kind)
    return plainText(equationOf(termsOf(as<PlaneObject>(given))));
  return given.object.shape() ? std::string() : coordinatesText(given);
}

/// The first number, or list of numbers, that a construction tells in its case.
std::string firstValue(const Outcome &outcome) {
  for (const NamedValue &value : *outcome.values)
    if (const auto *letter = std::get_if<Term>(&value.label))
      return equation(*letter);
  return {};
}

/// Whether the numbers of an object stand in its definition already.
bool tellsItself(const Entry &entry) {
  const auto *object = std::get_if<Object>(&entry.content);
  return object && !isBound(entry) && kindOf(*object) != PlaneObject::kind;
}

} // namespace

std::string valueOf(const OfferedObject &object) {
  return object.whyNot.empty() ? objectText(*object.given) : std::string();
}

EntrySummary summaryOf(const Entry &entry, const Evaluation &evaluation, char decimalMark) {
  EntrySummary summary;
  const std::string line = lineFor(entry, decimalMark);
  const Kind *kind = kindOf(entry);
  summary.definition = !line.empty() ? line.substr(entry.name.size() + 3) : std::string(kind->noun()); // “ = ”
  const EvaluatedEntry *evaluated = evaluation.find(entry.name);
  if (!evaluated || !evaluated->missing.empty() || tellsItself(entry))
    return summary;
  summary.value = kind ? valueOf(evaluated->offers.front()) : firstValue(*evaluated->outcome);
  return summary;
}

} // namespace halfspace
