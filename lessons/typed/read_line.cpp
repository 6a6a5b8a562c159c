#include "lessons/typed/read_line.h"

#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/typed/argument.h"
#include "lessons/typed/call_words.h"
#include "lessons/typed/equation.h"
#include "lessons/typed/look_words.h"
#include "lessons/typed/scene_names.h"
#include "lessons/typed/typed_object.h"
#include "lessons/typed/typed_use.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Within these bounds a number moves of which nobody says more, in such steps.
const Rational usualBound = 10;
const Rational usualStep(1, 10);

bool isCalled(const std::string &word) {
  const std::vector<std::string> &known = callWords();
  return std::find(known.begin(), known.end(), word) != known.end();
}

std::string signatureOf(const Kind &kind) {
  std::string list(kind.binding ? hostRole : "");
  for (const CoordinateSpec &spec : kind.coordinates)
    list += (list.empty() ? "" : ", ") + (spec.name.empty() ? "x, y, z" : std::string(spec.name));
  return std::string(kind.word) + "(" + list + ")";
}

bool takeLess(FormulaReader &reader) { return reader.take("<=") || reader.take("≤"); }
bool takeAtLeastZero(FormulaReader &reader, const std::string &name) {
  return reader.take(name) && (reader.take(">=") || reader.take("≥")) && reader.take("0");
}
bool takeUnitInterval(FormulaReader &reader, const std::string &name) {
  return reader.take("0") && takeLess(reader) && reader.take(name) && takeLess(reader) && reader.take("1");
}

/// Whether a word of the look is what comes next; it is not taken.
bool isLookNext(FormulaReader &reader) {
  const std::size_t at = reader.at();
  Entry any;
  const bool isLook = setLook(any, reader.takeName());
  reader.goTo(at);
  return isLook;
}

class LineReader {
public:
  LineReader(std::string_view line, const Scene &above, char decimalMark)
      : m_line(line), m_above(above), m_names(above),
        m_reader(line, decimalMark, [this](std::string_view name) { return m_names.isName(name); }) {}

  std::variant<Entry, TypedFault> read() {
    readName();
    if (!hasFault())
      readContent();
    if (!hasFault())
      readLook();
    if (!hasFault() && !m_reader.isAtEnd())
      fail(words("This cannot be read."), m_reader.at(), m_line.size() - m_reader.at());
    if (!hasFault())
      checkWhole();
    if (const auto &fault = m_reader.fault(); fault && !m_fault)
      m_fault = TypedFault{fault->sentence, std::min(fault->at, m_line.size()), 0};
    return m_fault ? std::variant<Entry, TypedFault>(*m_fault) : std::move(m_entry);
  }

private:
  [[nodiscard]] bool hasFault() const { return m_fault || m_reader.fault(); }
  void fail(const std::string &sentence, std::size_t at, std::size_t length) {
    if (!hasFault())
      m_fault = TypedFault{sentence, at, length};
  }

  void readName() {
    const std::size_t at = m_reader.at();
    m_entry.name = std::string(m_reader.takeWord());
    if (m_entry.name.empty())
      return fail(words("A line begins with a name, as in Q = (1, 2, 3)."), at, 0);
    if (!m_names.isFree(m_entry.name))
      return fail(words("There is “{name}” already.", {{"name", m_entry.name}}), at, m_entry.name.size());
    if (!m_reader.take("=") && !m_reader.take(":"))
      fail(words("Here “=” is needed."), m_reader.at(), 0);
  }

  void readContent() {
    const std::size_t begin = m_reader.at();
    const std::string word(m_reader.takeWord());
    if (m_reader.take("(")) {
      if (isCalled(word))
        return readCall(word, begin);
      const bool canBeProduct =
          word.size() <= 1 || word.find('-') != std::string::npos; // t(1, 2, 3), A-t(1, 2, 3)
      if (!canBeProduct && word != shortestWord && !m_names.isName(word))
        return fail(words("There is no “{name}”.", {{"name", word}}), begin, word.size());
    }
    m_reader.goTo(begin);
    takeAnyPoint();
    const std::size_t said = m_reader.at();
    if (m_line.substr(said).find('=') != std::string_view::npos && !hasConditions(said))
      return readEquation();
    readValue();
  }

  /// Notes call any point of a line X: g: X = A + t v.
  void takeAnyPoint() {
    const std::size_t at = m_reader.at();
    const std::string_view word = m_reader.takeWord();
    m_isOfAnyPoint = word == "X" && !m_names.isName(word) && m_reader.take("=");
    if (!m_isOfAnyPoint)
      m_reader.goTo(at);
  }

  /// Whether the sign of an equation stands behind a comma only: as in t >= 0.
  [[nodiscard]] bool hasConditions(std::size_t begin) const {
    const std::string_view rest = m_line.substr(begin);
    const std::size_t sign = rest.find('=');
    return sign > 0 && (rest[sign - 1] == '<' || rest[sign - 1] == '>');
  }

  // --- calls

