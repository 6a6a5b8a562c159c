// Patches, lines and rays that are drawn as far as they were, and on their way to as far as they must.
#include "lessons/figure/extents.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Figure reachingTo(const Place &covered) {
  Figure figure;
  figure.add(PlanePatchMark{{"E"}, {0, 0, 0}, {0, 0, 1}, {covered}});
  figure.add(LineMark{{"g"}, {0, 0, 0}, {2, 0, 0}, {covered}});
  figure.add(RayMark{{"L"}, {0, 0, 0}, {3, 0, 0}, covered});
  figure.add(PointMark{{"Q"}, covered});
  return figure;
}

Place farCornerOf(const Figure &figure) { return cornersOf(std::get<PlanePatchMark>(figure.marks[0]))[2]; }
Place endOfLineIn(const Figure &figure) { return endsOf(std::get<LineMark>(figure.marks[1])).second; }
Place endOfRayIn(const Figure &figure) { return endOf(std::get<RayMark>(figure.marks[2])); }

TEST(Extents, Held_AreDrawnAsFar_ButLinesAndRaysUpToWhatLiesOnThem) {
  const Place farPlace(20, 0, 0);
  const Figure near = reachingTo({3, 0, 0});
  const Figure far = reachingTo(farPlace);
  ASSERT_NE(farCornerOf(near), farCornerOf(far));
  const Figure held = heldAt(far, extentsOf(near));
  EXPECT_EQ(farCornerOf(held), farCornerOf(near));
  EXPECT_EQ(endOfLineIn(held), farPlace);
  EXPECT_EQ(endOfRayIn(held), farPlace);
}

TEST(Extents, HeldFarther_AreDrawnAsFarWhateverTheyCover) {
  const Figure near = reachingTo({3, 0, 0});
  const Figure far = reachingTo({20, 0, 0});
  const Figure held = heldAt(near, extentsOf(far));
  EXPECT_EQ(farCornerOf(held), farCornerOf(far));
  EXPECT_EQ(endOfLineIn(held), endOfLineIn(far));
  EXPECT_EQ(endOfRayIn(held), endOfRayIn(far));
}

TEST(Extents, OfAMarkThatIsNotHeld_StayItsOwn) {
  const Figure far = reachingTo({20, 0, 0});
  Extents extents = extentsOf(reachingTo({3, 0, 0}));
  extents.erase("L");
  EXPECT_EQ(endOfRayIn(heldAt(far, extents)), endOfRayIn(far));
}

TEST(Extents, OfAMarkThatMoves_GoWithIt) {
  Figure moved = reachingTo({3, 0, 0});
  const Extents before = extentsOf(moved);
  moved.marks.change(0, [](Mark &mark) { std::get<PlanePatchMark>(mark).center = {0, 0, 5}; });
  EXPECT_EQ(farCornerOf(heldAt(moved, before)), farCornerOf(reachingTo({3, 0, 0})) + Place(0, 0, 5));
}

TEST(Extents, BetweenTwo_GoFromOneToTheOther) {
  const Figure far = reachingTo({20, 0, 0});
  const Extents from = extentsOf(reachingTo({3, 0, 0}));
  const Extents to = extentsOf(far);
  EXPECT_EQ(between(from, to, 0), from);
  EXPECT_EQ(between(from, to, 1), to);
  const Place half = farCornerOf(heldAt(far, between(from, to, 0.5)));
  EXPECT_EQ(half, (farCornerOf(far) + farCornerOf(reachingTo({3, 0, 0}))) / 2.0);
  EXPECT_TRUE(between(from, {}, 0.5).empty());
}

} // namespace
} // namespace halfspace
