// The camera of a view whose size changes.
#include "widgets/picture/resized_camera.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ResizedCamera, OfAViewThatGetsItsSizeBack_IsTheCameraThatItWas) {
  ResizedCamera resized;
  resized.setSize({900, 600});
  const Camera before;
  Camera camera = before;
  for (const PixelSize size : {PixelSize{700, 600}, PixelSize{500, 100}, PixelSize{300, 600}})
    camera = resized.resized(camera, size);
  EXPECT_NE(camera, before);
  EXPECT_EQ(resized.resized(camera, {900, 600}), before);
}

TEST(ResizedCamera, OfANarrowerView_ShowsWhatWasBetweenTheSides) {
  ResizedCamera resized;
  resized.setSize({900, 600});
  const Camera camera;
  EXPECT_EQ(resized.resized(camera, {450, 600}), keptBetweenSides(camera, {900, 600}, {450, 600}));
}

TEST(ResizedCamera, ThatWasMovedMeanwhile_IsKeptFromThereOn) {
  ResizedCamera resized;
  resized.setSize({900, 600});
  Camera camera = resized.resized({}, {450, 600});
  camera.turn(0.5, 0);
  const Camera moved = camera;
  camera = resized.resized(camera, {300, 600});
  EXPECT_EQ(camera, keptBetweenSides(moved, {450, 600}, {300, 600}));
  EXPECT_EQ(resized.resized(camera, {450, 600}), moved);
}

TEST(ResizedCamera, OfTheSameSize_IsTheSame) {
  ResizedCamera resized;
  resized.setSize({300, 600});
  EXPECT_EQ(resized.resized({}, {300, 600}), Camera());
}

TEST(ResizedCamera, OfItsFirstSize_ShowsAsMuchAcrossAsASquareWould) {
  EXPECT_EQ(ResizedCamera().resized({}, {900, 600}), Camera());
  EXPECT_EQ(ResizedCamera().resized({}, {300, 600}), keptBetweenSides({}, {1, 1}, {300, 600}));
}

} // namespace
} // namespace halfspace
