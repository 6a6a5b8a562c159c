// What goes by a name in what a scene comes to.
#include "lessons/scene/offered_objects.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

TEST(OfferedObject, IsFoundByTheIdOfAnEntryOrOfWhatItMakes) {
  const Evaluation evaluation = evaluate(distanceScene());
  EXPECT_EQ(findOffered(evaluation, "Q")->given->object, Object(PointObject{{11, 15, 8}}));
  EXPECT_EQ(findOffered(evaluation, "distance.F")->given->id, "distance.F");
  for (const char *none : {"F", "distance", "distance.G", "R", "E.n"})
    EXPECT_FALSE(findOffered(evaluation, none)) << none;
}

TEST(PlaceNamed, IsThatOfAPointOrOfAPosition) {
  const Evaluation evaluation = evaluate(distanceScene());
  EXPECT_EQ(placeNamed(evaluation, "Q"), ExactVec3(11, 15, 8));
  EXPECT_EQ(placeNamed(evaluation, "E.P0"), ExactVec3(5, 4, 7));
  EXPECT_TRUE(placeNamed(evaluation, "distance.F"));
  for (const char *none : {"E", "E.n", "R"})
    EXPECT_FALSE(placeNamed(evaluation, none)) << none;
}

TEST(PlaceNamed, OfWhatIsNotThereNow_IsNone) {
  Scene scene = distanceScene();
  setCoordinate(scene, {"E", 1}, ExactVec3(0)); // without a normal there is no foot
  EXPECT_FALSE(placeNamed(evaluate(scene), "distance.F"));
}

} // namespace
} // namespace halfspace
