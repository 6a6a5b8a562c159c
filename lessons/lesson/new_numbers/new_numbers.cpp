#include "lessons/lesson/new_numbers/new_numbers.h"

#include "lessons/lesson/new_numbers/short_numbers.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/vector.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfspace {
namespace {

/// How well a scene is to be seen.
struct Sight {
  glm::dvec3 from;     ///< a unit vector
  double leastOpening; ///< the sine of the angle below which what is flat counts as seen edge-on
  double leastLength;  ///< the sine of the angle below which a line counts as seen end-on
  double leastArea;    ///< of a face as it is seen, in square units of the scene, where axes are some 12 long
  double leastReach; ///< between the farthest of corners on one line as they are seen, in units of the scene
};

/// What is aimed at, and what is put up with where chance gives nothing better: about 17 and 9 degrees.
Sight goodSight(const glm::dvec3 &from) { return {from, 0.3, 0.3, 6, 4}; }
Sight poorSight(const glm::dvec3 &from) { return {from, 0.15, 0, 0, 2}; }

/// Of the scenes of so many seeds the first is taken in which the question has an answer.
constexpr std::uint64_t scenesForAQuestion = 12;

/// The corners of a flat face; none for other objects.
std::vector<ExactVec3> cornersOf(const Object &object) {
  if (const auto triangle = objectAs<TriangleObject>(object))
    return {triangle->p0, triangle->p1, triangle->p2};
  if (const auto polygon = objectAs<PolygonObject>(object))
    return polygon->corners;
  return {};
}

/// Whether what is square to `normal` is not seen edge-on; anything where there is no normal.
bool isOpen(const glm::dvec3 &normal, const Sight &sight) {
  return normal == glm::dvec3(0) ||
         std::abs(glm::dot(normal, sight.from)) >= sight.leastOpening * glm::length(normal);
}

/// Whether a line is not seen end-on.
bool isLong(const glm::dvec3 &direction, const Sight &sight) {
  return glm::length(glm::cross(direction, sight.from)) >= sight.leastLength * glm::length(direction);
}

bool isSeenWell(const Object &object, const Sight &sight) {
  if (const auto plane = objectAs<PlaneObject>(object))
    return isOpen(toDouble(plane->normal), sight);
  if (const auto ray = objectAs<RayObject>(object))
    return isLong(toDouble(ray->direction), sight);
  if (const auto line = objectAs<LineObject>(object))
    return isLong(toDouble(line->direction), sight);
  if (const auto vector = objectAs<VectorObject>(object))
    return isLong(toDouble(vector->vector), sight);
  const std::vector<ExactVec3> corners = cornersOf(object);
  if (corners.empty())
    return true;
  const glm::dvec3 area = toDouble(areaOf(corners)) / 2.0;
  if (area == glm::dvec3(0)) // it has no face, but the line of its corners
    return std::any_of(corners.begin(), corners.end(), [&](const ExactVec3 &corner) {
      const glm::dvec3 way = toDouble(ExactVec3(corner - corners.front()));
      return glm::length(glm::cross(way, sight.from)) >= sight.leastReach;
    });
  return isOpen(area, sight) && std::abs(glm::dot(area, sight.from)) >= sight.leastArea;
}

bool isSeenWell(const Scene &scene, const Sight &sight) {
  return std::all_of(scene.entries.begin(), scene.entries.end(), [&](const Entry &entry) {
    const auto *object = std::get_if<Object>(&entry.content);
    return !object || isSeenWell(*object, sight);
  });
}

/// The scene with other short numbers that is seen as well as chance allows.
Scene renewed(const Scene &scene, std::uint64_t seed, const glm::dvec3 &from, bool keepCase) {
  for (const Sight &sight : {goodSight(from), poorSight(from)}) {
    const WantedNumbers wanted{keepCase, [&](const Scene &each) { return isSeenWell(each, sight); }};
    if (Scene found = withShortNumbers(scene, seed, wanted); !(found == scene))
      return found;
  }
  return withShortNumbers(scene, seed, {keepCase, {}});
}

} // namespace

Scene withNumbersOf(const Scene &other, Scene scene) {
  const Scene before = scene;
  for (const Entry &entry : before.entries)
    if (const auto *object = std::get_if<Object>(&entry.content))
      if (const Object *same = findObject(other, entry.name);
          same && kindOf(*same) == kindOf(*object) && same->size() == object->size())
        setObject(scene, entry.name, *same);
  return scene;
}

Scene withNewNumbers(const Scene &scene, const LessonStep &step, const glm::dvec3 &from, std::uint64_t seed) {
  const Prediction *question = predictionOf(step);
  const glm::dvec3 unit = glm::normalize(from);
  if (!question)
    return renewed(scene, seed, unit, true);
  for (std::uint64_t i = 0; i < scenesForAQuestion; ++i)
    if (Scene other = renewed(scene, seed + i, unit, false); !rightChoice(*question, evaluate(other)).empty())
      return other;
  return withShortNumbers(scene, seed);
}

} // namespace halfspace
