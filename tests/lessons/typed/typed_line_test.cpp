// Entries as lines that somebody types.
#include "lessons/construction/construction.h"
#include "lessons/lesson/condition.h"
#include "lessons/lesson/lesson.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/write_line.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// The scene after these lines.
Scene typed(const std::vector<std::string> &lines) {
  Scene scene;
  for (const std::string &line : lines) {
    auto entry = readLine(line, scene);
    if (const auto *fault = std::get_if<TypedFault>(&entry)) {
      ADD_FAILURE() << line << ": " << fault->sentence << " at " << fault->at;
      return scene;
    }
    scene.entries.push_back(std::get<Entry>(std::move(entry)));
  }
  return scene;
}

Object objectOf(const std::string &line) { return std::get<Object>(typed({line}).entries[0].content); }

ConstructionUse useOf(const Scene &scene) {
  return std::get<ConstructionUse>(scene.entries[scene.entries.size() - 1].content);
}

TEST(TypedLine, AsOnPaper_IsTheObject) {
  EXPECT_EQ(objectOf("Q = (11, 15, 8)"), Object(PointObject{{11, 15, 8}}));
  EXPECT_EQ(objectOf("Q = (1/2, -3 1/3, 0.25)"),
            Object(PointObject{{test::q(1, 2), test::q(-10, 3), test::q(1, 4)}}));
  EXPECT_EQ(objectOf("v=(1,2,3)"), Object(VectorObject{ExactVec3(0), {1, 2, 3}}));
  EXPECT_EQ(objectOf("E: x + 2y + 2z = 27"), Object(PlaneObject{{3, 6, 6}, {1, 2, 2}}));
  EXPECT_EQ(objectOf("E: 2(x + y) = 3z - 6 + y"), Object(PlaneObject{{-1, -1, 1}, {2, 1, -3}}));
  EXPECT_EQ(objectOf("g = (1, 2, 3) + t(4, 5, 6)"), Object(LineObject{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(objectOf("g = (1, 2, 3) - s(4, 5, 6)"), Object(LineObject{{1, 2, 3}, {-4, -5, -6}}));
  EXPECT_EQ(objectOf("r = (1, 2, 3) + t(4, 5, 6)"), Object(RayObject{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(objectOf("g = (1, 2, 3) + t(4, 5, 6), t >= 0"), Object(RayObject{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(kindOf(objectOf("s = (1, 2, 3) + t(4, 5, 6), 0 <= t <= 1")), "segment");
  EXPECT_EQ(objectOf("E = plane((0, 0, 1), (1, 0, 1), (0, 1, 1))"),
            Object(PlaneObject{{0, 0, 1}, {0, 0, 1}}));
  EXPECT_EQ(objectOf("k = 3/2"), Object(NumberObject{test::q(3, 2), -10, 10, test::q(1, 10)}));
  EXPECT_EQ(objectOf("k = 30, 0 <= k <= 50, step 1/2"), Object(NumberObject{30, 0, 50, test::q(1, 2)}));
  EXPECT_EQ(typed({"Q = (1, 2, 3), green"}).entries[0].color, Hue::Green);
  const Entry looking = typed({"Q = (1, 2, 3), locked, green, hidden"}).entries[0];
  EXPECT_TRUE(looking.isHidden && looking.isLocked && looking.color == Hue::Green);
  EXPECT_EQ(lineFor(looking), "Q = (1, 2, 3), green, hidden, locked");
  const Entry labelled = typed({"g = (1, 2, 3) + t(4, 5, 6), value, dotted"}).entries[0];
  EXPECT_EQ(labelled.line, LineStyle::Dotted);
  EXPECT_EQ(labelled.label, LabelText::Value);
  EXPECT_EQ(lineFor(labelled), "g = line((1, 2, 3), (4, 5, 6)), dotted, value");
  const Entry made = typed({"Q = (1, 2, 3)", "E: z = 0", "d = distance(Q, E), pink, dashed"}).entries[2];
  EXPECT_EQ(made.color, Hue::Pink);
  EXPECT_EQ(lineFor(made), "d = signed-distance(E, Q), pink, dashed");
}

TEST(TypedLine, ThatIsTheEquationOfASphere_IsIt_WhereItsRadiusIsAFraction) {
  const Object sphere(SphereObject{{1, 2, 0}, 3});
  EXPECT_EQ(objectOf("S: (x - 1)^2 + (y - 2)^2 + z^2 = 9"), sphere);
  EXPECT_EQ(objectOf("S: 2x^2 + 2y^2 + 2z^2 - 4x = 8y + 8"), sphere);
  EXPECT_EQ(objectOf("S: x^2 + y^2 + z^2 = 1/4"), Object(SphereObject{ExactVec3(0), test::q(1, 2)}));
  const auto sentence = [](const char *line) {
    return std::get<TypedFault>(readLine(line, Scene())).sentence;
  };
  EXPECT_EQ(sentence("S: x^2 + y^2 + z^2 = 5"),
            "Its radius would be √(5), which is not a fraction: here a radius must be one.");
  EXPECT_EQ(sentence("S: x^2 + y^2 + z^2 = -4"),
            "No point has these coordinates: the square of the radius would be -4.");
  for (const char *line : {"S: x^2 + y^2 + 2z^2 = 9", "S: x^2 + y^2 = 9", "S: x^2 + y^2 + z^2 + x*y = 9"})
    EXPECT_TRUE(sentence(line).starts_with("A sphere has an equation as")) << line;
}

TEST(TypedLine, OfAPlaneThroughPoints_HasItsShortestNormal_ButKeepsOneThatIsTyped) {
  const Scene scene = typed({"A = (5, 0, 0)", "B = (0, 5, 0)", "C = (0, 0, 5)", "E = plane(A, B, C)",
                             "F = plane(A, (B - A) × (C - A))"});
  const Evaluation evaluation = evaluate(scene);
  const auto normal = [&](const char *name) {
    return evaluation.find(name)->offers.front().given->object[1];
  };
  EXPECT_EQ(normal("E"), ExactVec3(1));
  EXPECT_EQ(normal("F"), ExactVec3(25));
  EXPECT_EQ(lineFor(scene.entries[3]), "E = plane(A, B, C)");
  EXPECT_EQ(lineFor(scene.entries[4]), "F = plane(A, (B - A) × (C - A))");
  const Scene vectors = typed({"A = (5, 0, 0)", "B = (0, 5, 0)", "n = shortest(B - A)"});
  EXPECT_EQ(lineFor(vectors.entries[2]), "n = shortest(B - A)");
  EXPECT_EQ(objectOf("E = plane((5, 0, 0), (0, 5, 0), (0, 0, 5))"),
            Object(PlaneObject{{5, 0, 0}, ExactVec3(1)}));
}

TEST(TypedLine, OfALine_MayCallItsPointsX) {
  EXPECT_EQ(objectOf("g: X = (1, 2, 3) + t(4, 5, 6)"), Object(LineObject{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(std::get<TypedFault>(readLine("E: X = 3", Scene())).sentence,
            "Behind X = a line is needed, as A + t v.");
}

TEST(TypedLine, WithNamesInIt_FollowsThem) {
  const Scene scene = typed({"k = 3/2", "A = (1, 2, 3)", "B = (k, 2k, 1)", "M = (A + B)/2", "w = B - A",
                             "E = plane(A, B, M)", "r = A + t w", "m = 2k + A.z"});
  const Evaluation evaluation = evaluate(scene);
  const auto object = [&](const char *name) { return evaluation.find(name)->offers.front().given->object; };
  EXPECT_EQ(object("B"), Object(PointObject{{test::q(3, 2), 3, 1}}));
  EXPECT_EQ(object("M"), Object(PointObject{{test::q(5, 4), test::q(5, 2), 2}}));
  EXPECT_EQ(object("w"), Object(VectorObject{ExactVec3(0), {test::q(1, 2), 1, -2}}));
  EXPECT_EQ(object("r"), Object(RayObject{{1, 2, 3}, {test::q(1, 2), 1, -2}}));
  EXPECT_EQ(object("m"), Object(NumberObject{6, 6, 6, 0}));
  auto moved = apply(scene, ChangeObject{"A", PointObject{{0, 0, 0}}});
  ASSERT_TRUE(moved);
  const Evaluation after = evaluate(*moved, evaluation);
  EXPECT_EQ(after.find("M")->offers.front().given->object,
            Object(PointObject{{test::q(3, 4), test::q(3, 2), test::q(1, 2)}}));
}

TEST(TypedLine, ThatDividesByZero_IsACaseThatComesBack) {
  const Scene scene = typed({"k = 0", "Q = (1/k, 0, 0)", "P = 2 Q", "E: z = 1", "d = distance(P, E)"});
  const Evaluation evaluation = evaluate(scene);
  for (const char *name : {"Q", "P", "d"})
    EXPECT_EQ(evaluation.find(name)->outcome->told->name, "missing-object") << name;
  EXPECT_EQ(evaluation.find("d")->missing, "Q is not there now. This would be divided by zero.");
  const auto moved = apply(scene, ChangeObject{"k", NumberObject{2, -10, 10, test::q(1, 10)}});
  const Evaluation after = evaluate(*moved, evaluation);
  EXPECT_EQ(after.find("P")->offers.front().given->object, Object(PointObject{{1, 0, 0}}));
  EXPECT_NE(after.find("d")->outcome->told->name, "missing-object");
}

TEST(TypedLine, FromPointToPoint_LeadsThere) {
  const Scene scene =
      typed({"A = (1, 2, 3)", "B = (4, 0, 1)", "g = line(A, B)", "v = vector(A, B)", "h = A-t(1,2,3)"});
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(evaluation.find("g")->offers.front().given->object, Object(LineObject{{1, 2, 3}, {3, -2, -2}}));
  EXPECT_EQ(evaluation.find("v")->offers.front().given->object, Object(VectorObject{{1, 2, 3}, {3, -2, -2}}));
  EXPECT_EQ(evaluation.find("h")->offers.front().given->object, Object(LineObject{{1, 2, 3}, {-1, -2, -3}}));
}

TEST(TypedLine, OfAConstruction_TakesWhatFits_InAnyOrder) {
  const std::vector<std::string> objects{"E: x + 2y + 2z = 27", "F: y + z = 6",
                                         "Q = (11, 15, 8)",     "r = Q + t(-1, 3, 2)",
                                         "g = Q + t(1, 0, 0)",  "h = (0, 0, 1) + t(0, 1, 0)",
                                         "P = (0, 0, 1)"};
  const auto use = [&](const std::string &line) {
    std::vector<std::string> lines = objects;
    lines.push_back(line);
    return useOf(typed(lines));
  };
  EXPECT_EQ(use("d = distance(Q, E)"), (ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}));
  EXPECT_EQ(use("d = signed-distance(E, Q)"), (ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}));
  EXPECT_EQ(use("d = distance(g, Q)").id, "point-line");
  EXPECT_EQ(use("d = distance(P, Q)"), (ConstructionUse{"point-point", {{"A", "P"}, {"B", "Q"}}}));
  EXPECT_EQ(use("d = distance(g, h)").id, "closest-points");
  EXPECT_EQ(use("d = distance(E, F)").id, "plane-distance");
  EXPECT_EQ(use("a = angle(E, F)").id, "plane-angle");
  EXPECT_EQ(use("a = angle(g, h)").id, "line-angle");
  EXPECT_EQ(use("a = angle(E, g)"), (ConstructionUse{"line-plane-angle", {{"E", "E"}, {"g", "g"}}}));
  EXPECT_EQ(use("m = midpoint(P, Q)").id, "midpoint");
  EXPECT_EQ(use("m = mirror(Q, E)"), (ConstructionUse{"mirror-point", {{"E", "E"}, {"Q", "Q"}}}));
  EXPECT_EQ(use("m = mirror(r, E)"), (ConstructionUse{"mirror-ray", {{"E", "E"}, {"L", "r"}}}));
  EXPECT_EQ(use("s = intersect(r, E)").id, "ray-plane-dot");
  EXPECT_EQ(use("s = intersect(E, F)"), (ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}));
  EXPECT_EQ(use("s = ray-plane-substitution(E, F, r)").roles.at("planes").ids.size(), 2U);
}

TEST(TypedLine, OfSeveralPlanes_MeetsThemByTheirNumber) {
  const std::vector<std::string> objects{"E: x = 1", "F: y = 2", "G: z = 3",
                                         "s = (0, 0, 0) + t(2, 0, 0), 0 <= t <= 1"};
  const auto scene = [&](const std::string &line) {
    std::vector<std::string> lines = objects;
    lines.push_back(line);
    return typed(lines);
  };
  EXPECT_EQ(useOf(scene("h = intersect(E, G)")), (ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "G"}}}));
  EXPECT_EQ(useOf(scene("h = intersect(E, s)")),
            (ConstructionUse{"segment-plane", {{"s", "s"}, {"E", "E"}}}));
  const Scene three = scene("h = intersect(E, F, G)");
  EXPECT_EQ(useOf(three), (ConstructionUse{"three-planes", {{"E", "E"}, {"F", "F"}, {"G", "G"}}}));
  EXPECT_EQ(evaluate(three).find("h")->offers.front().given->object, Object(PointObject{{1, 2, 3}}));
}

TEST(TypedLine, OfAMadePlane_TakesItAsAnyPlane) {
  const Scene scene =
      typed({"A = (0, 0, 0)", "B = (0, 0, 4)", "Q = (1, 2, 7)", "m = perpendicular-bisector(A, B)",
             "p = parallel-plane(m, Q)", "d = distance(Q, m.E)", "h = distance(A, p.F)"});
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(std::get<ConstructionUse>(scene.entries[4].content).roles.at("E"), "m.E");
  EXPECT_EQ(std::get<Surd>(*findValue(evaluation, "d.signed_distance")), Surd(5));
  EXPECT_EQ(std::get<Surd>(*findValue(evaluation, "h.signed_distance")), Surd(-7));
}

TEST(TypedLine, OfWhatAnotherMakes_NamesIt) {
  const Scene scene = typed({"E: z = 0", "Q = (1, 2, 3)", "d = distance(Q, E)", "D = distance(d.F, E)",
                             "M = (Q + d.F)/2", "N = (Q + d)/2"});
  EXPECT_EQ(std::get<ConstructionUse>(scene.entries[3].content).roles.at("Q"), "d.F");
  const Evaluation evaluation = evaluate(scene);
  for (const char *name : {"M", "N"})
    EXPECT_EQ(evaluation.find(name)->offers.front().given->object,
              Object(PointObject{{1, 2, test::q(3, 2)}}));
}

TEST(TypedLine, ThatIsWrong_SaysWhatAndWhere) {
  const Scene scene = typed({"E: z = 0", "Q = (1, 2, 3)", "T = triangle((0, 0, 0), (1, 0, 0), (0, 1, 0))",
                             "g = Q + t(1, 0, 0)", "h = Q + t(0, 1, 0)", "d = distance(g, h)"});
  for (const auto &[line, at, part] :
       {std::tuple("", 0U, "begins with a name"),
        {"Q = (1, 2, 3)", 0U, "There is “Q” already"},
        {"P (1, 2, 3)", 2U, "“=” is needed"},
        {"P = (1, 2", 9U, "closing bracket"},
        {"P = (1, 2)", 4U, "three numbers"},
        {"D = distance(Q, T)", 16U, "“T” is a triangle: a plane is needed here"},
        {"D = distance(Q, W)", 16U, "There is no “W”"},
        {"D = distanc(Q, E)", 4U, "There is no “distanc”"},
        {"M = (Q + E)/2", 9U, "“E” is a plane"},
        {"M = (Q + 1)/2", 9U, "cannot be added"},
        {"E2: x*y = 3", 4U, "no products"},
        {"E2: x - x = 3", 4U, "no plane"},
        {"E2: kx = 3", 4U, "plane(P, n)"},
        {"k = 1, step (1, 2, 3)", 12U, "a number is needed"},
        {"k = 1, step (1, 2, 3) + 1", 12U, "a number is needed"},
        {"n = number(Q.x, 0, 5, 1)", 4U, "has no bounds"},
        {"k = 9²³", 0U, "too high"},
        {"k = ((9^8)^8)^8", 0U, "too high"},
        {"E2: ((x^8)^8)^8 = z", 0U, "too high"},
        {"k = 2 + 3t", 9U, "There is no “t”"},
        {"D = distance(d, E)", 13U, "“d” is a construction: a point is needed here"},
        {"k = 1/0", 4U, "divided by zero"},
        {"k = 1, 2 <= k", 7U, "bounds"},
        {"P = (1, 2, 3), greem", 15U, "not a colour"},
        {"s = sphere((1, 2, 3), -1)", 0U, "cannot be"},
        {"P = (1, 2, 3) + t(1, 2, 3), t < 0", 28U, "t >= 0"},
        {"P = (1, 2, 3) §", 14U, "cannot be read"}}) {
    const auto entry = readLine(line, scene);
    const auto *fault = std::get_if<TypedFault>(&entry);
    ASSERT_TRUE(fault) << line;
    if (std::string_view(part) != "too high") {
      EXPECT_EQ(fault->at, at) << line << ": " << fault->sentence;
    }
    EXPECT_NE(fault->sentence.find(part), std::string::npos) << line << ": " << fault->sentence;
  }
}

/// A single number is its x alone.
Object withPlainNumbers(Object object) {
  for (std::size_t i = 0; i < object.size(); ++i)
    if (numbersIn(coordinatesOf(object)[i].role) == 1)
      object[i] = {object[i].x, 0, 0};
  return object;
}

/// Each entry as a line, and the line as an entry again.
void expectSameAgain(const Scene &scene, char decimalMark, int &lines) {
  Scene above;
  for (const Entry &entry : scene.entries) {
    const auto *object = std::get_if<Object>(&entry.content);
    const bool isBeyondLimits = object && refusedCoordinateOf(*object);
    if (const std::string line = lineFor(entry, decimalMark); !line.empty() && !isBeyondLimits) {
      ++lines;
      const auto again = readLine(line, above, decimalMark);
      const auto *fault = std::get_if<TypedFault>(&again);
      ASSERT_FALSE(fault) << line << ": " << fault->sentence << " at " << fault->at;
      ASSERT_EQ(std::get<Entry>(again), entry) << line;
      ASSERT_EQ(lineFor(std::get<Entry>(again), decimalMark), line);
    }
    above.entries.push_back(entry);
  }
}

TEST(TypedLine, OfEachEntryOfOurLessons_IsReadAsThatEntry) {
  int lines = 0;
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  ASSERT_GT(library.lessons.size(), 20U);
  for (const Lesson &lesson : library.lessons)
    for (const char mark : {'.', ','})
      expectSameAgain(lesson.scene, mark, lines);
  EXPECT_GT(lines, 200);
}

TEST(TypedLine, OfEachKindAndConstruction_IsReadAsThatEntry) {
  int lines = 0;
  test::RandomObjects random(11);
  for (const Construction &construction : constructions())
    for (const test::Writing writing : {test::Writing::SmallIntegers, test::Writing::Fractions,
                                        test::Writing::LongFractions, test::Writing::LargeIntegers})
      for (int i = 0; i < 25; ++i) {
        std::vector<Object> objects = random.objectsFor(construction, writing);
        std::transform(objects.begin(), objects.end(), objects.begin(), withPlainNumbers);
        expectSameAgain(test::sceneOf(construction, objects), i % 2 ? '.' : ',', lines);
      }
  EXPECT_GT(lines, 8000);
}

TEST(TypedLine, OfAConstruction_HasItsWord_WhereThatMeansItAlone_AndElseItsId) {
  const Scene scene = typed({"E: z = 0", "F: x = 0", "Q = (1, 2, 3)", "r = Q + t(1, 1, 1), t >= 0",
                             "i = intersect(E, F)", "k = plane-plane(F, E)", "d = distance(Q, E)",
                             "h = intersect(r, E)", "s = ray-plane-substitution(E, r)"});
  const auto line = [&](const char *name) { return lineFor(*scene.entries.find(name)); };
  EXPECT_EQ(line("i"), "i = intersect(E, F)");
  EXPECT_EQ(line("k"), "k = intersect(F, E)");
  EXPECT_EQ(line("d"), "d = signed-distance(E, Q)") << "which says more than distance";
  EXPECT_EQ(line("h"), "h = intersect(E, r)");
  EXPECT_EQ(line("s"), "s = ray-plane-substitution(E, r)");
}

TEST(TypedLine, WithFormulas_IsReadAsThatEntry) {
  int lines = 0;
  expectSameAgain(typed({"k = 3/2", "A = (1, 2, 3)", "b = (k, 2k, 1)", "M = (A + b)/2, pink", "q = point(A)",
                         "V = vector(A, 2b)", "E = plane(A, M, q)", "S = sphere(A, k^2)", "m = -k",
                         "C = polygon(A, M, 2A, q)", "L = point(1.5k, 3/4 k, -1/2)", "U = (3/2)A"}),
                  '.', lines);
  EXPECT_EQ(lines, 12);
}

} // namespace
} // namespace halfspace
