#include "widgets/picture/shapes/gizmo_shape.h"

#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

constexpr PixelSize size{1280, 800};

Camera slanted() {
  Camera camera;
  camera.azimuth = 0.8;
  camera.elevation = 0.6;
  return camera;
}

bool shows(const std::vector<GizmoPartShape> &shapes, Gizmo::Part part) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const GizmoPartShape &shape) { return shape.part == part; });
}

TEST(GizmoShape, EveryPartIsHitInItsMiddle) {
  const Gizmo gizmo;
  const std::vector<GizmoPartShape> shapes = gizmoParts(gizmo, slanted(), size, 1);
  ASSERT_EQ(shapes.size(), 6U);
  for (const GizmoPartShape &shape : shapes) {
    Place middle(0);
    for (const Place &corner : shape.outline)
      middle += corner / static_cast<double>(shape.outline.size());
    const auto pixel = slanted().project(middle, size);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(gizmoPartAt(gizmo, slanted(), size, 1, glm::dvec2(*pixel)), shape.part);
  }
}

TEST(GizmoShape, TwiceThePixelRatioIsTwiceAsLargeOnTheScreen) {
  const auto lengthAt = [](double pixelRatio) {
    const auto ends =
        projectAll(slanted(), size, gizmoParts({}, slanted(), size, pixelRatio).front().outline);
    return glm::distance(glm::dvec2(ends->front()), glm::dvec2(ends->back()));
  };
  EXPECT_NEAR(lengthAt(2) / lengthAt(1), 2, 0.1);
}

TEST(GizmoShape, HowNearTheCameraIsDoesNotChangeTheSizeOnTheScreen) {
  const auto lengthAt = [](double height) {
    Camera camera = slanted();
    camera.height = height;
    const auto ends = projectAll(camera, size, gizmoParts({}, camera, size, 1).front().outline);
    return glm::distance(glm::dvec2(ends->front()), glm::dvec2(ends->back()));
  };
  EXPECT_NEAR(lengthAt(3), lengthAt(60), 0.01);
}

TEST(GizmoShape, PartsThatCannotBeGrabbedAreNotShown) {
  Camera level = slanted();
  level.elevation = 0.05;
  const std::vector<GizmoPartShape> shapes = gizmoParts({}, level, size, 1);
  EXPECT_FALSE(shows(shapes, Gizmo::Part::PlaneXY));
  EXPECT_TRUE(shows(shapes, Gizmo::Part::AxisZ));

  Camera above = slanted();
  above.elevation = 1.5;
  EXPECT_FALSE(shows(gizmoParts({}, above, size, 1), Gizmo::Part::AxisZ));
}

/// Where the arrow of x begins on the screen; nothing where it is not shown.
std::optional<glm::dvec2> startOfArrowX(const Gizmo &gizmo) {
  for (const GizmoPartShape &shape : gizmoParts(gizmo, slanted(), size, 1))
    if (shape.part == Gizmo::Part::AxisX)
      return glm::dvec2(slanted().project(shape.outline[0], size).value());
  return {};
}

TEST(GizmoShape, APartOverWhatIsSeenOfAHandleMovesOutBehindIt) {
  Gizmo gizmo;
  const glm::dvec2 before = startOfArrowX(gizmo).value();
  const glm::dvec2 middle(slanted().project({0, 0, 0}, size).value());
  gizmo.clearOf = {{before, before, 8, 8}};
  const auto after = startOfArrowX(gizmo);
  ASSERT_TRUE(after);
  EXPECT_GT(glm::distance(*after, middle), glm::distance(before, middle) + 8);
  EXPECT_GE(distanceTo(gizmo.clearOf[0], *after), gizmoGap);
  EXPECT_EQ(gizmoParts(gizmo, slanted(), size, 1).size(), 6U);
}

TEST(GizmoShape, APartThatFindsNoRoomIsHidden) {
  Gizmo gizmo;
  const glm::dvec2 middle(slanted().project({0, 0, 0}, size).value());
  gizmo.clearOf = {{middle, middle, 300, 300}};
  EXPECT_TRUE(gizmoParts(gizmo, slanted(), size, 1).empty());
}

TEST(GizmoShape, FarFromAllPartsNothingIsHit) {
  EXPECT_FALSE(gizmoPartAt({}, slanted(), size, 1, {100, 100}));
}

TEST(GizmoShape, WithoutAxesNothingIsHit) {
  Gizmo gizmo;
  gizmo.axes = false;
  const auto pixel = slanted().project({0, 0, 1}, size);
  EXPECT_FALSE(gizmoPartAt(gizmo, slanted(), size, 1, glm::dvec2(*pixel)));
}

} // namespace
} // namespace halfspace
