// Figures: how far their marks are drawn, and what is left out of them.
#include "tests/picture/marks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace halfspace {
namespace {

constexpr double rounding = 1e-9;

RayMark rayFrom(Place origin, Place direction) {
  RayMark ray;
  ray.id = "L";
  ray.origin = origin;
  ray.direction = direction;
  return ray;
}

LineMark lineThrough(Place through, Place direction, std::vector<Place> covers = {}) {
  LineMark line;
  line.id = "g";
  line.through = through;
  line.direction = direction;
  line.covers = std::move(covers);
  return line;
}

/// The only mark of a figure after it was drawn up to some places.
template <class MarkKind> MarkKind reached(MarkKind mark, const std::vector<Place> &places) {
  Figure figure{{mark}};
  for (const Place &place : places)
    figure.reaches.push_back({mark.id, place});
  return std::get<MarkKind>(reaching(figure).marks.front());
}

TEST(Reaching, ARayThatMeetsSeveralPlaces_GoesToTheFarthest) {
  const RayMark ray = rayFrom({0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(reached(ray, {{4, 0, 0}, {9, 0, 0}, {2, 0, 0}}).meets, Place(9, 0, 0));
  EXPECT_FALSE(reached(ray, {}).meets);
}

TEST(Reaching, PatchesAndLines_CoverAllPlaces) {
  const std::vector<Place> places{{4, 0, 0}, {0, 9, 0}};
  EXPECT_EQ(reached(withId(patchAt({0, 0, 0}, {0, 0, 1}, {{1, 1, 0}}), "E"), places).covers,
            (std::vector<Place>{{1, 1, 0}, {4, 0, 0}, {0, 9, 0}}));
  EXPECT_EQ(reached(lineThrough({0, 0, 0}, {1, 0, 0}), places).covers, places);
}

TEST(Reaching, APlaneThatARayLiesIn_CoversTheRayAsFarAsItIsDrawn) {
  Figure figure{{withId(patchAt({0, 0, 3}, {0, 0, 1}), "E"), rayFrom({4, 1, 3}, {2, 0, 0})}};
  figure.reaches.push_back({"L", {5, 1, 3}}); // what else the ray meets is not its end
  figure.reachWithin("E", "L", {4, 1, 3}, {1, 0, 0});
  const Figure drawn = reaching(figure);
  const Place end = endOf(std::get<RayMark>(drawn.marks[1]));
  EXPECT_NEAR(end.x, 4 + openRayLength, rounding);
  const std::vector<Place> corners = cornersOf(std::get<PlanePatchMark>(drawn.marks[0]));
  EXPECT_TRUE(std::any_of(corners.begin(), corners.end(), [&](const Place &each) { return each.x > end.x; }));
}

TEST(Reaching, MarksWithEndsOfTheirOwn_StayAsTheyAre) {
  const SegmentMark segment = withId(segmentBetween({0, 0, 0}, {1, 0, 0}), "s");
  EXPECT_EQ(reached(segment, {{9, 9, 9}}), segment);
}

TEST(Reaching, AMarkThatIsNotThere_ChangesNothing) {
  Figure figure{{rayFrom({0, 0, 0}, {1, 0, 0})}, {{"M", {5, 0, 0}}}};
  figure = reaching(figure);
  EXPECT_FALSE(std::get<RayMark>(figure.marks.front()).meets);
  EXPECT_TRUE(figure.reaches.empty()) << "they are used up";
}

TEST(Ray, ThatMeetsSomething_EndsALittleBehindIt) {
  RayMark ray = rayFrom({1, 0, 0}, {0, 0, 2});
  ray.meets = Place(1, 0, 6);
  EXPECT_EQ(endOf(ray), Place(1, 0, 6 + beyondHit));
}

TEST(Ray, ThatMeetsNothing_IsAsLongWhateverItsDirection) {
  for (const double length : {0.01, 1.0, 500.0})
    EXPECT_NEAR(glm::distance(endOf(rayFrom({1, 2, 3}, Place(2, -1, 2) * length)), Place(1, 2, 3)),
                openRayLength, rounding);
}

TEST(Line, AloneGoesBothWaysAlike) {
  const auto [low, high] = endsOf(lineThrough({1, 2, 3}, {0, 0, 5}));
  EXPECT_EQ(low, Place(1, 2, 3 - lineReach));
  EXPECT_EQ(high, Place(1, 2, 3 + lineReach));
}

TEST(Line, ThatCoversAPlace_GoesOnBehindItOnThatSideAlone) {
  const auto [low, high] = endsOf(lineThrough({0, 0, 0}, {0, 0, 5}, {{0, 0, 40}, {0, 0, 3}}));
  EXPECT_EQ(high, Place(0, 0, 40 + beyondHit));
  EXPECT_EQ(low, Place(0, 0, -lineReach));
}

TEST(Arrow, WithALengthOfThePicture_KeepsItsDirectionAlone) {
  ArrowMark arrow;
  arrow.vector = {0, 300, 400};
  EXPECT_EQ(shownVector(arrow), arrow.vector);
  arrow.drawnLength = 5;
  EXPECT_NEAR(glm::distance(shownVector(arrow), Place(0, 3, 4)), 0, rounding);
}

TEST(Marks, ThatReachFarther_AreTheSameMarks) {
  EXPECT_EQ(withId(patchAt({1, 2, 3}, {0, 0, 1}, {{9, 9, 3}}), "E"),
            withId(patchAt({1, 2, 3}, {0, 0, 1}), "E"));
  EXPECT_EQ(lineThrough({1, 2, 3}, {0, 0, 1}, {{1, 2, 90}}), lineThrough({1, 2, 3}, {0, 0, 1}));
  EXPECT_NE(withId(patchAt({1, 2, 3}, {0, 0, 1}), "E"), withId(patchAt({1, 2, 3}, {0, 0, 2}), "E"));
  EXPECT_NE(lineThrough({1, 2, 3}, {0, 0, 1}), lineThrough({1, 2, 4}, {0, 0, 1}));
}

TEST(FindMark, ByAnId_FindsItselfAndNotWhatAccompaniesIt) {
  const Figure figure{{withId(pointAt({1, 0, 0}), "F/angle"), withId(pointAt({2, 0, 0}), "F")}};
  EXPECT_EQ(findMark(figure, "F"), &figure.marks[1]);
  EXPECT_EQ(findMark(figure, "F/angle"), &figure.marks[0]);
  EXPECT_EQ(findMark(figure, "angle"), nullptr);
  EXPECT_EQ(leadingId(baseOf(figure.marks[0])), "F");
  EXPECT_EQ(leadingId(baseOf(figure.marks[1])), "F");
}

TEST(Figure, OfEveryKindOfMark_SaysWhatTheyAllHave) {
  Figure figure;
  figure.add(withId(pointAt({0, 0, 0}), "a"));
  figure.add(withId(SphereMark(), "b", Subject::Triangle));
  figure.add(withId(ArcMark(), "c"));
  figure.marks.change(1, [](Mark &mark) { baseOf(mark).label = "S"; });
  EXPECT_EQ(baseOf(figure.marks[2]).id, "c");
  EXPECT_EQ(std::get<SphereMark>(figure.marks[1]).label, "S");
  EXPECT_EQ(baseOf(figure.marks[1]).subject, Subject::Triangle);
}

TEST(WithoutNumbers, AFigure_KeepsItsLettersAndItsPlaces) {
  PointMark point = withId(pointAt({1, 2, 3}), "d");
  point.label = "d";
  point.numbers = " = 10";
  const Figure figure = withoutNumbers({{point, withId(pointAt({4, 5, 6}), "Q")}});
  point.numbers.clear();
  EXPECT_EQ(figure.marks.front(), Mark(point));
  EXPECT_EQ(figure.marks.size(), 2U);
}

/// Numbers that mean nothing, the same in every run.
struct RandomPlaces {
  std::mt19937_64 engine{7};
  Place next(double size) {
    std::uniform_real_distribution<double> number(-size, size);
    return {number(engine), number(engine), number(engine)};
  }
};

/// Whether a place of a plane lies on the patch, at least so far from its sides.
void expectInside(const std::vector<Place> &corners, const Place &place, double margin) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Place inward = glm::normalize(corners[(i + 2) % 4] - corners[(i + 1) % 4]);
    EXPECT_GE(glm::dot(place - corners[i], inward), margin - rounding) << "side " << i;
  }
}

TEST(PatchCorners, OfRandomPlanes_AreRectanglesAroundTheFeetOfWhatTheyCover) {
  RandomPlaces random;
  for (int i = 0; i < 200; ++i) {
    const Place center = random.next(5);
    const Place normal = glm::normalize(random.next(1));
    const Place covered = center + random.next(8);
    const std::vector<Place> corners = cornersOf(patchAt(center, normal, {covered}));
    ASSERT_EQ(corners.size(), 4U);
    for (std::size_t c = 0; c < 4; ++c) {
      const Place side = corners[(c + 1) % 4] - corners[c];
      EXPECT_NEAR(glm::dot(side, corners[(c + 2) % 4] - corners[(c + 1) % 4]), 0, 1e-6);
      EXPECT_NEAR(glm::dot(corners[c] - center, normal), 0, rounding);
      EXPECT_GE(glm::length(side), minimumPatchSide - rounding);
    }
    EXPECT_NEAR(corners[0].z, corners[1].z, rounding) << "one pair of sides is level";
    expectInside(corners, covered - normal * glm::dot(covered - center, normal), patchMargin);
    expectInside(corners, center, minimumPatchSide / 2);
  }
}

TEST(PatchCorners, OfALevelPlane_AreASquareAlongTheAxes) {
  const double half = minimumPatchSide / 2;
  const std::vector<Place> corners = cornersOf(patchAt({1, 2, 3}, {0, 0, 5}));
  ASSERT_EQ(corners.size(), 4U);
  for (const Place &expected : {Place(1 - half, 2 - half, 3), Place(1 + half, 2 - half, 3),
                                Place(1 + half, 2 + half, 3), Place(1 - half, 2 + half, 3)})
    EXPECT_EQ(std::count(corners.begin(), corners.end(), expected), 1);
}

TEST(PatchCorners, CoveringAFarPlace_EndAtTheFarthestReachOnThatSideAlone) {
  const double half = minimumPatchSide / 2;
  for (const double side : {-1.0, 1.0}) {
    const std::vector<Place> corners =
        cornersOf(patchAt({0, 0, 0}, {0, 0, 1}, {{side * 900, 0, 0}, {0, side * 9, 50}}));
    ASSERT_EQ(corners.size(), 4U);
    for (const double x : {-half, maximumPatchReach})
      for (const double y : {-half, 9 + patchMargin})
        EXPECT_EQ(std::count(corners.begin(), corners.end(), Place(side * x, side * y, 0)), 1);
  }
}

TEST(PatchCorners, CoveringAPlaceThatIsNone_AreAsWithoutIt) {
  const Place normal(1, 2, 2);
  const double endless = std::numeric_limits<double>::infinity();
  const std::vector<Place> nowhere{{endless, 0, 0}, {0, std::nan(""), 0}};
  EXPECT_EQ(cornersOf(patchAt({0, 0, 0}, normal, nowhere)), cornersOf(patchAt({0, 0, 0}, normal)));
}

TEST(LineEnds, OfRandomLines_LieOnThemBehindAllThatTheyCover) {
  RandomPlaces random;
  for (int i = 0; i < 200; ++i) {
    const LineMark line =
        lineThrough(random.next(5), random.next(3), {random.next(40), random.next(40), random.next(5)});
    const auto [low, high] = endsOf(line);
    const Place along = glm::normalize(line.direction);
    EXPECT_NEAR(glm::length(glm::cross(low - line.through, along)), 0, rounding);
    EXPECT_NEAR(glm::length(glm::cross(high - line.through, along)), 0, rounding);
    EXPECT_LE(glm::dot(low - line.through, along), -lineReach + rounding);
    EXPECT_GE(glm::dot(high - line.through, along), lineReach - rounding);
    for (const Place &covered : line.covers) {
      EXPECT_GE(glm::dot(high - covered, along), beyondHit - rounding);
      EXPECT_GE(glm::dot(covered - low, along), beyondHit - rounding);
    }
  }
}

TEST(PatchCorners, WhereNothingCanBeDrawn_AreNone) {
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(cornersOf(patchAt({0, 0, 0}, {0, endless, 0})).empty());
  EXPECT_TRUE(cornersOf(patchAt({endless, 0, 0}, {0, 0, 1})).empty());
  EXPECT_FALSE(isFinite({0, std::nan(""), 0}));
}

TEST(Figure, WithoutItsNumbers_SharesTheMarksThatHadNone) {
  Figure figure;
  figure.add(withId(pointAt({0, 0, 0}), "a"));
  figure.add(withId(pointAt({1, 0, 0}), "b"));
  figure.marks.change(1, [](Mark &mark) { baseOf(mark).numbers = "= 1"; });
  const Figure bare = withoutNumbers(figure);
  EXPECT_EQ(&bare.marks[0], &figure.marks[0]);
  EXPECT_TRUE(baseOf(bare.marks[1]).numbers.empty());
  EXPECT_EQ(baseOf(figure.marks[1]).numbers, "= 1");
}

TEST(Figure, WithoutItsNumbers_HasNoCoordinatesToBeWritten) {
  PointMark point = withId(pointAt({4, 5, 6}), "Q");
  point.label = "Q";
  point.coordinates = "{(4,5,6)}";
  const Figure bare = withoutNumbers({{point}});
  EXPECT_EQ(std::get<PointMark>(bare.marks[0]).coordinates, "");
  EXPECT_EQ(baseOf(bare.marks[0]).label, "Q");
}

TEST(Reaching, AMarkThatNothingReaches_IsShared) {
  Figure figure;
  figure.add(withId(patchAt({0, 0, 0}, {0, 0, 1}), "E"));
  figure.add(withId(patchAt({0, 0, 1}, {0, 0, 1}), "G"));
  figure.reaches = {{"E", {3, 0, 0}}};
  const Figure drawn = reaching(figure);
  EXPECT_EQ(std::get<PlanePatchMark>(drawn.marks[0]).covers, std::vector<Place>{Place(3, 0, 0)});
  EXPECT_EQ(&drawn.marks[1], &figure.marks[1]);
}

} // namespace
} // namespace halfspace
