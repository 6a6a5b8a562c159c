#include "lessons/scene/hand/snapping.h"

#include "geometry/intersect_ray_sphere.h"
#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

using namespace test;

/// A hundred pixels to the unit, seen without perspective, is far enough from any real camera's trouble.
constexpr double pixelsPerUnit = 100;
constexpr double catchPixels = 10;

struct Drag {
  Scene scene;
  std::string id;
  Rational step = 1;

  SnappedPlace to(const Place &raw, const Flat &freedom) const {
    const Handle dragged = handle(scene, id);
    return snap({scene, dragged, snapTargets(scene, dragged), raw, freedom, step,
                 [](const Place &a, const Place &b) { return glm::distance(a, b) * pixelsPerUnit; },
                 catchPixels});
  }
  SnappedPlace horizontally(double x, double y) const {
    const ExactVec3 at = handle(scene, id).at;
    return to({x, y, toDouble(at.z)}, Flat::plane(at, {0, 0, 1}));
  }
  SnappedPlace vertically(double z) const {
    const ExactVec3 at = handle(scene, id).at;
    return to({toDouble(at.x), toDouble(at.y), z}, Flat::line(at, {0, 0, 1}));
  }
};

Scene with(std::initializer_list<Entry> entries) { return Scene{entries}; }

TEST(Grid, AFreePointDraggedFlat_RoundsXAndYAndKeepsZExactly) {
  const Scene scene = with({{"Q", PointObject{{1, 2, q(1, 3)}}}});
  EXPECT_EQ(Drag({scene, "Q", q(1, 2)}).horizontally(3.3, 4.2).at, ExactVec3(q(7, 2), 4, q(1, 3)));
  EXPECT_EQ(Drag({scene, "Q", q(1, 2)}).horizontally(3.3, 4.2).caughtBy, "");
  EXPECT_EQ(Drag({scene, "Q", q(1, 1000)}).horizontally(3.3, 4.2).at,
            ExactVec3(q(33, 10), q(21, 5), q(1, 3)));
}

TEST(Grid, AFreePointDraggedUpright_RoundsZAlone) {
  const Scene scene = with({{"Q", PointObject{{q(1, 7), 2, 3}}}});
  EXPECT_EQ(Drag({scene, "Q"}).vertically(4.6).at, ExactVec3(q(1, 7), 2, 5));
}

TEST(Grid, ADirectionFromAFractionalStart_RoundsTheArrowNotTheTip) {
  const Scene scene = with({{"L", RayObject{{q(1, 3), 0, 0}, {1, 1, 1}}}});
  EXPECT_EQ(Drag({scene, "L.r"}).horizontally(2.4, 3.1).at, ExactVec3(q(7, 3), 3, 1));
}

TEST(Grid, APlanesOffset_PutsTheCoordinateThatChangesMostOnTheGrid) {
  const Scene scene = with({{"E", PlaneObject{{5, 4, 7}, {30, 10, 20}}}});
  const Flat along = Flat::line({5, 4, 7}, {3, 1, 2});
  const Place raw = Place(5, 4, 7) + 0.4 * Place(3, 1, 2);
  EXPECT_EQ(Drag({scene, "E.offset"}).to(raw, along).at, ExactVec3(6, q(13, 3), q(23, 3)));
  EXPECT_EQ(Drag({scene, "E.offset", q(1, 2)}).to(raw, along).at, ExactVec3(6, q(13, 3), q(23, 3)));
  EXPECT_EQ(Drag({scene, "E.offset", q(1, 10)}).to(raw, along).at,
            ExactVec3(q(62, 10), q(44, 10), q(78, 10)));
}

TEST(Grid, AWholeTriangle_PutsItsFirstCornerOnTheGrid) {
  const Drag drag{with({triangleT()}), "T.whole"};
  EXPECT_EQ(drag.horizontally(6.3, 20.0 / 3).at, ExactVec3(6, q(20, 3), q(13, 3)));
}

TEST(SnapPosition, NearAVertexInTheSamePlaneOfMotion_CatchesThere) {
  const Scene scene =
      with({{"Q", PointObject{{0, 0, 4}}}, {"T", TriangleObject{{9, 9, 0}, {q(3, 2), 9, 4}, {5, 2, 9}}}});
  const SnappedPlace place = Drag({scene, "Q"}).horizontally(1.55, 9.03);
  EXPECT_EQ(place.at, ExactVec3(q(3, 2), 9, 4));
  EXPECT_EQ(place.caughtBy, "corner P₁");
}

