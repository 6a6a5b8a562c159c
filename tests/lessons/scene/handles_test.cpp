#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace halfspace
