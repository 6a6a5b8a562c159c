#include "lessons/typed/write_line.h"

#include "lessons/construction/construction.h"
#include "lessons/formula/plane_through.h"
#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/typed/call_words.h"
#include "lessons/typed/equation.h"
#include "lessons/typed/look_words.h"
#include "lessons/typed/scene_names.h"

namespace halfspace {
namespace {

/// Puts the text of a line together.
class LineText {
public:
  LineText(const Entry &entry, char decimalMark)
      : m_entry(entry), m_mark(decimalMark), m_separator(decimalMark == ',' ? "; " : ", ") {}

  std::string write() const {
    if (const auto *object = std::get_if<Object>(&m_entry.content))
      if (const auto plane = objectAs<PlaneObject>(*object))
        if (const auto equation = equationFor(*plane))
          return m_entry.name + ": " + text(equation->left) + " = " + text(equation->right) + lookText();
    const std::string content = contentText();
    return content.empty() ? content : m_entry.name + " = " + content + lookText();
  }

private:
  std::string lookText() const {
    std::string text;
    for (const std::string &word : lookWordsOf(m_entry))
      text += m_separator + word;
    return text;
  }

  std::string contentText() const {
    if (const auto *object = std::get_if<Object>(&m_entry.content))
      return objectText(*object);
    if (const auto *derived = std::get_if<DerivedObject>(&m_entry.content))
      return formulasText(*derived->kind, derived->coordinates);
    return useText(std::get<ConstructionUse>(m_entry.content));
  }

  std::string objectText(const Object &object) const {
    if (object.shape())
      return {};
    if (const auto number = objectAs<NumberObject>(object))
      return numberText(*number);
    std::vector<Formula> coordinates;
    for (std::size_t i = 0; i < object.size(); ++i)
      coordinates.push_back(numbersIn(coordinatesOf(object)[i].role) == 1
                                ? Formula{FormulaKind::Number, object[i].x}
                                : formulaOf(object[i]));
    return formulasText(object.kind(), coordinates);
  }

  std::string numberText(const NumberObject &number) const {
    return text(number.value) + m_separator + text(number.from) + " <= " + m_entry.name +
           " <= " + text(number.to) + m_separator + "step " + text(number.step);
  }

  /// The way of writing on paper where that says the kind, else its word.
  std::string formulasText(const Kind &kind, const std::vector<Formula> &coordinates) const {
    const bool isNamedAsPoint = namesPoint(m_entry.name);
    const Formula &last = coordinates.back();
    if (kind.word == NumberObject::kind)
      return text(last);
    if (kind.word == PointObject::kind && isNamedAsPoint)
      return text(last);
    if (kind.word == VectorObject::kind && !isNamedAsPoint && coordinates.front() == formulaOf(ExactVec3(0)))
      return text(last);
    if (const auto points = kind.word == PlaneObject::kind ? pointsOfPlane(coordinates) : std::nullopt)
      return call(std::string(kind.word), {points->begin(), points->end()});
    return call(std::string(kind.word), coordinates);
  }

  std::string call(const std::string &word, const std::vector<Formula> &coordinates) const {
    std::string arguments = m_entry.on;
    for (const Formula &formula : coordinates)
      arguments += (arguments.empty() ? "" : m_separator) + text(formula);
    return word + "(" + arguments + ")";
  }

  std::string useText(const ConstructionUse &use) const {
    const Construction &construction = *findConstruction(use.id);
    std::string arguments;
    for (const ConstructionRole &role : construction.roles)
      for (const std::string &id : use.roles.at(role.name).ids)
        arguments += (arguments.empty() ? "" : m_separator) + id;
    return std::string(callOf(construction)) + "(" + arguments + ")";
  }

  std::string text(const Formula &formula) const { return toText(formula, m_mark); }
  std::string text(const Rational &number) const { return toText(number); }

  const Entry &m_entry;
  char m_mark;
  std::string m_separator;
};

} // namespace

std::string lineFor(const Entry &entry, char decimalMark) { return LineText(entry, decimalMark).write(); }

} // namespace halfspace