TEST(SnapPosition, AVertexAtAnotherHeight_DoesNotCatch) {
  const Scene scene = with({{"Q", PointObject{{0, 0, 5}}}, {"S", PointObject{{q(3, 2), 9, 4}}}});
  const SnappedPlace place = Drag({scene, "Q"}).horizontally(1.52, 9.0);
  EXPECT_EQ(place.at, ExactVec3(2, 9, 5));
  EXPECT_EQ(place.caughtBy, "");
}

TEST(SnapPosition, FurtherThanTheCatch_StaysOnTheGrid) {
  const Scene scene = with({{"Q", PointObject{{0, 0, 0}}}, {"S", PointObject{{q(1, 2), 0, 0}}}});
  EXPECT_EQ(Drag({scene, "Q"}).horizontally(0.59, 0).at, ExactVec3(q(1, 2), 0, 0));
  EXPECT_EQ(Drag({scene, "Q"}).horizontally(0.61, 0).at, ExactVec3(1, 0, 0));
}

TEST(SnapPosition, WhereThePlaneHasAGridPlaceNearby_TakesItOverTheFoot) {
  // E: x + 2y + 2z = 27; at z = 8 its line x + 2y = 11 holds (3, 4).
  const Scene scene = with({planeE(), pointQ()});
  const SnappedPlace place = Drag({scene, "Q"}).horizontally(3.04, 4.02);
  EXPECT_EQ(place.at, ExactVec3(3, 4, 8));
  EXPECT_EQ(place.caughtBy, "plane E");
}

TEST(SnapPosition, WhereThePlaneHasNoGridPlaceNearby_TakesShortFractions) {
  const Scene scene = with({planeE(), pointQ()});
  const SnappedPlace place = Drag({scene, "Q"}).horizontally(4.03, 3.52);
  EXPECT_EQ(place.at, ExactVec3(4, q(7, 2), 8));
  EXPECT_EQ(place.caughtBy, "plane E");
}

TEST(SnapPosition, OnAGridPlaceBesideThePlane_StaysThere) {
  const Scene scene = with({{"E", PlaneObject{{q(39, 10), 4, 8}, {1, 0, 0}}}, pointQ()});
  EXPECT_EQ(Drag({scene, "Q"}).horizontally(3.99, 4.0).at, ExactVec3(4, 4, 8));
  EXPECT_EQ(Drag({scene, "Q"}).horizontally(3.94, 4.0).at, ExactVec3(q(39, 10), 4, 8));
  // With so fine a grid every place is near to one.
  EXPECT_EQ(Drag({scene, "Q", q(1, 16)}).horizontally(3.87, 4.0).at, ExactVec3(q(39, 10), 4, 8));
}

TEST(SnapPosition, AlongTheVertical_MeetsThePlaneExactly) {
  const Scene scene = with({planeE(), {"Q", PointObject{{4, 4, 0}}}});
  const SnappedPlace place = Drag({scene, "Q"}).vertically(7.45);
  EXPECT_EQ(place.at, ExactVec3(4, 4, q(15, 2)));
  EXPECT_EQ(place.caughtBy, "plane E");
}

TEST(SnapPosition, OnAnEdge_CatchesBetweenItsEndsOnly) {
  const Scene scene =
      with({{"T", TriangleObject{{0, 0, 0}, {4, 2, 0}, {0, 9, 9}}}, {"Q", PointObject{{8, 8, 0}}}});
  const SnappedPlace on = Drag({scene, "Q"}).horizontally(1.03, 0.48);
  EXPECT_EQ(on.at, ExactVec3(1, q(1, 2), 0));
  EXPECT_EQ(on.caughtBy, "edge P₀P₁");
  EXPECT_NE(Drag({scene, "Q"}).horizontally(5.03, 2.52).caughtBy, "edge P₀P₁");
}

TEST(SnapPosition, ACornerBetweenTheOthers_IsCaughtInLineWithThem) {
  const Scene scene = with({{"T", TriangleObject{{0, 0, 0}, {4, 2, 0}, {3, 9, 0}}}});
  const SnappedPlace place = Drag({scene, "T.P2"}).horizontally(6.02, 3.03);
  EXPECT_EQ(place.at, ExactVec3(6, 3, 0));
  EXPECT_EQ(place.caughtBy, "in line with P₀ and P₁");
}

