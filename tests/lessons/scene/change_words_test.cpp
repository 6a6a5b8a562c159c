// How the history says what was done.
#include "lessons/scene/change_words.h"

#include "tests/lessons/object/spelled_objects.h"
#include "tests/lessons/objects.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

std::string moving(const Scene &scene, const std::string &id) {
  return wordsForMoving(scene, handle(scene, id));
}

const Scene &scene() {
  static const Scene scene{{planeE(), pointQ(), {"L", RayObject{{1, 2, 3}, {-1, 3, 2}}}, triangleT()}};
  return scene;
}

TEST(ChangeWords, OfAHandle_SayWhatItDoesByTheLettersThatAreSeen) {
  const Scene scene{{planeE(), rayL()}};
  EXPECT_EQ(moving(scene, "E.P0"), "Move P₀ of E");
  EXPECT_EQ(moving(scene, "E.n"), "Move the tip of n");
  EXPECT_EQ(moving(scene, "E.offset"), "Slide E along its normal");
  EXPECT_EQ(moving(scene, "L.Q"), "Move Q") << "no L is seen";
  EXPECT_EQ(moving(scene, "L.r"), "Move the tip of r");
  EXPECT_EQ(moving({{pointQ()}}, "Q"), "Move Q");
  EXPECT_EQ(moving({{triangleT()}}, "T.P1"), "Move P₁");
  EXPECT_EQ(moving({{triangleT()}}, "T.whole"), "Move T as a whole");
}

TEST(ChangeWords, OfLettersThatSeveralHave_SayWhoseTheyAreOnce) {
  const Scene scene{{planeE(), {"F", PlaneObject{{0, 0, 0}, {0, 0, 1}}}}};
  EXPECT_EQ(moving(scene, "F.n"), "Move the tip of n_F");
  EXPECT_EQ(moving(scene, "F.P0").find(" of "), std::string::npos);
}

TEST(ChangeWords, OfACoordinate_AreThoseOfItsHandle) {
  for (const Handle &each : handlesOf(scene()))
    if (each.motion == Handle::Motion::Coordinate) {
      EXPECT_EQ(wordsForChanging(scene(), {each.object, each.coordinate}), wordsForMoving(scene(), each));
    }
}

TEST(ChangeWords, OfWhatIsNoPlace_SayThatItIsChanged) {
  const Scene sphere = spelledScene(spelledEntry("sphere"));
  EXPECT_EQ(wordsForChanging(sphere, {"K", 1}), "Change R of K");
  EXPECT_EQ(wordsForChanging(spelledScene(spelledEntry("number")), {"K", 0}), "Change K");
}

TEST(ChangeWords, OfABoundPoint_MoveThePoint) {
  const Scene bound{{{"g", LineObject{{0, 0, 0}, {1, 0, 0}}}, {"P", withNumbers("point-on-line", {1}), "g"}}};
  EXPECT_EQ(moving(bound, "P"), "Move P");
  EXPECT_EQ(wordsForChanging(bound, {"P", 0}), "Move P");
}

TEST(ChangeWords, OfWhatIsNotThere_AreNone) { EXPECT_EQ(wordsForChanging(scene(), {"nothing", 0}), ""); }

} // namespace
} // namespace halfspace
