// The way to a special case that keeps the numbers short.
#include "lessons/lesson/short_move.h"

#include "lessons/lesson/lesson.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

NearSpecialCase nearIn(const Scene &scene, const std::string &entry, const Conditions &when) {
  for (const NearSpecialCase &near : specialCasesNear(scene, evaluate(scene), {entry}))
    if (near.when == when && near.change)
      return near;
  ADD_FAILURE() << when.front().value << " is not near";
  return {};
}

TEST(ShortMove, WhereTheLeastHasFractions_LeadsToTheGrid) {
  const Scene scene = distanceScene();
  const NearSpecialCase near = nearIn(scene, "distance", is("side", "on"));
  ASSERT_EQ(near.change->value[0].x.denominator(), 3);
  const ChangeObject change = shortMoveTo(near, scene, 1);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(change.value[0][axis].denominator(), 1);
  EXPECT_EQ(dot(ExactVec3(1, 2, 2), change.value[0] - ExactVec3(5, 4, 7)), 0);
}

TEST(ShortMove, WhereTheGridHasNone_GoesAlongAnAxis) {
  Scene scene = distanceScene();
  setCoordinate(scene, {"E", 0}, {q(1, 2), q(1, 3), q(1, 5)}); // no whole numbers lie in the plane
  const NearSpecialCase near = nearIn(scene, "distance", is("side", "on"));
  const ChangeObject change = shortMoveTo(near, scene, 1);
  const ExactVec3 way = change.value[0] - findObject(scene, "Q")->operator[](0);
  EXPECT_EQ((way.x != 0) + (way.y != 0) + (way.z != 0), 1);
  EXPECT_EQ(dot(ExactVec3(1, 2, 2), change.value[0] - ExactVec3(q(1, 2), q(1, 3), q(1, 5))), 0);
}

/// Whatever is near in any lesson, the case is that one there.
TEST(ShortMove, OfEveryLesson_LeadsThere) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    std::set<std::string> entries;
    for (const Entry &entry : lesson.scene.entries)
      entries.insert(entry.name);
    for (const NearSpecialCase &near : specialCasesNear(lesson.scene, evaluate(lesson.scene), entries)) {
      if (!near.change)
        continue;
      const ChangeObject change = shortMoveTo(near, lesson.scene, 1);
      const Scene there = edited(lesson.scene, {change});
      for (const NearSpecialCase &still : specialCasesNear(there, evaluate(there), {near.entry}))
        EXPECT_FALSE(still.when == near.when && still.sentence == near.sentence)
            << lesson.id << ": " << near.sentence;
    }
  }
}

} // namespace
} // namespace halfspace