TEST(SnapPosition, WithLongFractionsOnly_IsNotOffered) {
  const Rational awkward(1, 12345678);
  const Scene scene = with({{"S", PointObject{{q(1, 2) + awkward, 0, 0}}}, {"Q", PointObject{{0, 0, 0}}}});
  const SnappedPlace place = Drag({scene, "Q"}).horizontally(0.5, 0);
  EXPECT_EQ(place.at, ExactVec3(1, 0, 0));
  EXPECT_EQ(place.caughtBy, "");
}

TEST(SnapDirection, NearParallelToAPlane_IsExactlyParallel) {
  // r·n = 0 for n = (1, 2, 2): with r.z = 2 the arrows r.x + 2·r.y = −4.
  const Scene scene = with({planeE(), rayL()});
  const SnappedPlace place = Drag({scene, "L.r"}).horizontally(11 - 2 + 0.04, 15 - 1 - 0.03);
  EXPECT_EQ(place.at - ExactVec3(11, 15, 8), ExactVec3(-2, -1, 2));
  EXPECT_EQ(place.caughtBy, "parallel to E");
}

TEST(SnapDirection, FromAStartInThePlane_LiesInIt) {
  const Scene scene = with({planeE(), {"L", RayObject{{5, 4, 7}, {-1, 3, 2}}}});
  EXPECT_EQ(Drag({scene, "L.r"}).horizontally(5 - 2, 4 - 1).caughtBy, "in the plane E");
}

TEST(SnapDirection, AlongAnAxis_IsNamed) {
  const Scene scene = with({{"L", RayObject{{1, 1, 1}, {2, 3, 0}}}});
  const SnappedPlace along = Drag({scene, "L.r"}).horizontally(4.4, 1.05);
  EXPECT_EQ(along.at, ExactVec3(4, 1, 1)) << "it slides on the grid";
  EXPECT_EQ(along.caughtBy, "axis-parallel");
  const SnappedPlace beside = Drag({scene, "L.r"}).horizontally(4.4, 1.6);
  EXPECT_EQ(beside.at, ExactVec3(4, 2, 1));
  EXPECT_EQ(beside.caughtBy, "");
}

TEST(SnapDirection, TowardsAVertex_GoesExactlyThroughIt) {
  const Scene scene =
      with({{"L", RayObject{{0, 0, 0}, {1, 1, 1}}}, {"T", TriangleObject{{3, 5, 4}, {9, 9, 9}, {0, 9, 0}}}});
  const SnappedPlace place = Drag({scene, "L.r"}).horizontally(0.77, 1.24);
  EXPECT_EQ(place.at, ExactVec3(q(3, 4), q(5, 4), 1));
  EXPECT_EQ(place.caughtBy, "through corner P₀");
}

TEST(SnapDirection, TowardsAnEdge_CrossesItBetweenItsEnds) {
  const Scene scene =
      with({{"L", RayObject{{0, 0, 0}, {1, 1, 2}}}, {"T", TriangleObject{{4, 0, 4}, {0, 4, 4}, {9, 9, 1}}}});
  // The edge's plane from the origin is x + y = z.
  const SnappedPlace place = Drag({scene, "L.r"}).horizontally(0.96, 1.02);
  EXPECT_EQ(place.at, ExactVec3(1, 1, 2));
  EXPECT_EQ(place.caughtBy, "through edge P₀P₁");
  EXPECT_NE(Drag({scene, "L.r"}).horizontally(4.0, -2.02).caughtBy, "through edge P₀P₁");
}

TEST(SnapDirection, ToNothing_IsNeverASpecialCase) {
  const Scene scene = with({planeE(), {"L", RayObject{{5, 4, 7}, {2, 3, 0}}}});
  const SnappedPlace place = Drag({scene, "L.r"}).horizontally(5.01, 4.01);
  EXPECT_EQ(place.at, ExactVec3(5, 4, 7)) << "the grid place is the zero arrow";
  EXPECT_EQ(place.caughtBy, "");
}

TEST(SnapNormal, NearAnAxis_StandsExactlyOnIt) {
  const Scene scene = with({{"E", PlaneObject{{0, 0, 0}, {1, 1, 2}}}});
  const SnappedPlace place = Drag({scene, "E.n", q(1, 2)}).horizontally(0.06, -0.04);
  EXPECT_EQ(place.at, ExactVec3(0, 0, 2));
  EXPECT_EQ(place.caughtBy, "axis-parallel");
}

