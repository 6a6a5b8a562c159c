// What every construction promises, checked on thousands of scenes: its values by a second calculation, its
// worked lines by calculating what they say, its figure by the places that it names.
#include "tests/lessons/construction/construction_ids.h"
#include "tests/lessons/construction/expected/expected.h"
#include "tests/lessons/construction/precise.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/construction/same_numbers.h"
#include "tests/test_name.h"

#include "geometry/surd.h"
#include "lessons/construction/reference.h"
#include "lessons/files/read_file.h"
#include "lessons/lesson/lesson.h"
#include "lessons/lesson/practice.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/reading/typed_answer.h"
#include "lessons/term/plain_text.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace halfspace {
namespace {

using namespace test;

constexpr int scenesPerWriting = effort(100);
/// As many as it takes to come to every name of every construction.
constexpr int scenesForAllNames = 250;

/// Two results of a hundred digits are the same when they agree to far more than any number on the page has.
const Precise sameDigits("1e-60");
/// A number shown with six digits is this near at least.
const Precise roundedDigits("1e-5");

bool agree(const Numbers &a, const Numbers &b, const Precise &tolerance) {
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (mp::abs(Precise(a[i] - b[i])) >
        tolerance * std::max({Precise(mp::abs(a[i])), Precise(mp::abs(b[i])), Precise(1)}))
      return false;
  return true;
}

Numbers zeroLike(const Numbers &other) { return Numbers(other.size(), Precise(0)); }

std::string textOf(const Object &object) {
  std::string text(kindOf(object));
  for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i) {
    const ExactVec3 &at = coordinate(object, i);
    text += " (" + toText(at.x) + ", " + toText(at.y) + ", " + toText(at.z) + ")";
  }
  return text;
}

/// What came up of the names that a construction declares: cases as `case = hit`, values, also as `side =
/// on`, lines and marks.
using NamesSeen = std::set<std::string>;

void addNames(const std::vector<ValueName> &values, const std::string &group, NamesSeen &names) {
  for (const ValueName &value : values) {
    const std::string name = group + value.name;
    names.insert("value " + name);
    for (const std::string &word : value.words)
      names.insert("value " + name + " = " + word);
    addNames(value.members, name + ".", names);
  }
}

NamesSeen declaredNames(const ConstructionNames &declared) {
  NamesSeen names;
  for (const std::string &name : declared.cases)
    names.insert("case = " + name);
  for (const std::string &name : declared.lines)
    names.insert("line " + name);
  for (const std::string &name : declared.marks)
    names.insert("mark " + name);
  addNames(declared.values, "", names);
  return names;
}

std::ptrdiff_t casesIn(const NamesSeen &names) {
  return std::count_if(names.begin(), names.end(),
                       [](const std::string &name) { return name.starts_with("case = "); });
}

/// One scene and everything that is promised of its outcome.
class Contract {
public:
  Contract(const Construction &construction, const std::vector<Object> &objects)
      : m_construction(construction) {
    std::vector<const Object *> pointers;
    for (const Object &object : objects) {
      pointers.push_back(&object);
      m_text += textOf(object) + "; ";
    }
    m_scene = sceneOf(construction, objects);
    m_evaluation = evaluate(m_scene);
    m_working = workingOf(m_evaluation);
    m_figure = figureOf(m_evaluation);
    m_expected = expectedOf(construction).recompute(pointers);
  }

  const Working &working() const { return m_working; }
  const std::string &caseName() const { return outcome().told->name; }

  void check() {
    SCOPED_TRACE(std::string(m_construction.id) + ": " + m_text);
    checkCase();
    checkValues(*outcome().values, "");
    EXPECT_EQ(m_checked.size(), m_expected.values.size()) << "values that the case has, and no others";
    checkWorking();
    checkFigure();
    checkMarks();
    checkObjects();
    checkNearby();
    checkRepetition();
  }

