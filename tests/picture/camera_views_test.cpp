// Where the camera stands at home, and which ray it can look down.
#include "widgets/picture/camera_views.h"

#include "lessons/lesson/lesson.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/scene/session.h"
#include "tests/picture/marks.h"
#include "tests/test_name.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/ground.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

TEST(HomeView, OfEveryLesson_ShowsFigureAndAxesWithRoomForLabels) {
  constexpr double room = 29; // pixels
  for (const Lesson &lesson : library().lessons)
    for (const PixelSize size :
         {PixelSize{880, 440}, PixelSize{300, 700}, PixelSize{1000, 250}, PixelSize{1600, 1000}}) {
      SCOPED_TRACE(lesson.id + " " + std::to_string(size.height));
      const Figure figure = figureOf(evaluate(lesson.scene));
      const Camera camera = homeView(lesson.camera, figure, true, size, 1);
      std::vector<Place> places = placesOf(figure);
      for (const AxisEnds &axis : axisEnds(axesAround(figure)))
        places.push_back(axis.high);
      for (const Place &place : places) {
        const auto pixel = camera.project(place, size);
        ASSERT_TRUE(pixel);
        EXPECT_GE(pixel->x, room);
        EXPECT_LE(pixel->x, size.width - room);
        EXPECT_GE(pixel->y, room);
        EXPECT_LE(pixel->y, size.height - room);
      }
    }
}

TEST(HomeView, OfWhatWasWorkedOutFarAway_IsThatOfTheRest) {
  PolygonMark given = polygonOf({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}});
  given.role = Role::Given;
  PointMark worked = pointAt({150, 0, 0});
  worked.role = Role::Derived;
  const auto homeOf = [](const Figure &figure) { return homeView({}, figure, false, {800, 600}, 1); };
  const Camera alone = homeOf({{given}});
  EXPECT_EQ(homeOf({{given, worked}}), alone);
  worked.at = {5, 5, 18};
  EXPECT_GT(homeOf({{given, worked}}).height, alone.height);
  worked.at = {5, 5, 150};
  worked.role = Role::Given;
  EXPECT_GT(homeOf({{given, worked}}).height, 2 * alone.height) << "objects are always in view";
}

TEST(Fitted, BesideWhatCoversTheView_HasNoPlaceUnderIt) {
  const Figure figure = figureOf(evaluate(library().find("signed-distance")->scene));
  const std::vector<Place> places = placesOf(figure);
  View view{Camera(library().find("signed-distance")->camera), {840, 725}, 1};
  const Camera alone = fitted(view, places);
  view.covered = {{{0, 500}, {420, 725}}, {{300, 0}, {840, 150}}};
  const Camera beside = fitted(view, places);
  const auto isCovered = [&](const Camera &camera) {
    return std::any_of(places.begin(), places.end(), [&](const Place &place) {
      const glm::dvec2 pixel(camera.project(place, view.size).value());
      return std::any_of(view.covered.begin(), view.covered.end(),
                         [&](const PixelBox &box) { return distanceTo(box, pixel) == 0; });
    });
  };
  EXPECT_TRUE(isCovered(alone));
  EXPECT_FALSE(isCovered(beside));
  view.covered = {{{0, 720}, {5, 725}}};
  EXPECT_EQ(fitted(view, places), alone) << "what nothing lies under takes no room";
}

TEST(FirstCourse, OfAFigure_IsTheFirstThatHasADirection) {
  Scene scene = library().find("ray-plane-dot")->scene;
  const Course course = firstCourse(figureOf(evaluate(scene))).value();
  EXPECT_EQ(course.start, toDouble(coordinate(*findObject(scene, "L"), 0)));
  const Place direction = glm::normalize(toDouble(coordinate(*findObject(scene, "L"), 1)));
  EXPECT_GT(glm::dot(course.direction, direction), 0.999999);
  setObject(scene, "L", RayObject{coordinate(*findObject(scene, "L"), 0), ExactVec3(0)});
  EXPECT_FALSE(firstCourse(figureOf(evaluate(scene))));
  EXPECT_FALSE(firstCourse(figureOf(evaluate(library().find("signed-distance")->scene))));
}

struct CourseOfALesson : testing::TestWithParam<std::string> {};

/// One that is worked out as well.
TEST_P(CourseOfALesson, IsSeenFromBothEnds) {
  const Figure figure = figureOf(evaluate(library().find(GetParam())->scene));
  const Place direction = firstCourse(figure).value().direction;
  const Camera down = seenAlongCourse(AlongCourse::Down, figure, Camera());
  EXPECT_GT(glm::dot(down.viewDirection(), glm::normalize(direction)), 0.999999);
  const Camera against = seenAlongCourse(AlongCourse::Against, figure, Camera());
  EXPECT_LT(glm::dot(against.viewDirection(), glm::normalize(direction)), -0.999999);
}

INSTANTIATE_TEST_SUITE_P(Lessons, CourseOfALesson, testing::Values("photon-torpedo", "pluecker-lines"),
                         test::testName);

} // namespace
} // namespace halfspace
