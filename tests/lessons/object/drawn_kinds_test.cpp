// What each kind of object is drawn as, and what is left out where it has no extent.
#include "lessons/object/drawing.h"

#include "tests/lessons/object/spelled_objects.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <set>

namespace halfspace {
namespace {

using namespace test;

Figure figureOfEntry(const std::string &entry) { return figureOf(evaluate(spelledScene(entry))); }

std::set<std::string> idsOf(const Figure &figure) {
  std::set<std::string> ids;
  for (const Mark &mark : figure.marks)
    ids.insert(baseOf(mark).id);
  return ids;
}

template <class MarkKind> int countOf(const Figure &figure) {
  int count = 0;
  for (const Mark &mark : figure.marks)
    count += std::holds_alternative<MarkKind>(mark);
  return count;
}

TEST(Drawn, ABoxOrPrism_IsItsFacesWithTheirCornersInSpace) {
  const Figure box = figureOfEntry(spelledEntry("box"));
  EXPECT_EQ(countOf<PolygonMark>(box), 6);
  EXPECT_EQ(countOf<PolygonMark>(figureOfEntry(spelledEntry("prism"))), 5);
  EXPECT_EQ(countOf<PolygonMark>(figureOfEntry(spelledEntry("tetrahedron"))), 4);
  Place low(100);
  Place high(-100);
  for (const Mark &mark : box.marks)
    if (const auto *face = std::get_if<PolygonMark>(&mark))
      for (const Place &corner : face->corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
  EXPECT_EQ(low, Place(1, 2, 3));
  EXPECT_EQ(high, Place(5, 7, 9));
}

TEST(Drawn, AScreen_IsItsColumnsAndItsRows) {
  EXPECT_EQ(countOf<PolygonMark>(figureOfEntry(spelledEntry("screen"))), 4 + 3);
  const char *flat = "{name: K, screen: {P0: [1, 2, 3], u: [4, 0, 0], v: [-8, 0, 0], w: 4, h: 3}}";
  const Figure figure = figureOfEntry(flat);
  EXPECT_EQ(countOf<PolygonMark>(figure), 0);
  EXPECT_EQ(countOf<ArrowMark>(figure), 2) << "what spans no screen can still be grabbed";
}

struct Solids : testing::TestWithParam<std::string> {};

TEST_P(Solids, OfAnyKind_AreClosedByTheirFaces) {
  // Each side belongs to two faces, which go along it in opposite directions or the same.
  std::map<std::pair<std::string, std::string>, int> sides;
  const auto nameOf = [](const Place &p) {
    return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
  };
  for (const Mark &mark : figureOfEntry(spelledEntry(GetParam())).marks)
    if (const auto *face = std::get_if<PolygonMark>(&mark))
      for (std::size_t i = 0; i < face->corners.size(); ++i) {
        std::pair side(nameOf(face->corners[i]), nameOf(face->corners[(i + 1) % face->corners.size()]));
        if (side.second < side.first)
          std::swap(side.first, side.second);
        ++sides[side];
      }
  EXPECT_FALSE(sides.empty());
  for (const auto &[side, faces] : sides)
    EXPECT_EQ(faces, 2) << side.first << " to " << side.second;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Solids, testing::Values("box", "prism", "tetrahedron"));

TEST(Drawn, TheFacesOfASolid_AccompanyItsOwnMark) {
  for (const char *kind : {"box", "prism", "tetrahedron"})
    for (const Mark &mark : figureOfEntry(spelledEntry(kind)).marks)
      if (std::holds_alternative<PolygonMark>(mark)) {
        EXPECT_EQ(leadingId(baseOf(mark)), "K") << kind;
        EXPECT_EQ(baseOf(mark).label.empty(), baseOf(mark).id != "K") << "its letter is written once";
      }
}

TEST(Drawn, ABall_IsItsSphereAndItsCentre) {
  const Figure figure = figureOfEntry(spelledEntry("sphere"));
  const auto *sphere = std::get_if<SphereMark>(&figure.marks[0]);
  ASSERT_NE(sphere, nullptr);
  EXPECT_EQ(sphere->radius, 4);
  EXPECT_EQ(sphere->center, Place(1, 2, 3));
  EXPECT_EQ(idsOf(figure), (std::set<std::string>{"K", "K.c"}));
}

TEST(Drawn, ALine_GoesThroughItsPointWithAnArrowOfItsOwn) {
  const Figure figure = figureOfEntry(spelledEntry("line"));
  EXPECT_EQ(idsOf(figure), (std::set<std::string>{"K", "K.A", "K.v"}));
  const auto *line = std::get_if<LineMark>(&figure.marks[0]);
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->through, Place(1, 2, 3));
  EXPECT_NEAR(glm::length(line->direction), 1, 1e-12);
}

TEST(Drawn, WithoutAnyExtent_IsTheirPointsAlone) {
  for (const char *entry :
       {"{name: K, sphere: {c: [1, 2, 3], R: 0}}", "{name: K, line: {A: [1, 2, 3], v: [0, 0, 0]}}",
        "{name: K, ray: {Q: [1, 2, 3], r: [0, 0, 0]}}", "{name: K, plane: {P0: [1, 2, 3], n: [0, 0, 0]}}",
        "{name: K, segment: {A: [1, 2, 3], B: [1, 2, 3]}}",
        "{name: K, triangle: {P0: [0, 0, 0], P1: [1, 0, 0], P2: [2, 0, 0]}}",
        "{name: K, vector: {A: [1, 2, 3], v: [0, 0, 0]}}"}) {
    const Figure figure = figureOfEntry(entry);
    EXPECT_EQ(countOf<PointMark>(figure), static_cast<int>(figure.marks.size())) << entry;
    EXPECT_FALSE(figure.marks.empty()) << entry;
  }
}

TEST(Drawn, AFlatBox_HasItsSidesWhereAFaceHasNoArea) {
  const Figure figure = figureOfEntry("{name: K, box: {P0: [0, 0, 0], a: 4, b: 5, c: 0}}");
  EXPECT_EQ(countOf<PolygonMark>(figure), 2) << "top and bottom";
  EXPECT_GT(countOf<SegmentMark>(figure), 0);
  for (const Mark &mark : figure.marks)
    if (const auto *side = std::get_if<SegmentMark>(&mark)) {
      EXPECT_NE(side->from, side->to);
    }
}

TEST(Drawn, ABentPolygon_IsItsSides) {
  const Figure figure =
      figureOfEntry("{name: K, polygon: {P0: [0, 0, 0], P1: [4, 0, 0], P2: [4, 4, 1], P3: [0, 4, 0]}}");
  EXPECT_EQ(countOf<PolygonMark>(figure), 0);
  EXPECT_EQ(countOf<SegmentMark>(figure), 4);
}

struct Corners {
  const char *name;
  std::vector<ExactVec3> corners;
  bool isFace;
};

struct FlatAndConvex : testing::TestWithParam<Corners> {};

TEST_P(FlatAndConvex, AreWhatCanBeFilled) {
  EXPECT_EQ(isFlatAndConvex(GetParam().corners), GetParam().isFace);
  std::vector<ExactVec3> otherWay(GetParam().corners.rbegin(), GetParam().corners.rend());
  EXPECT_EQ(isFlatAndConvex(otherWay), GetParam().isFace) << "whichever way round";
}

INSTANTIATE_TEST_SUITE_P(
    Corners, FlatAndConvex,
    testing::Values(Corners{"Triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, true},
                    Corners{"Line", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, false},
                    Corners{"Slanted", {{0, 0, 0}, {2, 0, 1}, {2, 2, 2}, {0, 2, 1}}, true},
                    Corners{"Dented", {{0, 0, 0}, {1, 0, 0}, {q(1, 4), q(1, 4), 0}, {0, 1, 0}}, false},
                    Corners{"Repeated", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, false},
                    Corners{"Pentagram", {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}}, false},
                    Corners{"NearlyFlat", {{0, 0, 0}, {1, 0, 0}, {1, 1, q(1, 1000000)}, {0, 1, 0}}, false}),
    [](const auto &each) { return std::string(each.param.name); });

TEST(UnitOf, VeryShortAndLongDirections_AreOneUnitLong) {
  const Rational tiny = powerOfTen(-200);
  for (const Rational &size : {tiny, Rational(1), Rational(1 / tiny)}) {
    const Place unit = unitOf(ExactVec3(1, -2, 2) * size);
    EXPECT_NEAR(glm::distance(unit, Place(1, -2, 2) / 3.0), 0, 1e-12);
  }
  EXPECT_EQ(arrowOfLength({}, {1, 2, 3}, ExactVec3(0, 0, tiny), 4).vector, Place(0, 0, 4));
}

} // namespace
} // namespace halfspace