  /// The names that have come up in this scene.
  NamesSeen namesSeen() const {
    NamesSeen names{"case = " + caseName()};
    for (const std::string &id : outcome().explanation->ids())
      names.insert("line " + id);
    for (const Mark &mark : outcome().figure->marks)
      names.insert("mark " + std::string(leadingId(baseOf(mark)).substr(std::string_view("it.").size())));
    addSeen(*outcome().values, m_construction.names.values, "", names);
    return names;
  }

  /// Only that the case is right and that all can be drawn.
  void checkFinite() const {
    SCOPED_TRACE(std::string(m_construction.id) + ": " + m_text);
    checkCase();
    checkFigure();
    for (const SpecialCase &special : *outcome().nearby)
      EXPECT_FALSE(special.sentence.empty());
  }

private:
  static void expectPlainWords(const std::string &sentence) {
    EXPECT_EQ(sentence.find('\\'), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('{'), std::string::npos) << "every value is filled in: " << sentence;
    EXPECT_EQ(sentence.find("  "), std::string::npos) << sentence;
  }

  void checkCase() const {
    expectPlainWords(outcome().told->description);
    EXPECT_EQ(caseName(), m_expected.caseName);
    EXPECT_EQ(outcome().told->degenerate, m_expected.degenerate);
    EXPECT_FALSE(outcome().told->description.empty());
    EXPECT_EQ(outcome().told->description.find('{'), std::string::npos) << outcome().told->description;
  }

  void checkValues(const std::vector<NamedValue> &values, const std::string &group) {
    for (const NamedValue &value : values) {
      const std::string name = group + value.name;
      if (const auto *label = std::get_if<Term>(&value.label))
        checkMarksOf({value.name, {*label}});
      if (const auto *members = std::get_if<std::vector<NamedValue>>(&value.value)) {
        checkValues(*members, name + ".");
        continue;
      }
      ASSERT_TRUE(m_checked.insert(name).second) << name << " stands twice";
      const auto expected = m_expected.values.find(name);
      ASSERT_NE(expected, m_expected.values.end()) << name << " has no meaning in this case";
      checkValue(name, value.value, expected->second);
    }
  }

  template <class Expected>
  static void checkValue(const std::string &name, const Value &value, const Expected &expected) {
    if (const auto *number = std::get_if<Surd>(&value))
      EXPECT_TRUE(areSame({*number}, expected)) << name;
    else if (const auto *numbers = std::get_if<std::vector<Surd>>(&value))
      EXPECT_TRUE(areSame(*numbers, expected)) << name;
    else if (const auto *word = std::get_if<Word>(&value))
      EXPECT_EQ(word->name, std::get<std::string>(expected)) << name;
    else
      EXPECT_EQ(std::get<int>(value), std::get<int>(expected)) << name;
  }

  void checkWorking() const {
    std::set<std::string> ids;
    for (const WorkingLine &line : m_working.lines) {
      SCOPED_TRACE(line.id + ": " + latexOf(line));
      EXPECT_TRUE(ids.insert(line.id).second) << "an id stands once";
      checkMarksOf(line);
      expectPlainWords(line.sentence);
      for (const auto &chain : chainsOf(latexOf(line)))
        checkChain(chain, solutionOf(line));
      checkRelations(line);
      if (line.asked != Asked::Nothing)
        checkAsked(line);
      checkGaps(line);
    }
  }

  /// What the line claims follows from what its terms come to: only a demand may be wrong, and is where no
  /// unknown is left.
  static void checkRelations(const WorkingLine &line) {
    for (const Chain &chain : line.chains) {
      const std::vector<Relation> relations = chain.relations();
      const Real *demanded = chain.sides().size() > 1 ? numberOf(chain.sides()[1]) : nullptr;
      const bool isWrong =
          !chain.isIdentity() && demanded && readAlike(chain.sides()[0], Term(0)) && sign(*demanded) != 0;
      for (std::size_t i = 0; i < relations.size(); ++i)
        EXPECT_TRUE(relations[i] != Relation::Unequal || (i == 0 && isWrong)) << plainText(chain);
    }
  }

