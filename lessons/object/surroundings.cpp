#include "lessons/object/surroundings.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

bool isBetween(const ExactVec3 &place, const NamedEdge &edge) {
  const ExactVec3 whole = edge.to - edge.from;
  const Rational along = dot(place - edge.from, whole);
  return along >= 0 && along <= dot(whole, whole);
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

/// Negative where the line of the arrow from `start` passes by a sphere, 0 where it touches it.
Rational discriminant(const ExactVec3 &start, const ExactVec3 &arrow, const NamedSphere &sphere) {
  const ExactVec3 way = start - sphere.center;
  const Rational along = dot(arrow, way);
  return along * along - dot(arrow, arrow) * (dot(way, way) - sphere.radius * sphere.radius);
}

std::string touching(const NamedSphere &sphere) { return words("touching {name}", {{"name", sphere.name}}); }

std::string through(const std::string &name) { return words("through {name}", {{"name", name}}); }

} // namespace

void aimAtPlaces(const Surroundings &found, std::vector<SnapTarget> &targets) {
  for (const NamedPoint &point : found.points)
    targets.push_back({Flat::point(point.at), point.name, {}});
  for (const NamedEdge &edge : found.edges)
    targets.push_back({Flat::line(edge.from, edge.to - edge.from), edge.name,
                       [edge](const ExactVec3 &place) { return isBetween(place, edge); }});
  for (const NamedLine &line : found.lines)
    targets.push_back({Flat::line(line.through, line.direction), line.name, {}});
  for (const NamedPlane &plane : found.planes)
    targets.push_back(
        {Flat::plane(plane.point, plane.normal), words("plane {name}", {{"name", plane.name}}), {}});
  targets.push_back({Flat::point(found.origin), words("the origin"), {}});
}

void aimAlongAxes(const ExactVec3 &base, std::vector<SnapTarget> &targets) {
  for (int axis = 0; axis < 3; ++axis) {
    ExactVec3 direction(0);
    direction[axis] = 1;
    targets.push_back({Flat::line(base, direction), words("axis-parallel"),
                       [base](const ExactVec3 &place) { return place != base; }});
  }
}

void aimAtSurroundings(const Surroundings &found, const ExactVec3 &base, std::vector<SnapTarget> &targets) {
  const auto pointsSomewhere = [base](const ExactVec3 &place) { return place != base; };
  for (const NamedPoint &point : found.points)
    if (point.at != base)
      targets.push_back({Flat::line(base, point.at - base), through(point.name), pointsSomewhere});
  aimAlongAxes(base, targets);
  for (const NamedEdge &edge : found.edges) {
    const ExactVec3 normal = cross(edge.from - base, edge.to - base);
    if (!isZero(normal))
      targets.push_back({Flat::plane(base, normal), through(edge.name),
                         [base, edge](const ExactVec3 &place) { return crossesEdge(base, place, edge); }});
  }
  for (const NamedPlane &plane : found.planes) {
    const bool startsInIt = dot(plane.normal, base - plane.point) == 0;
    targets.push_back({Flat::plane(base, plane.normal),
                       startsInIt ? words("in the plane {name}", {{"name", plane.name}})
                                  : words("parallel to {name}", {{"name", plane.name}}),
                       pointsSomewhere});
    if (!startsInIt)
      targets.push_back(
          {Flat::plane(plane.point, plane.normal), words("the tip on {name}", {{"name", plane.name}}), {}});
  }
  for (const NamedSphere &sphere : found.spheres) {
    const ExactVec3 outwards = base - sphere.center;
    if (dot(outwards, outwards) == sphere.radius * sphere.radius) // all that touch it there lie in one plane
      targets.push_back({Flat::plane(base, outwards), touching(sphere), pointsSomewhere});
    else if (auto cone = Quadric::of(
                 [&](const ExactVec3 &place) { return discriminant(base, place - base, sphere); }))
      targets.push_back({{}, touching(sphere), pointsSomewhere, std::move(cone)});
  }
}

void aimFromStart(const Surroundings &found, const ExactVec3 &arrow, std::vector<SnapTarget> &targets) {
  for (const NamedPoint &point : found.points)
    targets.push_back({Flat::line(point.at, arrow), through(point.name), {}});
  for (const NamedEdge &edge : found.edges) {
    const ExactVec3 normal = cross(edge.to - edge.from, arrow);
    if (!isZero(normal))
      targets.push_back(
          {Flat::plane(edge.from, normal), through(edge.name),
           [arrow, edge](const ExactVec3 &start) { return crossesEdge(start, start + arrow, edge); }});
  }
  for (const NamedSphere &sphere : found.spheres)
    if (auto cylinder =
            Quadric::of([&](const ExactVec3 &place) { return discriminant(place, arrow, sphere); }))
      targets.push_back({{}, touching(sphere), {}, std::move(cylinder)});
}

void aimNormal(const Surroundings &found, const ExactVec3 &base, std::vector<SnapTarget> &targets) {
  const auto pointsSomewhere = [base](const ExactVec3 &place) { return place != base; };
  for (const NamedPlane &plane : found.planes) {
    targets.push_back({Flat::line(base, plane.normal), words("parallel to {name}", {{"name", plane.name}}),
                       pointsSomewhere});
    targets.push_back({Flat::plane(base, plane.normal),
                       words("perpendicular to {name}", {{"name", plane.name}}), pointsSomewhere});
  }
}

void aimOffset(const Surroundings &found, const ExactVec3 &normal, std::vector<SnapTarget> &targets) {
  for (const NamedPoint &point : found.points)
    targets.push_back({Flat::plane(point.at, normal), through(point.name), {}});
  targets.push_back({Flat::plane(found.origin, normal), words("through the origin"), {}});
  for (const NamedPlane &plane : found.planes)
    if (isZero(cross(plane.normal, normal)))
      targets.push_back(
          {Flat::plane(plane.point, normal), words("the same plane as {name}", {{"name", plane.name}}), {}});
}

} // namespace halfspace