TEST(SnapOffset, NearAPoint_GoesExactlyThroughIt) {
  const Scene scene = with({planeE(), pointQ()});
  // Q is 10/3 normals in front of the plane.
  const Place raw = Place(5, 4, 7) + 3.32 * Place(1, 2, 2);
  const SnappedPlace place = Drag({scene, "E.offset"}).to(raw, Flat::line({5, 4, 7}, {1, 2, 2}));
  EXPECT_EQ(place.at, ExactVec3(q(25, 3), q(32, 3), q(41, 3)));
  EXPECT_EQ(place.caughtBy, "through point Q");
}

TEST(SnapOffset, NearTheOrigin_GoesExactlyThroughIt) {
  const Scene scene = with({{"E", PlaneObject{{5, 4, 7}, {3, 1, 2}}}});
  // n·P0 = 33 and n·n = 14.
  const Place raw = Place(5, 4, 7) - 2.37 * Place(3, 1, 2);
  const SnappedPlace place = Drag({scene, "E.offset"}).to(raw, Flat::line({5, 4, 7}, {3, 1, 2}));
  EXPECT_EQ(place.at, ExactVec3(5, 4, 7) - ExactVec3(3, 1, 2) * q(33, 14));
  EXPECT_EQ(place.caughtBy, "through the origin");
}

TEST(SnapOffset, BesideAParallelPlane_BecomesOneWithIt) {
  const Scene scene =
      with({{"E", PlaneObject{{5, 4, 7}, {0, 0, 2}}}, {"F", PlaneObject{{1, 1, q(5, 3)}, {0, 0, 1}}}});
  const SnappedPlace place = Drag({scene, "E.offset"}).to({5, 4, 1.7}, Flat::line({5, 4, 7}, {0, 0, 1}));
  EXPECT_EQ(place.at, ExactVec3(5, 4, q(5, 3)));
  EXPECT_EQ(place.caughtBy, "the same plane as F");
}

TEST(SnapNormal, BesideAnotherPlanesNormal_IsExactlyParallelToIt) {
  const Scene scene =
      with({{"E", PlaneObject{{0, 0, 0}, {2, 1, 4}}}, {"F", PlaneObject{{9, 9, 9}, {1, 2, 2}}}});
  const SnappedPlace place = Drag({scene, "E.n"}).horizontally(2.05, 3.96);
  EXPECT_EQ(place.at, ExactVec3(2, 4, 4));
  EXPECT_EQ(place.caughtBy, "parallel to F");
  const SnappedPlace square = Drag({scene, "E.n"}).horizontally(-4.03, -1.97);
  EXPECT_EQ(square.at, ExactVec3(-4, -2, 4));
  EXPECT_EQ(square.caughtBy, "perpendicular to F");
}

TEST(SnapStart, OfARay_CatchesWhereTheRayGoesThroughAnEdgeOrAVertex) {
  const Scene scene = with({{"L", RayObject{{9, 0, 2}, {0, 0, -1}}},
                            {"T", TriangleObject{{0, 0, 0}, {4, 2, 0}, {0, 9, q(1, 2)}}}});
  const SnappedPlace edge = Drag({scene, "L.Q"}).horizontally(1.03, 0.48);
  EXPECT_EQ(edge.at, ExactVec3(1, q(1, 2), 2));
  EXPECT_EQ(edge.caughtBy, "through edge P₀P₁");
  EXPECT_EQ(Drag({scene, "L.Q"}).horizontally(5.03, 2.52).caughtBy, "") << "behind the edge's end";
  const SnappedPlace vertex = Drag({scene, "L.Q"}).horizontally(0.05, 8.96);
  EXPECT_EQ(vertex.at, ExactVec3(0, 9, 2));
  EXPECT_EQ(vertex.caughtBy, "through corner P₂");
}

TEST(SnapDirection, WhoseTipNearsAPlane_EndsExactlyOnIt) {
  const Scene scene =
      with({{"E", PlaneObject{{0, 0, 0}, {1, 0, 2}}}, {"L", RayObject{{9, 9, 9}, {1, 1, -8}}}});
  const SnappedPlace place = Drag({scene, "L.r"}).horizontally(-1.96, 7.04); // x + 2z = 0 at z = 1
  EXPECT_EQ(place.at, ExactVec3(-2, 7, 1));
  EXPECT_EQ(place.caughtBy, "the tip on E");
}