  void readCall(const std::string &word, std::size_t at) {
    const std::vector<Argument> arguments = readArguments();
    if (hasFault())
      return;
    if (const Kind *kind = findKind(word))
      return makeObject(*kind, arguments, at, word.size());
    auto use = useOf(word, at, arguments, m_names);
    if (auto *fault = std::get_if<TypedFault>(&use))
      m_fault = std::move(*fault);
    else
      m_entry.content = std::get<ConstructionUse>(std::move(use));
  }

  std::vector<Argument> readArguments() {
    std::vector<Argument> arguments;
    if (m_reader.take(")"))
      return arguments;
    do {
      const std::size_t begin = m_reader.at();
      Formula formula = m_reader.sum();
      arguments.push_back({std::move(formula), begin, m_reader.fault() ? 0 : textEnd() - begin});
    } while (!hasFault() && m_reader.takeSeparator());
    if (!hasFault() && !m_reader.take(")"))
      fail(words("A closing bracket is missing."), m_reader.at(), 0);
    return arguments;
  }

  /// Where the text ends that was read last.
  std::size_t textEnd() {
    std::size_t end = m_reader.at();
    while (end > 0 && m_line[end - 1] == ' ')
      --end;
    return end;
  }

  // --- objects

  void makeObject(const Kind &kind, std::vector<Argument> arguments, std::size_t at, std::size_t length) {
    if (kind.shape)
      return fail(words("A mesh comes out of a file: it cannot be typed."), at, length);
    if (kind.binding)
      takeHost(*kind.binding, arguments);
    if (kind.word == PlaneObject::kind && arguments.size() == 3)
      arguments = throughPoints(arguments);
    if ((kind.word == PointObject::kind || kind.word == VectorObject::kind) && arguments.size() == 3)
      arguments = asTriple(arguments);
    if (kind.word == VectorObject::kind && arguments.size() == 1)
      arguments.insert(arguments.begin(), {formulaOf(ExactVec3(0))});
    if (kind.word == NumberObject::kind && arguments.size() == 1)
      return makeNumber(arguments.front());
    if (kind.word == NumberObject::kind &&
        std::any_of(arguments.begin(), arguments.end(),
                    [](const Argument &each) { return hasNames(each.formula); }))
      return fail(words("A number that follows others has no bounds."), at, length);
    if (kind.word == LineObject::kind || kind.word == RayObject::kind || kind.word == VectorObject::kind)
      leadToPoint(arguments);
    if (arguments.size() < kind.fewestCoordinates() || arguments.size() > kind.coordinates.size())
      return fail(words("{kind} is told by {coordinates}.",
                        {{"kind", kind.noun()}, {"coordinates", signatureOf(kind)}}),
                  at, length);
    put(kind, std::move(arguments));
  }

  /// line(A, B) leads from one point to the other.
  void leadToPoint(std::vector<Argument> &arguments) const {
    if (arguments.size() != 2 || m_names.kindOf(arguments[1].formula.name) != PointObject::kind)
      return;
    Formula &second = arguments[1].formula;
    second = {FormulaKind::Difference, {}, {}, {second, arguments[0].formula}, second.at};
  }

  void takeHost(const Binding &binding, std::vector<Argument> &arguments) {
    if (arguments.empty())
      return;
    const Argument &host = arguments.front();
    m_entry.on = host.formula.kind == FormulaKind::Name ? m_names.find(host.formula.name, binding.host) : "";
    if (m_entry.on.empty())
      m_fault = misfit(host, binding.host, m_names);
    arguments.erase(arguments.begin());
  }

  void put(const Kind &kind, std::vector<Argument> coordinates) {
    if (hasFault())
      return;
    auto made = objectOf(kind, std::move(coordinates), m_names);
    if (auto *fault = std::get_if<TypedFault>(&made))
      m_fault = std::move(*fault);
    else if (auto *derived = std::get_if<DerivedObject>(&made))
      m_entry.content = std::move(*derived);
    else
      m_entry.content = std::get<Object>(std::move(made));
  }

  // --- equations and formulas

  void readEquation() {
    const std::size_t begin = m_reader.at();
    const Formula left = m_reader.sum();
    if (!hasFault() && !m_reader.take("="))
      return fail(words("This cannot be read."), m_reader.at(), 1);
    const Formula right = m_reader.sum();
    if (hasFault())
      return;
    if (isQuadratic(left, right))
      takeTold(sphereOf(left, right), begin);
    else
      takeTold(planeOf(left, right), begin);
  }

  /// What an equation tells, or why it tells nothing.
  template <class Told> void takeTold(const std::variant<Told, FormulaFault> &told, std::size_t begin) {
    if (const auto *fault = std::get_if<FormulaFault>(&told))
      return fail(fault->sentence, std::max(fault->at, begin), 1);
    m_entry.content = Object(std::get<Told>(told));
  }

