#include "lessons/discovery/moved_scene.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"

#include <algorithm>
#include <array>
#include <set>

namespace halfspace {
namespace {

/// A coordinate is moved by so many steps at most, up or down: so many different places are tried, of which
/// an equation of a low degree holds at few.
constexpr int mostSteps = 100;
/// Short, so that what follows has no long numbers, and small, so that what is hit is mostly hit again.
const Rational nearStep(1, 32);
constexpr int farStep = 1;
/// A number goes from one bound to the other in so many steps: a prime, so that it seldom is a round one.
constexpr int stepsBetweenBounds = 97;

} // namespace

Scene sceneBehind(const Scene &scene, const std::vector<std::string> &ids) {
  std::set<std::string> wanted;
  for (const std::string &id : ids)
    wanted.insert(ownerOf(id));
  std::vector<NamedList<Entry>::Shared> found; // from below: each is wanted by those that were found
  for (std::size_t place = scene.entries.size(); place-- > 0;)
    if (const Entry &entry = scene.entries[place]; wanted.contains(entry.name)) {
      found.push_back(scene.entries.shared(place));
      for (const std::string &id : referencesIn(entry))
        wanted.insert(ownerOf(id));
    }
  std::reverse(found.begin(), found.end());
  Scene behind;
  for (const auto &entry : found)
    behind.entries.push_back(entry);
  return behind;
}

Scene SceneMover::moved(Scene scene, bool isNearby) {
  for (std::size_t place = 0; place < scene.entries.size(); ++place)
    if (const auto *object = std::get_if<Object>(&scene.entries[place].content); object && !object->shape())
      scene.entries.change(place, [&](Entry &entry) { entry.content = moved(*object, isNearby); });
  return scene;
}

Object SceneMover::moved(Object object, bool isNearby) {
  if (auto number = objectAs<NumberObject>(object)) {
    const Rational share(static_cast<int>(m_engine() % (stepsBetweenBounds - 1)) + 1,
                         stepsBetweenBounds); // not at a bound, where something may be special
    number->value = number->from + (number->to - number->from) * share;
    return *number;
  }
  if (object.kind().leavableVertices > 0) {
    moveWhole(object, isNearby);
    return object;
  }
  const auto specs = coordinatesOf(object);
  for (std::size_t i = 0; i < specs.size(); ++i)
    if (numbersIn(specs[i].role) == 1)
      object[i].x = number(object[i].x, isNearby);
    else
      object[i] = vector(object[i], isNearby);
  // A bound point may go on beyond its host: what holds along all of a line holds on a part of it, and a
  // corner to which it would be brought back is a special place.
  if (!object.kind().binding)
    object.kind().settle(object);
  return object;
}

/// What has a face of many corners is turned, sheared and moved as a whole, so that the face stays flat.
void SceneMover::moveWhole(Object &object, bool isNearby) {
  std::array<ExactVec3, 3> axes{};
  for (int axis = 0; axis < 3; ++axis) {
    ExactVec3 unit(0);
    unit[axis] = 1;
    axes.at(static_cast<std::size_t>(axis)) = vector(unit, isNearby);
  }
  const ExactVec3 shift = vector(ExactVec3(0), isNearby);
  const auto specs = coordinatesOf(object);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const ExactVec3 from = object[i];
    const ExactVec3 turned = axes[0] * from.x + axes[1] * from.y + axes[2] * from.z;
    object[i] = specs[i].role == CoordinateRole::Position ? turned + shift : turned;
  }
}

Rational SceneMover::number(const Rational &from, bool isNearby) {
  const int steps = static_cast<int>(m_engine() % (2 * mostSteps + 1)) - mostSteps;
  return from + (isNearby ? nearStep : Rational(farStep)) * steps;
}

ExactVec3 SceneMover::vector(const ExactVec3 &from, bool isNearby) {
  ExactVec3 to(0);
  for (int axis = 0; axis < 3; ++axis)
    to[axis] = number(from[axis], isNearby);
  return to;
}

} // namespace halfspace
