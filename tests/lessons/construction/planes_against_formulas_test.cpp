// Constructions of planes on very many small inputs, degenerate ones among them, against laws that tell what
// each of them is: whatever formulas it goes by.
#include "lessons/construction/construction.h"
#include "lessons/object/kinds/segment.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace halfspace {
namespace {

using namespace test;

constexpr int inputs = effort(10'000);

/// What a construction made of objects, and what it called the case.
class Made {
public:
  Made(const Construction &construction, const std::vector<Object> &objects)
      : m_evaluation(evaluate(sceneOf(construction, objects))) {}

  [[nodiscard]] std::string caseName() const { return outcome().told->name; }
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != outcome().objects.end(); }
  /// Requires that it is there.
  template <class Kind> [[nodiscard]] Kind as(std::string_view name) const {
    return objectAs<Kind>(find(name)->object).value();
  }
  [[nodiscard]] ExactVec3 point(std::string_view name) const { return as<PointObject>(name).at; }

private:
  [[nodiscard]] const Outcome &outcome() const { return lastOutcome(m_evaluation); }
  [[nodiscard]] std::vector<MadeObject>::const_iterator find(std::string_view name) const {
    const auto &objects = outcome().objects;
    return std::find_if(objects.begin(), objects.end(),
                        [&](const MadeObject &made) { return made.name == name; });
  }

  Evaluation m_evaluation;
};

/// Calls back with small objects for the roles of a construction and what it made of them. The callback
/// returns the case that it should be, and each of the construction's cases must come up.
template <class Expect> void sweep(const char *id, std::uint64_t seed, int largest, Expect expect) {
  const Construction &construction = *findConstruction(id);
  RandomNumbers random(seed);
  std::set<std::string> cases;
  for (int i = 0; i < inputs && !testing::Test::HasFailure(); ++i) {
    std::vector<Object> objects;
    for (const ConstructionRole &role : construction.roles) {
      objects.push_back(*makeObject(role.kind));
      for (std::size_t k = 0; k < objects.back().size(); ++k)
        objects.back()[k] = random.wholeVector(largest);
    }
    const Made made(construction, objects);
    const std::string expected = expect(objects, made, random.wholeVector(5));
    SCOPED_TRACE(expected);
    EXPECT_EQ(made.caseName(), expected);
    cases.insert(expected);
  }
  if (!isWatched) {
    const auto &all = construction.names.cases;
    EXPECT_EQ(cases, std::set<std::string>(all.begin(), all.end()));
  }
}

/// n·(P − P0)
Rational valueAt(const PlaneObject &plane, const ExactVec3 &point) {
  Rational sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += plane.normal[axis] * (point[axis] - plane.point[axis]);
  return sum;
}
Rational valueAt(const Object &plane, const ExactVec3 &point) {
  return valueAt(objectAs<PlaneObject>(plane).value(), point);
}

Rational squareOf(const ExactVec3 &v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

/// Whether one is a multiple of the other: all two-rowed determinants are 0.
bool areAlong(const ExactVec3 &a, const ExactVec3 &b) {
  return a.x * b.y == a.y * b.x && a.y * b.z == a.z * b.y && a.x * b.z == a.z * b.x;
}

/// The largest number of rows and columns with a determinant ≠ 0, of three rows.
std::size_t rankOf(const std::vector<ExactVec3> &columns) {
  bool hasArea = false;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i + 1; j < columns.size(); ++j) {
      hasArea = hasArea || !areAlong(columns[i], columns[j]);
      for (std::size_t k = j + 1; k < columns.size(); ++k) {
        const auto &[a, b, c] = std::tie(columns[i], columns[j], columns[k]);
        if (a.x * b.y * c.z + b.x * c.y * a.z + c.x * a.y * b.z !=
            c.x * b.y * a.z + b.x * a.y * c.z + a.x * c.y * b.z)
          return 3;
      }
    }
  return hasArea ? 2 : 1;
}

/// By the theorem of Rouché and Capelli: a common point is there where the right sides leave the rank.
std::string caseOfThree(const std::vector<Object> &planes) {
  std::vector<ExactVec3> columns(4);
  for (int row = 0; row < 3; ++row) {
    const Object &plane = planes[static_cast<std::size_t>(row)];
    if (squareOf(plane[1]) == 0)
      return "zero-normal";
    for (int axis = 0; axis < 3; ++axis)
      columns[static_cast<std::size_t>(axis)][row] = plane[1][axis];
    columns[3][row] = -valueAt(plane, ExactVec3(0));
  }
  const std::size_t whole = rankOf(columns);
  columns.pop_back();
  const std::size_t left = rankOf(columns);
  if (left == 3)
    return "point";
  if (left == whole)
    return left == 2 ? "line" : "coincident";
  const bool areTwoAlong = areAlong(planes[0][1], planes[1][1]) || areAlong(planes[1][1], planes[2][1]) ||
                           areAlong(planes[0][1], planes[2][1]);
  return areTwoAlong ? "parallel" : "prism";
}

TEST(PlanesAgainstFormulas, ThreePlanes_MeetInAPointOfAllWhereTheirRankSaysSo) {
  sweep("three-planes", 71, 1, [](const std::vector<Object> &planes, const Made &made, const ExactVec3 &) {
    const std::string expected = caseOfThree(planes);
    EXPECT_EQ(made.has("S"), expected == "point");
    for (const Object &plane : planes)
      EXPECT_TRUE(!made.has("S") || valueAt(plane, made.point("S")) == 0);
    return expected;
  });
}

TEST(PlanesAgainstFormulas, ParallelPlane_HasThePointAndDiffersByOneNumberEverywhere) {
  sweep("parallel-plane", 72, 2,
        [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &any) -> std::string {
          const ExactVec3 &Q = objects[1][0];
          EXPECT_EQ(made.has("F"), squareOf(objects[0][1]) != 0);
          if (!made.has("F"))
            return "zero-normal";
          const auto F = made.as<PlaneObject>("F");
          EXPECT_EQ(valueAt(F, Q), 0);
          EXPECT_EQ(valueAt(objects[0], any) - valueAt(F, any), valueAt(objects[0], Q));
          return valueAt(objects[0], Q) == 0 ? "same" : "parallel";
        });
}

TEST(PlanesAgainstFormulas, PerpendicularPlane_HasThePointAndMeetsTheLineNearestToIt) {
  sweep("perpendicular-plane", 73, 2,
        [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &any) -> std::string {
          const ExactVec3 &A = objects[0][0];
          const ExactVec3 &v = objects[0][1];
          const ExactVec3 &Q = objects[1][0];
          EXPECT_EQ(made.has("E"), squareOf(v) != 0);
          EXPECT_EQ(made.has("S"), squareOf(v) != 0);
          if (!made.has("E"))
            return "zero-direction";
          const auto E = made.as<PlaneObject>("E");
          EXPECT_EQ(valueAt(E, Q), 0);
          EXPECT_EQ(valueAt(E, any + v) - valueAt(E, any), squareOf(v));
          EXPECT_TRUE(areAlong(E.normal, v));
          const ExactVec3 S = made.point("S");
          EXPECT_EQ(valueAt(E, S), 0);
          EXPECT_TRUE(areAlong(S - A, v));
          EXPECT_LE(squareOf(Q - S), squareOf(Q - A - v * any.x)) << "another point of the line is nearer";
          return areAlong(Q - A, v) ? "on" : "off";
        });
}

TEST(PlanesAgainstFormulas, PlaneThroughLine_HasTheLineAndThePoint) {
  sweep("plane-through-line", 74, 1,
        [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &any) -> std::string {
          const ExactVec3 &A = objects[0][0];
          const ExactVec3 &v = objects[0][1];
          const ExactVec3 &Q = objects[1][0];
          EXPECT_EQ(made.has("E"), !areAlong(Q - A, v));
          if (!made.has("E"))
            return squareOf(v) == 0 ? "zero-direction" : "on";
          const auto E = made.as<PlaneObject>("E");
          EXPECT_NE(squareOf(E.normal), 0);
          EXPECT_EQ(valueAt(E, A + v * any.x), 0);
          EXPECT_EQ(valueAt(E, Q), 0);
          return "off";
        });
}

TEST(PlanesAgainstFormulas, PerpendicularBisector_IsHalfTheDifferenceOfTheSquaresOfDistances) {
  sweep("perpendicular-bisector", 75, 1,
        [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &any) -> std::string {
          const ExactVec3 &A = objects[0][0];
          const ExactVec3 &B = objects[1][0];
          EXPECT_EQ(made.has("E"), A != B);
          if (!made.has("E"))
            return "same-point";
          EXPECT_EQ(2 * valueAt(made.as<PlaneObject>("E"), any), squareOf(any - A) - squareOf(any - B));
          return "plane";
        });
}

std::string caseOfSegment(const SegmentObject &s, const PlaneObject &E) {
  if (squareOf(E.normal) == 0)
    return "zero-normal";
  if (s.from == s.to)
    return "zero-length";
  const int from = valueAt(E, s.from).sign();
  const int to = valueAt(E, s.to).sign();
  if (valueAt(E, s.from) == valueAt(E, s.to))
    return from == 0 ? "in-plane" : "parallel";
  if (from * to == 0)
    return "touches";
  return from == to ? "beside" : "crosses";
}

TEST(PlanesAgainstFormulas, SegmentPlane_MeetInAPointOfBoth) {
  sweep("segment-plane", 76, 1, [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &) {
    const auto s = objectAs<SegmentObject>(objects[0]).value();
    const auto E = objectAs<PlaneObject>(objects[1]).value();
    const std::string expected = caseOfSegment(s, E);
    EXPECT_EQ(made.has("S"), expected == "crosses" || expected == "touches");
    if (!made.has("S"))
      return expected;
    const ExactVec3 S = made.point("S");
    EXPECT_EQ(valueAt(E, S), 0);
    EXPECT_TRUE(areAlong(S - s.from, s.to - s.from));
    EXPECT_EQ(expected == "touches", S == s.from || S == s.to);
    // between the ends a point sees them in opposite directions
    const ExactVec3 back = s.from - S;
    const ExactVec3 onward = s.to - S;
    EXPECT_LE(back.x * onward.x + back.y * onward.y + back.z * onward.z, 0);
    return expected;
  });
}

/// Whether a whole number is the square of one.
bool isSquare(const Rational &number) {
  Rational root = 0;
  while (root * root < number)
    root += 1;
  return root * root == number;
}

std::string caseOfBisected(const PlaneObject &E, const PlaneObject &F) {
  if (squareOf(E.normal) == 0 || squareOf(F.normal) == 0)
    return "zero-normal";
  if (areAlong(E.normal, F.normal))
    return valueAt(F, E.point) == 0 ? "coincident" : "parallel";
  return isSquare(squareOf(E.normal) * squareOf(F.normal)) ? "crossing" : "irrational";
}

TEST(PlanesAgainstFormulas, PlaneBisectors_AreTogetherWhereBothDistancesHaveOneSquare) {
  sweep("plane-bisectors", 77, 2,
        [](const std::vector<Object> &objects, const Made &made, const ExactVec3 &any) {
          const auto E = objectAs<PlaneObject>(objects[0]).value();
          const auto F = objectAs<PlaneObject>(objects[1]).value();
          const std::string expected = caseOfBisected(E, F);
          EXPECT_EQ(made.has("G"), expected == "crossing" || expected == "parallel");
          EXPECT_EQ(made.has("H"), expected == "crossing");
          if (!made.has("G"))
            return expected;
          const auto square = [](const Rational &number) { return Rational(number * number); };
          const Rational difference =
              square(valueAt(F, any)) * squareOf(E.normal) - square(valueAt(E, any)) * squareOf(F.normal);
          const auto G = made.as<PlaneObject>("G");
          if (!made.has("H")) {
            EXPECT_EQ(valueAt(G, any) == 0, difference == 0);
            return expected;
          }
          const auto H = made.as<PlaneObject>("H");
          EXPECT_EQ(valueAt(G, any) * valueAt(H, any) * squareOf(E.normal), difference);
          return expected;
        });
}

} // namespace
} // namespace halfspace
