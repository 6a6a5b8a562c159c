// New numbers for a step: a repeated question may have another answer, and planes are seen as planes.
#include "lessons/lesson/new_numbers/new_numbers.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

/// The first step of a lesson that asks a question, or none.
const LessonStep &stepOf(const Lesson &lesson, bool asks) {
  return *std::find_if(lesson.steps.begin(), lesson.steps.end(),
                       [&](const LessonStep &step) { return (predictionOf(step) != nullptr) == asks; });
}

std::string caseOf(const Scene &scene) { return evaluate(scene).lastConstruction()->outcome->told->name; }

TEST(NewNumbers, whereTheStepAsks_varyTheAnswer) {
  for (const char *id : {"signed-distance", "ray-plane-dot", "ray-triangle-perp"}) {
    const Lesson &lesson = *library().find(id);
    const LessonStep &step = stepOf(lesson, true);
    std::set<std::string> answers;
    for (std::uint64_t seed = 0; seed < 12; ++seed)
      answers.insert(rightChoice(*predictionOf(step),
                                 evaluate(withNewNumbers(lesson.scene, step, lesson.camera.from, seed))));
    EXPECT_GT(answers.size(), 1U) << id;
    EXPECT_FALSE(answers.contains("")) << id;
  }
}

TEST(NewNumbers, whereTheStepAsksNothing_keepTheCase) {
  const Lesson &lesson = *library().find("signed-distance");
  const LessonStep &step = stepOf(lesson, false);
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    EXPECT_EQ(caseOf(withNewNumbers(lesson.scene, step, lesson.camera.from, seed)), caseOf(lesson.scene));
}

TEST(NewNumbers, ofCornersOnALine_areMostOftenOnALineToo) {
  const Lesson &lesson = *library().find("triangle-degenerate");
  for (const bool asks : {true, false}) {
    std::map<std::string, int> cases;
    for (std::uint64_t seed = 0; seed < 24; ++seed)
      ++cases[caseOf(withNewNumbers(lesson.scene, stepOf(lesson, asks), lesson.camera.from, seed))];
    EXPECT_GT(cases["collinear"], cases["proper"]);
    EXPECT_EQ(cases["proper"] == 0, asks) << "a question is about them; elsewhere every result would be 0";
    EXPECT_EQ(cases["collinear"] + cases["proper"], 24) << "each corner has a place of its own";
  }
}

TEST(NumbersOf, anotherScene_areThoseOfObjectsThatAreBuiltAlike) {
  const Scene lesson = library().find("ray-plane-dot")->scene;
  Scene changed = lesson;
  test::setCoordinate(changed, {"L", 1}, ExactVec3(0));
  changed.entries.push_back({"A", PointObject{{1, 2, 3}}});
  const Scene renewed = withNumbersOf(lesson, changed);
  EXPECT_EQ(*findObject(renewed, "L"), *findObject(lesson, "L"));
  EXPECT_EQ(*findObject(renewed, "A"), Object(PointObject{{1, 2, 3}}));
}

TEST(NewNumbers, planes_areNotSeenEdgeOn) {
  const Lesson &lesson = *library().find("signed-distance");
  const glm::dvec3 from = glm::normalize(lesson.camera.from);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scene renewed = withNewNumbers(lesson.scene, stepOf(lesson, false), from, seed);
    const glm::dvec3 normal =
        glm::normalize(toDouble(objectAs<PlaneObject>(*findObject(renewed, "E"))->normal));
    EXPECT_GT(std::abs(glm::dot(normal, from)), 0.15);
  }
}

TEST(NewNumbers, raysAndTriangles_areSeenAtAGoodSize) {
  const Lesson &lesson = *library().find("three-methods");
  const glm::dvec3 from = glm::normalize(lesson.camera.from);
  for (const bool asks : {false, true})
    for (int seed = 0; seed < test::effort(20); ++seed) {
      const Scene renewed = withNewNumbers(lesson.scene, stepOf(lesson, asks), lesson.camera.from,
                                           static_cast<std::uint64_t>(seed));
      const auto triangle = *objectAs<TriangleObject>(*findObject(renewed, "T"));
      const glm::dvec3 twiceArea = toDouble(areaOf({triangle.p0, triangle.p1, triangle.p2}));
      EXPECT_GE(std::abs(glm::dot(twiceArea, from)) / 2, 6) << seed;
      EXPECT_GE(std::abs(glm::dot(glm::normalize(twiceArea), from)), 0.3) << seed;
      const glm::dvec3 direction = toDouble(objectAs<RayObject>(*findObject(renewed, "L"))->direction);
      EXPECT_GE(glm::length(glm::cross(glm::normalize(direction), from)), 0.3) << seed;
    }
}

/// A button that does nothing looks broken.
TEST(NewNumbers, inEveryLesson_areOthers) {
  for (const Lesson &lesson : test::fewer(library().lessons))
    for (const bool asks : {false, true}) {
      const auto step = std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const LessonStep &each) {
        return (predictionOf(each) != nullptr) == asks;
      });
      for (int seed = 0; step != lesson.steps.end() && seed < test::effort(6); ++seed)
        for (const glm::dvec3 &from : {lesson.camera.from, glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)})
          EXPECT_FALSE(withNewNumbers(lesson.scene, *step, from, static_cast<std::uint64_t>(seed)) ==
                       lesson.scene)
              << lesson.id << ", " << step->title << ", " << seed;
    }
}

} // namespace
} // namespace halfspace