  /// What is asked can be answered, and no mistake is praised.
  void checkAsked(const WorkingLine &line) const {
    EXPECT_TRUE(hasNumbers(line)) << "there is nothing to leave out";
    const Gap gap = resultGap(line);
    const TermValue &truth = *gap.hidden->value;
    if (const auto typed = typedText(truth)) {
      EXPECT_TRUE(judge(line, gap, *typed).right) << *typed;
    }
    if (!truth.entries.front().hasUnknowns())
      checkAnswer(line, truth);
    for (const WrongTerm &mistake : line.mistakes) {
      EXPECT_NE(mistake.sentence.find("{answer}"), std::string::npos) << mistake.sentence;
      checkMistake(line, gap, mistake);
    }
  }

  /// Every number of a line can be left out and be answered.
  static void checkGaps(const WorkingLine &line) {
    for (const Gap &gap : numberGaps(askedChain(line)))
      if (const auto typed = typedText(*gap.hidden->value)) {
        EXPECT_TRUE(judge(line, gap, *typed).right) << *typed;
      }
  }

  /// 2/3 x + 2*sqrt(3), (1, 2): the value as a learner may type it; nothing where it is too long.
  static std::optional<std::string> typedText(const TermValue &value) {
    std::string list;
    for (const Polynomial &entry : value.entries) {
      const auto text = typedText(entry);
      if (!text)
        return {};
      list += (list.empty() ? "" : ", ") + *text;
    }
    list = value.isList ? "(" + list + ")" : list;
    return list.size() <= longestAnswer ? std::optional(list) : std::nullopt;
  }

  static std::optional<std::string> typedText(const Polynomial &value) {
    auto text = toText(*value.constant().exact());
    for (const Polynomial::Summand &summand : value.summands())
      if (const auto factor = toText(*summand.factor.exact()); factor && text)
        *text += std::accumulate(summand.monomial.begin(), summand.monomial.end(), " + (" + *factor + ")");
      else
        return {};
    return text;
  }

  void checkAnswer(const WorkingLine &line, const TermValue &truth) const {
    const Side last = chainsOf(latexOf(line)).back().back();
    const Numbers answer = calculate(last.latex, m_expected.names);
    std::vector<Quantity> asked;
    for (const Polynomial &entry : truth.entries)
      asked.push_back(quantity(*entry.constant().exact()));
    EXPECT_TRUE(agree(answer, together(asked)->numbers, last.relation == '=' ? sameDigits : roundedDigits))
        << last.latex;
  }

  /// A mistake that can be typed is told by its own sentence, or by an earlier one that comes to the same.
  static void checkMistake(const WorkingLine &line, const Gap &gap, const WrongTerm &mistake) {
    const auto &wrong = mistake.wrong->value;
    const auto typed = wrong && isExact(*wrong) ? typedText(*wrong) : std::nullopt;
    if (!typed || areEqual(*wrong, *gap.hidden->value) == true)
      return;
    const Judgement judgement = judge(line, gap, *typed);
    EXPECT_TRUE(!judgement.right || line.asked == Asked::Equation) << *typed << " is no multiple";
    EXPECT_FALSE(judgement.sentence.ends_with("once more."))
        << *typed << " is not told: " << judgement.sentence;
  }

  /// Calculates every side of `a = b = c`. An equation `0 = …` holds at its solution, and its sides say the
  /// same anywhere.
  void checkChain(const std::vector<Side> &chain, const std::optional<Names> &solution) const {
    Names names = m_expected.names;
    if (chain.front().latex != "0")
      return checkSides(chain, names, solution.value_or(Names{}));
    if (chain.size() > 1 && std::string_view("?<>").find(chain[1].relation) != std::string_view::npos)
      return checkSides(chain, names, m_expected.unknowns); // nothing fulfils it, or 0 is compared
    // Anywhere else the first exact side says what the others should.
    const auto exact =
        std::find_if(chain.begin(), chain.end(), [](const Side &side) { return side.relation == '='; });
    if (exact != chain.end())
      checkSides({exact, chain.end()}, names, m_expected.unknowns);
    if (solution)
      checkSides(chain, names, *solution);
  }