  void readValue() {
    const std::size_t begin = m_reader.at();
    Formula formula = m_reader.sum();
    if (hasFault())
      return;
    if (const auto line =
            parametricOf(formula, [&](const std::string &name) { return !m_names.value(name); }))
      return readParametric(*line);
    if (m_isOfAnyPoint)
      return fail(words("Behind X = a line is needed, as A + t v."), begin, textEnd() - begin);
    auto named = namedIn(std::move(formula), m_names);
    if (auto *fault = std::get_if<TypedFault>(&named)) {
      m_fault = std::move(*fault);
      return;
    }
    const Argument value{std::get<Formula>(std::move(named)), begin, textEnd() - begin};
    const auto shape = shapeIn(value.formula, m_names);
    if (const auto *fault = std::get_if<TypedFault>(&shape))
      m_fault = *fault;
    else if (std::get<FormulaShape>(shape) == FormulaShape::Number)
      makeNumber(value);
    else if (namesPoint(m_entry.name))
      put(*findKind(PointObject::kind), {value});
    else
      put(*findKind(VectorObject::kind), {{formulaOf(ExactVec3(0))}, value});
  }

  void readParametric(const ParametricLine &line) {
    const std::string &t = line.parameter;
    const Argument start = argumentOf(line.start);
    const Argument direction = argumentOf(line.direction);
    if (m_reader.takeSeparator()) {
      const std::size_t at = m_reader.at();
      if (takeAtLeastZero(m_reader, t))
        return put(*findKind(RayObject::kind), {start, direction});
      if (takeUnitInterval(m_reader, t))
        return put(
            *findKind("segment"),
            {start, argumentOf({FormulaKind::Sum, {}, {}, {line.start, line.direction}, line.start.at})});
      m_reader.goTo(at);
      if (!isLookNext(m_reader))
        return fail(words("Here {ray} or {segment} can stand.",
                          {{"ray", t + " >= 0"}, {"segment", "0 <= " + t + " <= 1"}}),
                    at, m_line.size() - at);
      m_isLookNext = true;
    }
    const bool isRay = m_entry.name.front() == 'r' || m_entry.name.front() == 'R';
    put(*findKind(isRay ? RayObject::kind : LineObject::kind), {start, direction});
  }

  /// A number, with bounds where it moves.
  void makeNumber(const Argument &argument) {
    put(*findKind(NumberObject::kind), {argument});
    const auto *object = std::get_if<Object>(&m_entry.content);
    if (hasFault() || !object)
      return; // what follows others has no bounds
    const Rational value = (*object)[0].x;
    NumberObject number{value, std::min(value, Rational(-usualBound)), std::max(value, usualBound),
                        usualStep};
    readBounds(number);
    m_entry.content = Object(number);
  }

  void readBounds(NumberObject &number) {
    while (!hasFault() && m_reader.takeSeparator()) {
      const std::size_t at = m_reader.at();
      if (m_reader.take("step"))
        number.step = numberHere();
      else if (isLookNext(m_reader)) {
        m_isLookNext = true;
        return;
      } else {
        number.from = numberHere();
        if (!hasFault() && !(takeLess(m_reader) && m_reader.take(m_entry.name) && takeLess(m_reader)))
          return fail(words("Here bounds can stand, as 0 <= {name} <= 5, or a step, as step 1/2.",
                            {{"name", m_entry.name}}),
                      at, m_line.size() - at);
        number.to = numberHere();
      }
    }
  }

  Rational numberHere() {
    const Argument argument = argumentOf(m_reader.sum());
    const auto shape = shapeIn(argument.formula, m_names);
    const auto *found = std::get_if<FormulaShape>(&shape);
    if (hasNames(argument.formula) || !found || *found != FormulaShape::Number) {
      fail(words("Here a number is needed."), argument.at, argument.length);
      return {};
    }
    const auto value = constantOf(argument);
    if (const auto *fault = std::get_if<TypedFault>(&value)) {
      fail(fault->sentence, fault->at, fault->length);
      return {};
    }
    return std::get<ExactVec3>(value).x;
  }

  // --- the look

  void readLook() {
    while (!hasFault() && (std::exchange(m_isLookNext, false) || m_reader.take(",") || m_reader.take(";")))
      readLookWord();
  }

  void readLookWord() {
    const std::size_t at = m_reader.at();
    const std::string word(m_reader.takeName());
    if (!setLook(m_entry, word))
      fail(words("“{name}” is not a colour, and nothing else that can stand here.", {{"name", word}}), at,
           word.size());
  }

  /// Says what keeps the whole from being an entry, as its scene sees it.
  void checkWhole() {
    SceneChecker checker;
    for (const Entry &entry : m_above.entries)
      if (checker.check(entry))
        return; // that is no matter of this line
    if (const auto problem = checker.check(m_entry))
      fail(problem->sentence, 0, m_line.size());
  }

  std::string_view m_line;
  const Scene &m_above;
  SceneNames m_names;
  FormulaReader m_reader;
  Entry m_entry;
  bool m_isLookNext = false;
  bool m_isOfAnyPoint = false; ///< X = … was read
  std::optional<TypedFault> m_fault;
};

} // namespace

std::variant<Entry, TypedFault> readLine(std::string_view line, const Scene &above, char decimalMark) {
  return LineReader(line, above, decimalMark).read();
}

} // namespace halfspace
