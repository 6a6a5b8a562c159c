// Where the camera stands at home, and which ray it can look down.
#include "widgets/picture/camera_views.h"

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"
#include "widgets/picture/shapes/ground.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

TEST(HomeView, OfEveryLesson_ShowsFigureAndAxesWithRoomForLabels) {
  constexpr double room = 29; // pixels
  for (const Lesson &lesson : library().lessons)
    for (const PixelSize size : {PixelSize{880, 440}, PixelSize{700, 300}, PixelSize{1600, 1000}}) {
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

TEST(FirstRay, WithoutADirection_IsNotFound) {
  Scene scene = library().find("ray-plane-dot")->scene;
  EXPECT_TRUE(firstRay(scene));
  coordinate(*findObject(scene, "L"), 1) = ExactVec3(0);
  EXPECT_FALSE(firstRay(scene));
  EXPECT_FALSE(firstRay(library().find("signed-distance")->scene));
}

} // namespace
} // namespace halfspace