  /// Where the line's equation holds, if anywhere.
  std::optional<Names> solutionOf(const WorkingLine &line) const {
    const auto own = m_expected.solutions.find(line.id.substr(std::string_view("it.").size()));
    return own == m_expected.solutions.end() ? m_expected.solution : std::optional(own->second);
  }

  static void checkSides(const std::vector<Side> &sides, Names names, const Names &unknowns) {
    for (const auto &[name, value] : unknowns)
      names[name] = value; // the t of an equation, the x, y, z
    Numbers first = calculate(sides.front().latex, names);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Side &side = sides[i];
      const Numbers value = calculate(side.latex, names);
      const bool isLast = i + 1 == sides.size();
      if (side.relation == '=') {
        EXPECT_TRUE(agree(first, value, sameDigits)) << "not equal: " << side.latex;
      } else if (side.relation == '~' && isLast && isOneValue(side.latex)) {
        EXPECT_TRUE(agree(first, value, roundedDigits)) << "not near: " << side.latex;
      } else if (side.relation == '?') {
        EXPECT_FALSE(agree(first, value, sameDigits)) << "equal: " << side.latex;
        first = value;
      } else if (side.relation == '<') {
        EXPECT_LT(first.at(0), value.at(0));
        first = value;
      } else if (side.relation == '>') {
        EXPECT_GT(first.at(0), value.at(0));
        first = value;
      }
    }
  }

  /// Whether nothing is subtracted in it, so that its roundings cannot grow.
  static bool isOneValue(const std::string &latex) {
    return latex.find_first_of("xyz+#") == std::string::npos && latex.find("-", 1) == std::string::npos;
  }

  void checkMarksOf(const WorkingLine &line) const {
    for (const std::string &id : marksIn(line))
      EXPECT_TRUE(findMark(m_figure, id) || m_expected.vanished.contains(id)) << "no mark " << id;
  }

  static std::vector<Place> placesOf(const Mark &mark) {
    return std::visit(
        Overloaded{[](const PointMark &m) { return std::vector{m.at}; },
                   [](const SegmentMark &m) {
                     return std::vector{m.from, m.to};
                   },
                   [](const RayMark &m) {
                     return std::vector{m.origin, m.direction, m.meets.value_or(Place(0)), endOf(m)};
                   },
                   [](const LineMark &m) {
                     const auto [low, high] = endsOf(m);
                     return std::vector{m.through, m.direction, low, high};
                   },
                   [](const ArrowMark &m) {
                     return std::vector{m.from, m.vector};
                   },
                   [](const PlanePatchMark &m) {
                     std::vector<Place> places = cornersOf(m);
                     places.insert(places.end(), m.covers.begin(), m.covers.end());
                     return places;
                   },
                   [](const PolygonMark &m) { return m.corners; },
                   [](const SphereMark &m) {
                     return std::vector{m.center, Place(m.radius)};
                   },
                   [](const MeshMark &m) {
                     return std::vector{m.box.first, m.box.second, m.place, m.axes[0], m.axes[1], m.axes[2]};
                   },
                   [](const ArcMark &m) {
                     return std::vector{m.center, m.from, m.to};
                   },
                   [](const RightAngleMark &m) {
                     return std::vector{m.at, m.first, m.second};
                   }},
        mark);
  }

  void checkFigure() const {
    std::set<std::string> ids;
    for (const Mark &mark : m_figure.marks) {
      const MarkBase &base = baseOf(mark);
      EXPECT_TRUE(ids.insert(base.id).second) << base.id << " stands twice";
      for (const Place &place : placesOf(mark))
        EXPECT_TRUE(isFinite(place)) << base.id;
    }
  }

  void checkMarks() const {
    for (const Mark &mark : m_figure.marks) {
      if (const auto *point = std::get_if<PointMark>(&mark))
        checkPoint(*point);
      if (const auto *arrow = std::get_if<ArrowMark>(&mark))
        checkArrow(*arrow);
    }
  }

  /// The point stands where its label says.
  void checkPoint(const PointMark &mark) const {
    if (mark.label.empty())
      return;
    const Numbers named = calculate(mark.label, m_expected.names);
    ASSERT_EQ(named.size(), 3U) << mark.id;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_DOUBLE_EQ(mark.at[static_cast<int>(i)], named[i].convert_to<double>()) << mark.id;
    }
  }

  /// The arrow points where its label says; how long it is drawn is the figure's choice.
  void checkArrow(const ArrowMark &mark) const {
    if (mark.label.empty())
      return;
    const Numbers named = calculate(mark.label, m_expected.names);
    ASSERT_EQ(named.size(), 3U) << mark.id;
    const Numbers drawn{mark.vector.x, mark.vector.y, mark.vector.z};
    const Names both{{"a", quantity(drawn)}, {"b", quantity(named)}};
    const Precise lengths = calculate("[a]*[b]", both)[0];
    EXPECT_LE(mp::abs(Precise(calculate("a*b", both)[0] - lengths)), lengths * Precise("1e-12")) << mark.id;
    EXPECT_EQ(named == zeroLike(named), drawn == zeroLike(drawn)) << mark.id;
  }

  /// What it makes is of the kind that it says, and stands where its letter says.
  void checkObjects() const {
    for (const MadeObject &made : outcome().objects) {
      const auto &makes = m_construction.makes;
      const auto known =
          std::find_if(makes.begin(), makes.end(), [&](const auto &each) { return each.name == made.name; });
      ASSERT_NE(known, makes.end()) << made.name;
      EXPECT_EQ(kindOf(made.object), known->kind);
      const std::string id = "it." + made.name;
      EXPECT_TRUE(findMark(m_figure, id)) << id;
      const auto specs = coordinatesOf(made.object);
      for (std::size_t i = 0; i < specs.size(); ++i)
        if (const Mark *mark = findMark(m_figure, coordinateId(id, specs[i]))) {
          const Numbers named = calculate(baseOf(*mark).label, m_expected.names);
          EXPECT_TRUE(agree(named, quantity(coordinate(made.object, i))->numbers, sameDigits))
              << baseOf(*mark).id;
        } else {
          EXPECT_TRUE(m_expected.vanished.contains(coordinateId(id, specs[i])));
        }
    }
  }

  /// Values have the shapes that are declared of them.
  static void addSeen(const std::vector<NamedValue> &values, const std::vector<ValueName> &declared,
                      const std::string &group, NamesSeen &names) {
    for (const NamedValue &value : values) {
      const std::string name = group + value.name;
      names.insert("value " + name);
      const auto known = std::find_if(declared.begin(), declared.end(),
                                      [&](const ValueName &each) { return each.name == value.name; });
      ASSERT_NE(known, declared.end()) << name;
      EXPECT_EQ(shapeOf(value.value), known->shape) << name;
      if (const auto *numbers = std::get_if<std::vector<Surd>>(&value.value)) {
        EXPECT_LE(numbers->size(), known->length) << name;
      }
      if (const auto *word = std::get_if<Word>(&value.value))
        names.insert("value " + name + " = " + word->name);
      if (const auto *members = std::get_if<std::vector<NamedValue>>(&value.value))
        addSeen(*members, known->members, name + ".", names);
    }
  }

  static ValueShape shapeOf(const Value &value) {
    return std::visit(Overloaded{[](const Surd &) { return ValueShape::Number; },
                                 [](const std::vector<Surd> &) { return ValueShape::List; },
                                 [](const Word &) { return ValueShape::Word; },
                                 [](int) { return ValueShape::Index; },
                                 [](const std::vector<NamedValue> &) { return ValueShape::Group; }},
                      value);
  }

  /// Each special case is one change away, and is not there yet. What is beyond the limits of coordinates is
  /// not offered.
  void checkNearby() const {
    for (const SpecialCase &special : *outcome().nearby) {
      SCOPED_TRACE(special.sentence);
      expectPlainWords(special.sentence);
      ASSERT_FALSE(special.when.empty());
      const Task task{special.sentence, special.when};
      EXPECT_FALSE(isDone(task, m_evaluation)) << "it holds already";
      ASSERT_NE(special.object.has_value(), special.rootedWay.has_value());
      EXPECT_GT(special.rootedWay.value_or(Surd(1)), Surd(0));
      if (!special.object || refusedCoordinateOf(*special.object))
        continue;
      const auto &use = std::get<ConstructionUse>(m_scene.entries.back().content);
      const Scene changed =
          edited(m_scene, {ChangeObject{use.roles.at(special.role).ids.at(special.place), *special.object}});
      EXPECT_TRUE(isDone(task, evaluate(changed)));
    }
  }

  void checkRepetition() const {
    const Evaluation again = evaluate(m_scene);
    EXPECT_EQ(lastOutcome(again).told->name, caseName());
    EXPECT_EQ(lastOutcome(again).told->description, outcome().told->description);
    const Working working = workingOf(again);
    ASSERT_EQ(working.lines.size(), m_working.lines.size());
    for (std::size_t i = 0; i < working.lines.size(); ++i) {
      EXPECT_EQ(latexOf(working.lines[i]), latexOf(m_working.lines[i]));
    }
    const Figure figure = figureOf(again);
    ASSERT_EQ(figure.marks.size(), m_figure.marks.size());
    for (std::size_t i = 0; i < figure.marks.size(); ++i) {
      EXPECT_EQ(baseOf(figure.marks[i]).id, baseOf(m_figure.marks[i]).id);
      EXPECT_EQ(placesOf(figure.marks[i]), placesOf(m_figure.marks[i]));
    }
  }

  const Outcome &outcome() const { return lastOutcome(m_evaluation); }

  const Construction &m_construction;
  std::string m_text;
  Scene m_scene;
  Evaluation m_evaluation;
  Working m_working;
  Figure m_figure;
  Recomputed m_expected;
  std::set<std::string> m_checked;
};

