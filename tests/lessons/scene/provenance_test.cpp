#include "lessons/scene/provenance.h"

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "tests/lessons/called_line.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <functional>

namespace halfspace {
namespace {

using test::called;
using Ids = std::set<std::string>;

/// Calls `visit` for each number of the term that can be asked.
void forEachNumber(const Term &term, const std::function<void(const Term &)> &visit) {
  if (isTraceable(term))
    return visit(term);
  for (const Term &part : term->parts)
    forEachNumber(part, visit);
}

const WorkingLine &lineOf(const Working &working, const std::string &id) {
  for (const WorkingLine &line : working.lines)
    if (line.id == id)
      return line;
  throw std::out_of_range("no line " + id);
}

std::vector<Term> numbersOf(const Working &working, const std::string &line) {
  std::vector<Term> numbers;
  for (const Chain &chain : lineOf(working, line).chains)
    for (const Term &side : chain.sides())
      forEachNumber(side, [&](const Term &number) { numbers.push_back(number); });
  return numbers;
}

/// The first of the line's numbers that reads so.
Provenance provenanceOf(const Working &working, const std::string &line, const std::string &text) {
  for (const Term &number : numbersOf(working, line))
    if (plainText(number) == text)
      return provenanceOf(number, line, working);
  ADD_FAILURE() << line << " has no " << text;
  return {};
}

/// What the coordinates are called: E.1, or E.1.x for a single number.
Ids textOf(const std::vector<CoordinateSource> &coordinates) {
  Ids texts;
  for (const CoordinateSource &each : coordinates)
    texts.insert(each.object + "." + std::to_string(each.coordinate) +
                 (each.component ? std::string(".") + "xyz"[*each.component] : ""));
  return texts;
}

Working distanceWorking() { return workingOf(evaluate(test::distanceScene())); }

Working rayTriangleWorking() {
  return workingOf(evaluate({{test::triangleT(),
                              test::rayL(),
                              {"hit", ConstructionUse{"ray-triangle-perp", {{"T", "T"}, {"L", "L"}}}}}}));
}

TEST(Provenance, OfAResult_IsWhatItsFormulaIsMadeOf) {
  const Provenance f = provenanceOf(distanceWorking(), "distance.f", "30");
  EXPECT_EQ(f.lines, Ids{});
  EXPECT_EQ(f.marks, (Ids{"E.P0", "E.n", "Q"}));
  EXPECT_EQ(textOf(f.coordinates), (Ids{"E.0", "E.1", "Q.0"}));
}

TEST(Provenance, OfANumberPutIn_GoesThroughTheLineThatTellsIt) {
  const Provenance f = provenanceOf(distanceWorking(), "distance.distance", "30");
  EXPECT_EQ(f.lines, Ids{"distance.f"}) << "f(Q) > 0 tells nothing of f(Q)";
  EXPECT_EQ(textOf(f.coordinates), (Ids{"E.0", "E.1", "Q.0"}));
  const Provenance length = provenanceOf(distanceWorking(), "distance.distance", "3");
  EXPECT_EQ(length.lines, Ids{"distance.length"});
  EXPECT_EQ(length.marks, Ids{"E.n"});
  EXPECT_EQ(textOf(length.coordinates), Ids{"E.1"});
}

TEST(Provenance, OfACoordinate_IsThatNumberAndItsMark) {
  const Provenance x = provenanceOf(distanceWorking(), "distance.length", "1");
  EXPECT_EQ(x.lines, Ids{});
  EXPECT_EQ(x.marks, Ids{"E.n"});
  EXPECT_EQ(textOf(x.coordinates), Ids{"E.1.x"});
}

TEST(Provenance, OfANameThatNoLineTells_IsWhatTheNameStandsFor) {
  const Provenance w = provenanceOf(distanceWorking(), "distance.cosine", "30");
  EXPECT_EQ(w.lines, Ids{});
  EXPECT_EQ(w.marks, (Ids{"E.P0", "E.n", "Q", "distance.w"}));
}

TEST(Provenance, OfALongWorking_GoesThroughAllLinesBetween) {
  const Working working = rayTriangleWorking();
  const Term s = lineOf(working, "hit.s").chains.front().last();
  const Provenance found = provenanceOf(s, "hit.s", working);
  for (const char *line : {"wu", "wv", "uv", "vv", "denominator", "w", "hit", "plane-t", "normal", "u", "v"})
    EXPECT_TRUE(found.lines.contains(std::string("hit.") + line)) << line;
  for (const char *line : {"t", "place", "a", "b", "similar"})
    EXPECT_FALSE(found.lines.contains(std::string("hit.") + line)) << line;
  EXPECT_EQ(textOf(found.coordinates), (Ids{"T.0", "T.1", "T.2", "L.0", "L.1"}));
}

TEST(Provenance, OfLinesThatTellEachOther_Ends) {
  const Term a = name(letter("a"), Rational(3));
  const Term b = name(letter("b"), Rational(3));
  const Term P = given(letter("P"), ExactVec3(3, 0, 0), "P", 0).marked("P");
  const Working working{{called("a", line(a == b)), called("b", line((b == a) == norm(P))),
                         called("other", line(withResult(2 * a)))}};
  const Provenance found = provenanceOf(calculated(a), "other", working);
  EXPECT_EQ(found.lines, (Ids{"a", "b"}));
  EXPECT_EQ(found.marks, Ids{"P"});
}

TEST(Provenance, OfATermThatALineCompares_IsNotThatLine) {
  const Term a = name(letter("a"), Rational(3));
  const Working working{
      {called("compared", line(compared(a, 0))), called("condition", line(condition(a == 0)))}};
  EXPECT_EQ(provenanceOf(calculated(a), "compared", working).lines, Ids{});
}

TEST(Provenance, OfNumbersThatStandInTheFormula_IsNotAsked) {
  EXPECT_FALSE(isTraceable(Term(2)));
  EXPECT_FALSE(isTraceable(given(letter("Q"), ExactVec3(1, 2, 3), "Q", 0)));
  EXPECT_TRUE(isTraceable(calculated(name(letter("a"), Rational(3)))));
}

void expectWithin(const Provenance &found, const Scene &scene, const Working &working,
                  const std::string &place) {
  EXPECT_FALSE(found.coordinates.empty()) << place;
  for (const CoordinateSource &coordinate : found.coordinates)
    EXPECT_TRUE(coordinateOf(scene, coordinate)) << place;
  for (const std::string &id : found.lines)
    EXPECT_NO_THROW((void)lineOf(working, id)) << place;
}

/// Every number that was calculated reaches a coordinate of the scene.
void expectAllReachCoordinates(const Scene &scene, const std::string &where) {
  const Working working = workingOf(evaluate(scene));
  for (const WorkingLine &line : working.lines)
    for (const Term &number : numbersOf(working, line.id))
      expectWithin(provenanceOf(number, line.id, working), scene, working,
                   where + ", line " + line.id + ", " + plainText(number));
}

TEST(Provenance, OfEveryNumberOfEveryLesson_ReachesACoordinate) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    expectAllReachCoordinates(lesson.scene, lesson.id);
}

TEST(Provenance, OfADegenerateScene_ReachesACoordinateToo) {
  Scene scene = test::distanceScene();
  test::setCoordinate(scene, {"E", 1}, ExactVec3(0));
  expectAllReachCoordinates(scene, "zero normal");
  expectAllReachCoordinates({{{"E", PlaneObject{{5, 4, 7}, {0, 0, 2}}},
                              {"plane", ConstructionUse{"plane-implicit", {{"E", "E"}}}}}},
                            "level plane");
  expectAllReachCoordinates({{{"T", TriangleObject{{1, 1, 1}, {1, 1, 1}, {5, 2, 9}}},
                              test::rayL(),
                              {"hit", ConstructionUse{"ray-triangle-perp", {{"T", "T"}, {"L", "L"}}}}}},
                            "coincident corners");
}

/// All names in the term, and in what they stand for.
void expectNamesStandForTheirValue(const Term &term) {
  if (term->origin && term->kind != TermKind::Number) {
    EXPECT_TRUE(areEqual(*term->value, *(*term->origin)->value).value_or(false)) << plainText(term);
  }
  for (const Term &part : term->parts)
    expectNamesStandForTheirValue(part);
}

TEST(Provenance, OfAName_HasTheNamesValue) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    for (const WorkingLine &line : workingOf(evaluate(lesson.scene)).lines)
      for (const Chain &chain : line.chains)
        for (const Term &side : chain.sides())
          expectNamesStandForTheirValue(side);
}

