// In the scenes of all lessons objects are told apart by their colours, and without colours by their dashes.
#include "lessons/lesson/lesson.h"
#include "widgets/picture/shapes/ball_sizes.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

/// Planes, rays, lines and vectors: what is drawn in lines and called by its colour.
bool isInLines(const Mark &mark) {
  return std::holds_alternative<PlanePatchMark>(mark) || std::holds_alternative<RayMark>(mark) ||
         std::holds_alternative<LineMark>(mark) || std::holds_alternative<ArrowMark>(mark);
}

/// The marks of a kind that are given and have a name, one of each object of the scene.
std::vector<MarkBase> givenOf(std::size_t kind, const Figure &figure, const Scene &scene) {
  std::map<std::string, MarkBase> byObject;
  for (const Mark &mark : figure.marks)
    if (const MarkBase &base = baseOf(mark); mark.index() == kind && isInLines(mark) && !base.label.empty())
      if (const std::string owner = ownerOf(base.id); findObject(scene, owner))
        byObject.emplace(owner, base);
  std::vector<MarkBase> given;
  for (const auto &[owner, base] : byObject)
    given.push_back(base);
  return given;
}

/// Looks at any two given marks of one kind, of two objects, in every lesson.
template <class LookAtTwo> void forAnyTwo(const LookAtTwo &look) {
  int looks = 0;
  for (const Lesson &lesson : library().lessons) {
    SCOPED_TRACE(lesson.id);
    const Figure figure = figureOf(evaluate(lesson.scene));
    for (std::size_t kind = 0; kind < std::variant_size_v<Mark>; ++kind) {
      const std::vector<MarkBase> given = givenOf(kind, figure, lesson.scene);
      for (std::size_t i = 0; i < given.size(); ++i)
        for (std::size_t j = i + 1; j < given.size(); ++j, ++looks)
          look(given[i], given[j]);
    }
  }
  EXPECT_GT(looks, 10) << "lessons have several objects of a kind";
}

TEST(LessonLooks, OfTwoOfAKind_DifferInColour) {
  forAnyTwo([](const MarkBase &one, const MarkBase &other) {
    for (const Theme &theme : themes())
      EXPECT_NE(solidColor(one, theme, false), solidColor(other, theme, false))
          << theme.name << ": " << one.id << ", " << other.id;
  });
}

TEST(LessonLooks, OfTwoAboutTheSame_DifferInGrey) {
  forAnyTwo([](const MarkBase &one, const MarkBase &other) {
    if (one.subject == other.subject) {
      EXPECT_NE(rhythmOf(one, 1), rhythmOf(other, 1)) << one.id << ", " << other.id;
    }
  });
}

TEST(LessonLooks, TheTorpedo_IsThickerThanTheHeadOfItsArrow) {
  Scene scene = library().find("photon-torpedo")->scene;
  for (const int frame : {10, 40}) {
    SCOPED_TRACE(frame);
    Object moment = *findObject(scene, "frame");
    moment[0].x = frame;
    setObject(scene, "frame", moment);
    const Figure figure = figureOf(evaluate(scene));
    const auto *torpedo = std::get_if<PointMark>(findMark(figure, "flight.M"));
    const auto *arrow = std::get_if<ArrowMark>(findMark(figure, "shot.L.r"));
    ASSERT_TRUE(torpedo && arrow);
    for (const Theme &theme : themes()) {
      const ArrowHead head =
          headOfArrow(glm::length(arrow->vector), arrowRadius * thicknessOf(*arrow, theme, 1));
      EXPECT_GT(ballRadius(*torpedo) * thicknessOf(*torpedo, theme, 1), head.radius) << theme.name;
    }
  }
}

TEST(LessonLooks, TheSaucer_IsSeenBehindItsHandle_InLargeType) {
  const Figure figure = figureOf(evaluate(library().find("photon-torpedo")->scene));
  const auto *handle = std::get_if<PointMark>(findMark(figure, "U.S"));
  const auto *dome = std::get_if<PolygonMark>(findMark(figure, "shot.saucer"));
  ASSERT_TRUE(handle && dome);
  double reach = 0;
  for (const Place &corner : dome->corners)
    reach = std::max(reach, glm::distance(corner, handle->at));
  for (const double scale : {1.0, 1.5, 2.0, 4.0})
    EXPECT_LT(BallSizes(figure).radiusOf(*handle, scale), reach / 3) << scale;
}

} // namespace
} // namespace halfspace