bool isRounded(const Working &working) {
  return std::any_of(working.lines.begin(), working.lines.end(), [](const WorkingLine &line) {
    return latexOf(line).find("\\approx") != std::string::npos;
  });
}

class EveryConstruction : public testing::TestWithParam<std::string> {
protected:
  const Construction &construction() const { return *findConstruction(GetParam()); }

  /// Checks many scenes; the names that came up.
  NamesSeen checkScenes(Writing writing, int count = scenesPerWriting) {
    RandomObjects random(20'240'000 + static_cast<std::uint64_t>(writing));
    NamesSeen names;
    for (int i = 0; i < count && !HasFailure(); ++i) {
      const std::vector<Object> objects = random.objectsFor(construction(), writing);
      Contract contract(construction(), objects);
      contract.check();
      names.merge(contract.namesSeen());
      m_isAnyRounded = m_isAnyRounded || isRounded(contract.working());
    }
    return names;
  }

  /// Checks many scenes, of several cases where they are as many as they should be.
  void checkScenesOfSeveralCases(Writing writing) {
    const NamesSeen names = checkScenes(writing);
    if (!isWatched) {
      EXPECT_GT(casesIn(names), 1);
    }
  }

  bool m_isAnyRounded = false; ///< of the scenes that were checked
};

TEST_P(EveryConstruction, OnSmallIntegers_IsRightAndComesToAllThatItNames) {
  const NamesSeen seen = checkScenes(Writing::SmallIntegers, effort(scenesForAllNames));
  if (isWatched)
    return; // too few to come to all
  EXPECT_EQ(seen, declaredNames(construction().names));
}