TEST(Provenance, OfWhatAnotherEntryMade_GoesThroughTheLinesOfThatEntry) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"G", PlaneObject{{0, 0, 0}, {0, 0, 1}}});
  scene.entries.push_back({"beyond", ConstructionUse{"signed-distance", {{"E", "G"}, {"Q", "distance.F"}}}});
  const Working working = workingOf(evaluate(scene));
  const Provenance found =
      provenanceOf(lineOf(working, "beyond.f").chains.front().last(), "beyond.f", working);
  EXPECT_EQ(found.lines, (Ids{"distance.f", "distance.foot"}))
      << "not lines that read alike of its own entry";
  EXPECT_EQ(textOf(found.coordinates), (Ids{"E.0", "E.1", "G.0", "G.1", "Q.0"}));
}

TEST(CoordinateOf, AFreeObjectsCoordinate_IsFoundByTheObject) {
  const Scene scene = test::distanceScene();
  EXPECT_EQ(coordinateOf(scene, {"E", 1, 2}), (CoordinateId{"E", 1}));
  EXPECT_EQ(coordinateOf(scene, {"E", 2, 0}), std::nullopt);
  EXPECT_EQ(coordinateOf(scene, {"distance", 0, 0}), std::nullopt);
  EXPECT_EQ(coordinateOf(scene, {"L", 0, 0}), std::nullopt);
}

} // namespace
} // namespace halfspace
