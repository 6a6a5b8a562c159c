// The views that are asked for by name: which way they look, and what they have in view.
#include "widgets/picture/named_views.h"

#include "tests/picture/marks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

constexpr Place normal{1, 2, 2};
constexpr Place course{-1, 3, 2};

/// A plane and a point, of which the step shows the plane and a ray.
Sight sightOf() {
  RayMark ray;
  ray.origin = {3, 1, 2};
  ray.direction = course;
  Sight sight;
  sight.whole.marks = {withId(patchAt({5, 4, 7}, normal), "E"), withId(pointAt({11, 15, 8}), "Q")};
  sight.shown.marks = {withId(patchAt({5, 4, 7}, normal), "E"), withId(ray, "L")};
  sight.handles = {{30, -20, 4}};
  return sight;
}

View viewOf() {
  View view;
  view.size = {800, 600};
  view.camera.orthographic = true;
  return view;
}

bool shows(const Camera &camera, const View &view, Place place) {
  const auto pixel = camera.project(place, view.size);
  return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= view.size.width &&
         pixel->y <= view.size.height;
}

TEST(NamedViews, AllOfThem_KeepWhetherTheViewIsOrthographic) {
  for (const NamedView name :
       {NamedView::Home, NamedView::Fit, NamedView::Whole, NamedView::Front, NamedView::Right, NamedView::Top,
        NamedView::AlongPlane, NamedView::FacingPlane, NamedView::DownCourse, NamedView::AgainstCourse})
    for (const bool orthographic : {false, true}) {
      View view = viewOf();
      view.camera.orthographic = orthographic;
      EXPECT_EQ(seenAs(name, sightOf(), view).orthographic, orthographic);
    }
}

TEST(NamedViews, OfTheWhole_HaveFigureAndHandlesInView) {
  const View view = viewOf();
  for (const NamedView name :
       {NamedView::Home, NamedView::Whole, NamedView::Front, NamedView::Right, NamedView::Top,
        NamedView::AlongPlane, NamedView::FacingPlane, NamedView::AgainstCourse}) {
    const Camera camera = seenAs(name, sightOf(), view);
    EXPECT_TRUE(shows(camera, view, {11, 15, 8})) << static_cast<int>(name);
    EXPECT_TRUE(shows(camera, view, {30, -20, 4})) << static_cast<int>(name);
  }
}

TEST(NamedViews, LookWhereTheirNameSays) {
  const View view = viewOf();
  const auto direction = [&](NamedView name) { return seenAs(name, sightOf(), view).viewDirection(); };
  EXPECT_LT(direction(NamedView::Front).x, -0.999);
  EXPECT_LT(direction(NamedView::Right).y, -0.999);
  EXPECT_LT(direction(NamedView::Top).z, -0.999);
  EXPECT_NEAR(glm::dot(direction(NamedView::AlongPlane), normal), 0, 1e-9);
  EXPECT_NEAR(std::abs(glm::dot(direction(NamedView::FacingPlane), glm::normalize(normal))), 1, 1e-9);
  EXPECT_NEAR(glm::dot(direction(NamedView::DownCourse), glm::normalize(course)), 1, 1e-9);
  EXPECT_NEAR(glm::dot(direction(NamedView::AgainstCourse), glm::normalize(course)), -1, 1e-9);
  EXPECT_EQ(direction(NamedView::Fit), view.camera.viewDirection());
  EXPECT_EQ(direction(NamedView::Whole), view.camera.viewDirection());
}

TEST(NamedViews, Home_LooksAsTheLessonBegins_WhereverTheCameraIsNow) {
  View turned = viewOf();
  turned.camera.turn(1, 0.3);
  EXPECT_EQ(seenAs(NamedView::Home, sightOf(), turned), seenAs(NamedView::Home, sightOf(), viewOf()));
}

TEST(NamedViews, Fit_IsOfWhatIsDrawn_WithoutTheAxes) {
  Sight sight = sightOf();
  sight.handles = {{5, 4, 7}};
  const View view = viewOf();
  EXPECT_LT(seenAs(NamedView::Fit, sight, view).height, seenAs(NamedView::Whole, sight, view).height);
  const Camera withAxes = seenAs(NamedView::Fit, sight, view);
  sight.hasAxes = false;
  EXPECT_EQ(seenAs(NamedView::Fit, sight, view), withAxes);
  EXPECT_LT(seenAs(NamedView::Whole, sight, view).height, seenAs(NamedView::Whole, sightOf(), view).height);
}

} // namespace
} // namespace halfspace