TEST_P(EveryConstruction, OnHalves_IsRight) { checkScenesOfSeveralCases(Writing::Halves); }

TEST_P(EveryConstruction, OnDecimals_IsRight) { checkScenesOfSeveralCases(Writing::Decimals); }

TEST_P(EveryConstruction, OnFractions_IsRight) { checkScenesOfSeveralCases(Writing::Fractions); }

TEST_P(EveryConstruction, OnFractionsOfTwelveDigits_IsRightAndMarksWhatItRounds) {
  checkScenesOfSeveralCases(Writing::LongFractions);
  EXPECT_TRUE(m_isAnyRounded);
}

TEST_P(EveryConstruction, OnLargeIntegers_IsRight) { checkScenesOfSeveralCases(Writing::LargeIntegers); }

TEST(Contract, Titles_TellConstructionsOfTheSameObjectsApart) {
  std::set<std::pair<std::vector<std::string_view>, std::string>> titles;
  for (const Construction &construction : constructions()) {
    std::vector<std::string_view> kinds;
    for (const ConstructionRole &role : construction.roles)
      kinds.push_back(role.kind);
    EXPECT_FALSE(construction.title().empty()) << construction.id;
    EXPECT_TRUE(titles.emplace(std::move(kinds), construction.title()).second) << construction.id;
  }
}

