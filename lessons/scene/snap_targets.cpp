#include "lessons/scene/snap_targets.h"

#include "lessons/scene/scene_letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

struct NamedPoint {
  ExactVec3 at;
  std::string name; ///< “vertex P₁”
};

struct NamedEdge {
  ExactVec3 from;
  ExactVec3 to;
  std::string name; ///< “edge P₀P₁”
};

struct NamedPlane {
  ExactVec3 point;
  ExactVec3 normal;
  std::string name; ///< “E”
};

/// What the other objects of a scene have that a handle can snap to.
struct Surroundings {
  std::vector<NamedPoint> points;
  std::vector<NamedEdge> edges;
  std::vector<NamedPlane> planes;
};

/// Looks an object over and adds what it has.
class Surveyor {
public:
  Surveyor(const Given<Object> &given, Surroundings &found) : m_given(given), m_found(found) {}

  void operator()(const PointObject &point) const {
    m_found.points.push_back({point.at, words("point {name}", {{"name", nameOf(0)}})});
  }
  void operator()(const PlaneObject &plane) const {
    if (!isZero(plane.normal))
      m_found.planes.push_back({plane.point, plane.normal, plainText(m_given.symbol)});
  }
  void operator()(const RayObject &ray) const {
    m_found.points.push_back({ray.origin, words("start {name}", {{"name", nameOf(0)}})});
  }
  void operator()(const TriangleObject &triangle) const {
    const std::array corners{&triangle.p0, &triangle.p1, &triangle.p2};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      m_found.points.push_back({*corners[i], words("vertex {name}", {{"name", nameOf(i)}})});
      if (*corners[i] != *corners[next])
        m_found.edges.push_back(
            {*corners[i], *corners[next],
             words("edge {name}", {{"name", nameOf(std::min(i, next)) + nameOf(std::max(i, next))}})});
    }
    const ExactVec3 normal = cross(triangle.p1 - triangle.p0, triangle.p2 - triangle.p0);
    if (!isZero(normal))
      m_found.planes.push_back({triangle.p0, normal, plainText(m_given.symbol)});
  }

private:
  /// The letter of one of the object's coordinates.
  [[nodiscard]] std::string nameOf(std::size_t index) const { return plainText(m_given.letters[index]); }

  const Given<Object> &m_given;
  Surroundings &m_found;
};

Surroundings surroundingsOf(const Scene &scene, const std::string &handled) {
  const SceneLetters letters(scene);
  Surroundings found;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && entry.name != handled) {
      const Given<Object> given = letters.given(entry.name, *object);
      std::visit(Surveyor(given, found), *object);
    }
  return found;
}

bool isBetween(const ExactVec3 &place, const NamedEdge &edge) {
  const ExactVec3 whole = edge.to - edge.from;
  const Rational along = dot(place - edge.from, whole);
  return along >= 0 && along <= dot(whole, whole);
}

void addPositionTargets(const Surroundings &found, std::vector<SnapTarget> &targets) {
  for (const NamedPoint &point : found.points)
    targets.push_back({Flat::point(point.at), point.name, {}});
  for (const NamedEdge &edge : found.edges)
    targets.push_back({Flat::line(edge.from, edge.to - edge.from), edge.name,
                       [edge](const ExactVec3 &place) { return isBetween(place, edge); }});
  for (const NamedPlane &plane : found.planes)
    targets.push_back(
        {Flat::plane(plane.point, plane.normal), words("plane {name}", {{"name", plane.name}}), {}});
}

/// A corner in line with the two others of its triangle: the degenerate case that a learner is asked to find.
void addCollinearTarget(const Given<Object> &given, const Handle &handle, std::vector<SnapTarget> &targets) {
  const Object &object = given.object;
  if (!std::holds_alternative<TriangleObject>(object))
    return;
  const std::size_t first = handle.coordinate == 0 ? 1 : 0;
  const std::size_t second = handle.coordinate == 2 ? 1 : 2;
  const ExactVec3 &from = coordinate(object, first);
  const ExactVec3 &to = coordinate(object, second);
  const auto name = [&](std::size_t index) { return plainText(given.letters[index]); };
  if (from != to)
    targets.push_back(
        {Flat::line(from, to - from),
         words("in line with {first} and {second}", {{"first", name(first)}, {"second", name(second)}}),
         {}});
}

void addAxisTargets(const ExactVec3 &base, std::vector<SnapTarget> &targets) {
  for (int axis = 0; axis < 3; ++axis) {
    ExactVec3 direction(0);
    direction[axis] = 1;
    targets.push_back({Flat::line(base, direction), words("axis-parallel"),
                       [base](const ExactVec3 &place) { return place != base; }});
  }
}

/// Whether the line from `base` in the direction of `place` crosses the edge between its ends. All lie in one
/// plane.
bool crossesEdge(const ExactVec3 &base, const ExactVec3 &place, const NamedEdge &edge) {
  const ExactVec3 toFrom = edge.from - base;
  const ExactVec3 toTo = edge.to - base;
  const ExactVec3 direction = place - base;
  // The ends lie on different sides of the line: their cross products with its direction point apart.
  return !isZero(direction) && dot(cross(direction, toFrom), cross(direction, toTo)) <= 0;
}

void addDirectionTargets(const Surroundings &found, const ExactVec3 &base, std::vector<SnapTarget> &targets) {
  const auto pointsSomewhere = [base](const ExactVec3 &place) { return place != base; };
  for (const NamedPoint &point : found.points)
    if (point.at != base)
      targets.push_back({Flat::line(base, point.at - base), words("through {name}", {{"name", point.name}}),
                         pointsSomewhere});
  addAxisTargets(base, targets);
  for (const NamedEdge &edge : found.edges) {
    const ExactVec3 normal = cross(edge.from - base, edge.to - base);
    if (!isZero(normal))
      targets.push_back({Flat::plane(base, normal), words("through {name}", {{"name", edge.name}}),
                         [base, edge](const ExactVec3 &place) { return crossesEdge(base, place, edge); }});
  }
  for (const NamedPlane &plane : found.planes) {
    const bool startsInIt = dot(plane.normal, base - plane.point) == 0;
    targets.push_back({Flat::plane(base, plane.normal),
                       startsInIt ? words("in the plane {name}", {{"name", plane.name}})
                                  : words("parallel to {name}", {{"name", plane.name}}),
                       pointsSomewhere});
  }
}

void addOffsetTargets(const Surroundings &found, const ExactVec3 &normal, std::vector<SnapTarget> &targets) {
  for (const NamedPoint &point : found.points)
    targets.push_back({Flat::plane(point.at, normal), words("through {name}", {{"name", point.name}}), {}});
}

} // namespace

std::vector<SnapTarget> snapTargets(const Scene &scene, const Handle &handle) {
  const Object *object = findObject(scene, handle.object);
  std::vector<SnapTarget> targets;
  if (!object || handle.motion == Handle::Motion::Whole)
    return targets;
  const Surroundings found = surroundingsOf(scene, handle.object);
  if (handle.motion == Handle::Motion::AlongNormal) {
    addOffsetTargets(found, handle.axis, targets);
    return targets;
  }
  if (coordinatesOf(*object).at(handle.coordinate).role == CoordinateRole::Position) {
    addPositionTargets(found, targets);
    addCollinearTarget(SceneLetters(scene).given(handle.object, *object), handle, targets);
  } else if (std::holds_alternative<RayObject>(*object)) {
    addDirectionTargets(found, handle.base, targets);
  } else {
    addAxisTargets(handle.base, targets);
  }
  return targets;
}

} // namespace halfspace
