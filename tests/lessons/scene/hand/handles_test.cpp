#include "tests/lessons/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

using namespace test;

TEST(Handles, OfEveryKind_AreNamedAfterWhatTheyMove) {
  std::vector<std::string> ids;
  for (const Handle &each : handlesOf(Scene{{pointQ(), planeE(), rayL(), triangleT()}}))
    ids.push_back(each.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"Q", "E.P0", "E.n", "E.offset", "L.Q", "L.r", "T.P0", "T.P1",
                                           "T.P2", "T.whole"}));
}

TEST(Handles, OfADirection_SitAtItsTip) {
  const Handle tip = handle(Scene{{rayL()}}, "L.r");
  EXPECT_EQ(tip.at, ExactVec3(10, 18, 10));
  EXPECT_EQ(tip.base, ExactVec3(11, 15, 8));
  const Scene scene{{rayL()}};
  const Object moved = movedTo(*findObject(scene, "L"), tip, {11, 15, 9});
  EXPECT_EQ(moved, Object(RayObject{{11, 15, 8}, {0, 0, 1}}));
}

TEST(Handles, OfAZeroNormal_HaveNoOffset) {
  EXPECT_EQ(handlesOf(Scene{{{"E", PlaneObject{{1, 2, 3}, {0, 0, 0}}}}}).size(), 2U);
}

TEST(MovedTo, ThePlanesPoint_LeavesItsNormal) {
  const Scene scene{{planeE()}};
  EXPECT_EQ(movedTo(*findObject(scene, "E"), handle(scene, "E.P0"), {0, 0, 0}),
            Object(PlaneObject{{0, 0, 0}, {1, 2, 2}}));
}

TEST(MovedTo, TheOffset_MovesAlongTheNormalByTheExactProjection) {
  const Scene scene{{planeE()}};
  // (1, 0, 0) has the part 1/9 of n = (1, 2, 2) in it.
  EXPECT_EQ(movedTo(*findObject(scene, "E"), handle(scene, "E.offset"), {6, 4, 7}),
            Object(PlaneObject{{q(46, 9), q(38, 9), q(65, 9)}, {1, 2, 2}}));
}

TEST(MovedTo, TheWholeTriangle_KeepsItsShape) {
  const Scene scene{{triangleT()}};
  const Handle whole = handle(scene, "T.whole");
  EXPECT_EQ(whole.at, ExactVec3(5, q(20, 3), q(13, 3)));
  EXPECT_EQ(whole.at - whole.base, ExactVec3(9, 9, 0)) << "the first corner is snapped";
  EXPECT_EQ(movedTo(*findObject(scene, "T"), whole, whole.at + ExactVec3(1, -1, 2)),
            Object(TriangleObject{{10, 8, 2}, {2, 8, 6}, {6, 1, 11}}));
}

TEST(KeepStill, OfAWholeThatACornerComesUpon_LeavesItInTheMiddle) {
  const auto handlesWith = [](const Rational &z) {
    const Scene scene{{{"T", TriangleObject{{0, 0, z}, {5, 4, 0}, {-5, -4, 0}}}}};
    return handlesOf(scene);
  };
  const auto wholeOf = [](const std::vector<Handle> &handles) {
    return *std::find_if(handles.begin(), handles.end(),
                         [](const Handle &handle) { return handle.id == "T.whole"; });
  };
  std::vector<Handle> held = handlesWith(2);
  for (int i = 20; i >= -20; --i) {
    const std::vector<Handle> before = std::exchange(held, handlesWith(q(i, 10)));
    keepStill(held, before);
    EXPECT_EQ(wholeOf(held).at, ExactVec3(0, 0, q(i, 30))) << i;
    EXPECT_EQ(wholeOf(held).at - wholeOf(held).base, ExactVec3(0, 0, q(i, 10))) << "the corner is snapped";
  }
  EXPECT_NE(wholeOf(handlesWith(0)).at.z, 0) << "without a hand it keeps off the corner";
}

struct WholeOfATriangle : testing::TestWithParam<TriangleObject> {};

TEST_P(WholeOfATriangle, IsTakenByAHandleThatIsOnNoCorner) {
  const Object triangle(GetParam());
  const Scene scene{{{"T", triangle}}};
  const Handle whole = handle(scene, "T.whole");
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const double way = glm::distance(toDouble(whole.at), toDouble(triangle[corner]));
    EXPECT_GE(way, 1 - 1e-9) << corner; // but for rounding
    EXPECT_LE(way, 8) << corner << ": it stays with the triangle";
  }
  EXPECT_EQ(movedTo(triangle, whole, whole.at), triangle);
}

INSTANTIATE_TEST_SUITE_P(
    Degenerate, WholeOfATriangle,
    testing::Values(TriangleObject{{2, 3, 1}, {5, 3, 1}, {-1, 3, 1}}, // P0 is in the middle
                    TriangleObject{{2, 3, 1}, {2, 3, 4}, {2, 3, -2}}, // so it is, upright
                    TriangleObject{{2, 3, 1}, {2, 3, 1}, {2, 3, 1}},
                    TriangleObject{{2, 3, 1}, {2, 3, 1}, {2, q(7, 2), 1}},
                    TriangleObject{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}));

TEST(Handles, OfAWhole_RiseWithoutAJump_WhereACornerComesToTheMiddle) {
  const auto heightWith = [](const Rational &x) {
    return toDouble(
        handle(Scene{{{"T", TriangleObject{{x, 0, 0}, {5, 4, 0}, {-5, -4, 0}}}}}, "T.whole").at.z);
  };
  EXPECT_EQ(heightWith(2), 0);
  double last = 0;
  for (int i = 200; i >= 0; --i) {
    const double height = heightWith(q(i, 100));
    EXPECT_LT(height - last, 0.2) << i;
    EXPECT_GE(height, last) << i;
    last = height;
  }
  EXPECT_EQ(last, 1);
}

TEST(Handles, OfWhatIsHiddenOrLocked_AreNone) {
  for (bool Entry::*look : {&Entry::isHidden, &Entry::isLocked}) {
    Scene scene = distanceScene();
    const auto countOf = [&](const std::string &object) {
      const std::vector<Handle> handles = handlesOf(scene);
      return std::count_if(handles.begin(), handles.end(),
                           [&](const Handle &handle) { return handle.object == object; });
    };
    EXPECT_EQ(countOf("Q"), 1);
    const auto ofPlane = countOf("E");
    scene.entries.change(*scene.entries.placeOf("Q"), [&](Entry &entry) { entry.*look = true; });
    EXPECT_EQ(countOf("Q"), 0);
    EXPECT_EQ(countOf("E"), ofPlane);
  }
}

} // namespace
} // namespace halfspace