/// Where the lesson about spheres begins.
Scene sphereScene() {
  return with({{"S", SphereObject{{5, 6, 5}, 5}}, {"L", RayObject{{10, 13, 9}, {-1, -2, -2}}}});
}

Rational discriminantOf(const Scene &scene, const std::string &id, const ExactVec3 &place) {
  const Handle dragged = handle(scene, id);
  const auto ray = *objectAs<RayObject>(movedTo(*findObject(scene, "L"), dragged, place));
  return intersectRaySphere(Ray<Rational>{ray.origin, ray.direction}, {{5, 6, 5}, Rational(5)}).discriminant;
}

/// Drags from where it is in one direction of the plane of motion, a pixel at a time, until it touches.
SnappedPlace firstTouch(const Drag &drag, double angle) {
  const Place start = toDouble(handle(drag.scene, drag.id).at);
  for (double way = 0; way < 20; way += 1 / pixelsPerUnit) {
    const SnappedPlace at =
        drag.horizontally(start.x + way * std::cos(angle), start.y + way * std::sin(angle));
    if (at.caughtBy == "touching S")
      return at;
  }
  return {};
}

class TouchAlong : public testing::TestWithParam<int> {};

TEST_P(TouchAlong, AnyWayOutOfTheSphere_CatchesWhereTheLineTouchesItExactly) {
  const double angle = GetParam() * std::numbers::pi / 8;
  const Scene scene = sphereScene();
  const SnappedPlace start = firstTouch({scene, "L.Q"}, angle);
  ASSERT_EQ(start.caughtBy, "touching S");
  EXPECT_EQ(discriminantOf(scene, "L.Q", start.at), 0);
  EXPECT_EQ(start.at.z, 9);
  EXPECT_LE(toText(start.at.x.denominator()).size(), longestSnapDenominator);
}

INSTANTIATE_TEST_SUITE_P(Directions, TouchAlong, testing::Range(0, 16));

TEST(SnapTouching, ByItsTip_TouchesExactlyToo) {
  const Scene scene = sphereScene();
  const SnappedPlace tip = firstTouch({scene, "L.r"}, 0);
  ASSERT_EQ(tip.caughtBy, "touching S");
  EXPECT_EQ(discriminantOf(scene, "L.r", tip.at), 0);
}

TEST(SnapTouching, WhereNoFractionsTouch_CatchesNowhere) {
  Scene scene = sphereScene();
  setCoordinate(scene, {"L", 1}, {1, 1, 1}); // 3 is no sum of two squares
  EXPECT_EQ(firstTouch({scene, "L.Q"}, 0).caughtBy, "");
}

TEST(SnapTouching, FromTheSphereItself_IsAPlaneOfDirections) {
  Scene scene = sphereScene();
  setCoordinate(scene, {"L", 0}, {10, 6, 5});
  const SnappedPlace tip = Drag({scene, "L.r"}).horizontally(10.03, 4.1);
  EXPECT_EQ(tip.caughtBy, "touching S");
  EXPECT_EQ(tip.at, ExactVec3(10, 4, 3));
}

TEST(SnapPosition, AtTheOrigin_IsNamed) {
  const Scene scene = with({{"Q", PointObject{{3, 3, 0}}}});
  EXPECT_EQ(Drag({scene, "Q"}).horizontally(0.04, -0.03).caughtBy, "the origin");
}

TEST(Snap, Suspended_CatchesNowhereAndGoesByThousandths) {
  const Scene scene = with({planeE(), pointQ()});
  const SnappedPlace place = Drag({scene, "Q", finestStep}).horizontally(4.03, 3.5201);
  EXPECT_EQ(place.at, ExactVec3(q(403, 100), q(352, 100), 8));
  EXPECT_EQ(place.caughtBy, "");
}

TEST(Snap, WithAViewThatCannotTellDistances_StaysOnTheGrid) {
  const Scene scene = with({planeE(), pointQ()});
  const Handle dragged = handle(scene, "Q");
  const auto blind = [](const Place &, const Place &) { return std::numeric_limits<double>::quiet_NaN(); };
  const SnappedPlace place = snap({scene,
                                   dragged,
                                   snapTargets(scene, dragged),
                                   {3.1, 4.1, 8},
                                   Flat::plane(dragged.at, {0, 0, 1}),
                                   1,
                                   blind,
                                   10});
  EXPECT_EQ(place.at, ExactVec3(3, 4, 8));
  EXPECT_EQ(place.caughtBy, "");
}

} // namespace
} // namespace halfspace
