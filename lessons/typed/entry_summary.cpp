#include "lessons/typed/entry_summary.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/letters.h"
#include "lessons/term/angle.h"
#include "lessons/term/plain_text.h"
#include "lessons/typed/look_words.h"
#include "lessons/typed/write_line.h"
#include "lessons/words.h"

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

std::string coordinateText(const Given<Object> &given, std::size_t index) {
  const NamedValue value = listed({}, coordinateTerm(given, index));
  return plainText(termOf(value.value).value());
}

/// Of all coordinates but those that are others' own, whose numbers stand there.
std::string coordinatesText(const Given<Object> &given, const DerivedObject *derived) {
  const auto &specs = coordinatesOf(given.object);
  std::string text;
  for (std::size_t index = 0; index < given.object.size(); ++index) {
    if (derived && !specs[index].goesByObject() && derived->coordinates[index].kind == FormulaKind::Name)
      continue;
    text += text.empty() ? "" : ", ";
    if (!specs[index].goesByObject())
      text += plainText(given.letters[index]) + " = ";
    text += coordinateText(given, index);
  }
  return text;
}

std::string objectText(const Given<Object> &given, const DerivedObject *derived = nullptr) {
  if (kindOf(given.object) == PlaneObject::kind)
    return plainText(equationOf(termsOf(as<PlaneObject>(given))));
  return given.object.shape() ? std::string() : coordinatesText(given, derived);
}

/// The angle of at most 90° whose sine a label is, or the one whose cosine it is, in degrees: φ ≈ 78.69°;
/// nothing for other labels.
std::optional<std::string> angleText(const Term &label) {
  if (label->kind != TermKind::Applied || !numberOf(label))
    return {};
  const std::string function = plainText(label->symbol);
  const Real &value = *numberOf(label);
  const auto cosine = function == "cos"   ? std::optional(value)
                      : function == "sin" ? squareRoot(Real(1) - value * value)
                                          : std::nullopt;
  if (!cosine)
    return {};
  return plainText(label->parts[0]) + relatedText(degreesOf(number(*cosine))) + "°";
}

/// What a construction comes to in the row of a list: the value that goes by its own name or word,
/// `signed_distance` or `distance`; where its case has none such, the case in words if objects are what it is
/// for, else the last value that stands in its lines, which is what they lead to.
std::string mainValue(const Outcome &outcome, const Construction &construction) {
  std::string named(construction.id);
  std::replace(named.begin(), named.end(), '-', '_'); // as the eval format writes names
  std::string last;
  for (const NamedValue &value : *outcome.values)
    if (const auto *letter = std::get_if<Term>(&value.label)) {
      if (value.name == named || value.name == construction.word)
        return equation(*letter);
      last = angleText(*letter).value_or(equation(*letter));
    }
  return last.empty() || !construction.makes.empty() ? outcome.told->description : last;
}

/// What stands behind the name and its sign.
std::string definitionIn(const std::string &line) { return line.substr(line.find_first_of("=:") + 2); }

/// Whether the numbers of an object stand in its line already, a plane's equation too.
bool tellsItself(const Entry &entry, const std::string &line) {
  const auto *object = std::get_if<Object>(&entry.content);
  if (!object || isBound(entry))
    return false;
  return object->shape() || kindOf(*object) != PlaneObject::kind || line[entry.name.size()] == ':';
}

} // namespace

std::string valueOf(const OfferedObject &object) {
  return object.whyNot.empty() ? objectText(*object.given) : std::string();
}

EntrySummary summaryOf(const Entry &entry, const Evaluation &evaluation, char decimalMark) {
  EntrySummary summary;
  const std::string line = lineFor(withoutLook(entry), decimalMark); // the row shows the look itself
  const Kind *kind = kindOf(entry);
  summary.definition = !line.empty() ? definitionIn(line) : kind->noun();
  if (entry.isLocked)
    summary.definition += words(", locked");
  const EvaluatedEntry *evaluated = evaluation.find(entry.name);
  if (!evaluated)
    return summary;
  if (!evaluated->missing.empty())
    summary.value = words("not there now");
  else if (kind && !evaluated->outcome->told->description.empty())
    summary.value = evaluated->outcome->told->description;
  else if (kind == findKind(NumberObject::kind))
    summary.value = coordinateText(*evaluated->offers.front().given, 0);
  if (!summary.value.empty() || tellsItself(entry, line))
    return summary;
  const auto *derived = std::get_if<DerivedObject>(&entry.content);
  summary.value = kind ? objectText(*evaluated->offers.front().given, derived)
                       : mainValue(*evaluated->outcome, *findConstruction(evaluated->construction));
  return summary;
}

} // namespace halfspace
