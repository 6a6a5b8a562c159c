#include "lessons/lesson/new_numbers.h"

#include "lessons/object/plane.h"
#include "lessons/object/polygon.h"
#include "lessons/object/triangle.h"
#include "lessons/scene/short_numbers.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <iterator>
#include <map>

namespace halfspace {
namespace {

/// The sine of the angle below which a plane counts as seen edge-on: about 9 degrees.
constexpr double leastOpening = 0.15;

/// Of the scenes of so many seeds one is chosen for its answer.
constexpr std::uint64_t scenesForAQuestion = 12;

/// Square to what is flat; nothing for other objects.
std::optional<ExactVec3> normalOf(const Object &object) {
  if (const auto plane = objectAs<PlaneObject>(object))
    return plane->normal;
  if (const auto triangle = objectAs<TriangleObject>(object))
    return cross(triangle->p1 - triangle->p0, triangle->p2 - triangle->p0);
  if (const auto polygon = objectAs<PolygonObject>(object))
    return cross(polygon->corners[1] - polygon->corners[0], polygon->corners[2] - polygon->corners[0]);
  return {};
}

bool isEdgeOn(const Object &object, const glm::dvec3 &from) {
  const auto normal = normalOf(object);
  if (!normal || isZero(*normal))
    return false;
  const glm::dvec3 n = toDouble(*normal);
  return std::abs(glm::dot(n, from)) < leastOpening * glm::length(n) * glm::length(from);
}

bool showsItsFaces(const Scene &scene, const glm::dvec3 &from) {
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && isEdgeOn(*object, from))
      return false;
  return true;
}

} // namespace

Scene withNewNumbers(const Scene &scene, const LessonStep &step, const glm::dvec3 &from, std::uint64_t seed) {
  const Prediction *question = predictionOf(step);
  const WantedNumbers wanted{!question, [&](const Scene &each) { return showsItsFaces(each, from); }};
  if (!question)
    return withShortNumbers(scene, seed, wanted);
  std::map<std::string, Scene> byAnswer;
  for (std::uint64_t i = 0; i < scenesForAQuestion; ++i) {
    Scene renewed = withShortNumbers(scene, seed + i, wanted);
    std::string answer = rightChoice(*question, evaluate(renewed));
    if (!answer.empty())
      byAnswer.emplace(std::move(answer), std::move(renewed));
  }
  if (byAnswer.empty())
    return withShortNumbers(scene, seed);
  return std::next(byAnswer.begin(), static_cast<std::ptrdiff_t>(seed % byAnswer.size()))->second;
}

} // namespace halfspace