TEST(Contract, TheDocumentedReference_IsThatOfTheProgram) {
  const auto written = readFile(DOCUMENTATION_FOLDER "/constructions.md", 1 << 20);
  ASSERT_TRUE(written) << written.problem().text();
  EXPECT_TRUE(*written == referenceOfConstructions()) << "halfspace constructions > docs/constructions.md";
}

/// Coordinates as long as they may be, and nearly the same: the smallest triangles and the farthest hits.
TEST_P(EveryConstruction, AtTheLimitsOfCoordinates_StaysFinite) {
  const Rational tiny = 1 / powerOfTen(coordinateDigits - 1);
  const Rational tinier = 1 / (powerOfTen(coordinateDigits - 1) + 7);
  const std::vector<Rational> all{0,    1,      coordinateLimit, Rational(-coordinateLimit),
                                  tiny, tinier, Rational(-tiny)};
  const std::vector<Rational> smallest{tiny, tinier, Rational(-tiny)};
  std::mt19937_64 engine(3);
  for (int i = 0; i < scenesPerWriting && !HasFailure(); ++i) {
    const auto any = [&] {
      const auto &numbers = i % 2 == 0 ? all : smallest;
      return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(engine)];
    };
    std::vector<Object> objects;
    for (const ConstructionRole &role : construction().roles)
      for (int count = role.isList ? 3 : 1; count > 0; --count) {
        const auto words = kindsSeenAs(role.kind);
        objects.push_back(*makeObject(words[static_cast<std::size_t>(i) / 2 % words.size()]));
        for (std::size_t index = 0; index < coordinatesOf(objects.back()).size(); ++index)
          coordinate(objects.back(), index) = {any(), any(), any()};
        objects.back().kind().settle(objects.back());
      }
    Contract(construction(), objects).checkFinite();
  }
}

TEST(Contract, TheStartOfEveryLesson_IsRightAndExactInEveryLine) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const EvaluatedEntry &entry : evaluate(lesson.scene).entries) {
      if (!entry.isConstruction())
        continue;
      std::vector<Object> objects;
      for (const auto &given : entry.looksAt)
        objects.push_back(given->object);
      Contract contract(*findConstruction(entry.construction), objects);
      contract.check();
      EXPECT_FALSE(isRounded(contract.working())) << lesson.id << ", " << entry.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Contract, EveryConstruction, testing::ValuesIn(test::constructionIds()),
                         test::testName);

} // namespace
} // namespace halfspace
