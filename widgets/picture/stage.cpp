#include "widgets/picture/stage.h"

#include "widgets/picture/shapes/mark_outline.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Scenes from here on up to stageReach across have the unit 1; smaller ones are brought nearer.
constexpr double smallestAcross = 0.2;
/// Objects that stand together within this part of their distance from the origin have a stage of their own,
/// without it: with it they would lie in one pixel.
constexpr double togetherPart = 0.002;
/// Where a scene is not of usual size, free arrows are drawn within these lengths.
constexpr double shortestArrow = 1.5;
constexpr double longestArrow = 12;
/// A stage without the origin has its own on whole multiples of so many units: so its grid is the scene's.
constexpr int middleStep = 25;
/// Where the ground is not farther than so many units from the objects, it is on the stage.
constexpr int farthestGround = 75;

/// The box around places, in scene units.
struct Box {
  Place low{};
  Place high{};
  bool isEmpty = true;

  void add(const Place &place) {
    low = isEmpty ? place : glm::min(low, place);
    high = isEmpty ? place : glm::max(high, place);
    isEmpty = false;
  }
  /// The longest side.
  [[nodiscard]] double across() const { return longest(high - low); }
  /// From the origin, in the coordinate in which it is farthest.
  [[nodiscard]] double distance() const { return std::max(longest(low), longest(high)); }

  static double longest(const Place &vector) {
    return std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  }
};

/// Adds a coordinate of an object that starts at a place.
void add(CoordinateRole role, const Place &start, const Place &value, Box &positions, Box &tips) {
  switch (role) {
  case CoordinateRole::Position:
    positions.add(value);
    break;
  case CoordinateRole::Direction:
    tips.add(start + value);
    break;
  case CoordinateRole::Length: // whichever way it reaches
    positions.add(start - Place(value.x));
    positions.add(start + Place(value.x));
    break;
  case CoordinateRole::Number:
    break;
  }
}

/// The box around all positions of a scene. Directions count where all positions are the origin: usually
/// their size has nothing to do with that of the positions.
Box boxAround(const Scene &scene, const std::vector<PlacedObject> &boundObjects) {
  Box positions;
  Box tips;
  for (const PlacedObject &bound : boundObjects)
    positions.add(toDouble(bound.point.object[0]));
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && !isBound(entry)) {
      const auto specs = coordinatesOf(*object);
      const Place start = toDouble(coordinate(*object, 0));
      for (std::size_t i = 0; i < specs.size(); ++i)
        add(specs[i].role, start, toDouble(coordinate(*object, i)), positions, tips);
    }
  if (positions.distance() > 0 || tips.isEmpty)
    return positions;
  positions.add(tips.low);
  positions.add(tips.high);
  return positions;
}

/// Cuts off what a line from `from` to `to` has beyond drawnReach; false where nothing is left.
bool cutToReach(Place &from, Place &to) {
  const Place along = to - from;
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0) {
      if (std::abs(from[axis]) > drawnReach)
        return false;
      continue;
    }
    const double a = (-drawnReach - from[axis]) / along[axis];
    const double b = (drawnReach - from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave))
    return false;
  // Multiplied by a part that is not exact a far end may still lie a little beyond.
  const auto at = [&](double part) {
    return part == 0 ? from : part == 1 ? to : glm::clamp(from + along * part, -drawnReach, drawnReach);
  };
  const Place cutFrom = at(enter);
  to = at(leave);
  from = cutFrom;
  return true;
}

bool isWithinReach(const Place &place) { return Box::longest(place) <= drawnReach; } // false for NaN

/// Puts the marks of a figure on a stage, one at a time.
class Stager {
public:
  explicit Stager(const Stage &stage)
      : m_middle(toDouble(stage.middle)), m_unit(toDouble(stage.unit())), m_isUsual(stage == Stage()) {}

  [[nodiscard]] Figure take() { return std::move(m_figure); }

  void operator()(PointMark point) {
    point.at = position(point.at);
    if (isWithinReach(point.at))
      keep(std::move(point));
  }
  void operator()(const SegmentMark &segment) {
    keepLine(segment, position(segment.from), position(segment.to));
  }
  void operator()(RayMark ray) {
    ray.origin = position(ray.origin);
    if (ray.meets)
      ray.meets = position(*ray.meets);
    Place start = ray.origin;
    Place end = endOf(ray);
    if (!isWithinReach(end) && cutToReach(start, end))
      ray.meets = end;
    if (isWithinReach(ray.origin))
      keep(std::move(ray));
  }
  void operator()(LineMark line) {
    line.through = position(line.through);
    for (Place &covered : line.covers)
      covered = position(covered);
    const auto [low, high] = endsOf(line);
    if (isWithinReach(low) && isWithinReach(high))
      keep(std::move(line));
    else
      keepLine(line, low, high);
  }
  void operator()(ArrowMark arrow) {
    arrow.from = position(arrow.from);
    if (!arrow.drawnLength)
      arrow.vector /= m_unit;
    const double length = glm::length(arrow.vector);
    if (arrow.isFree && !m_isUsual && length > 0)
      arrow.drawnLength = std::clamp(length, shortestArrow, longestArrow);
    const Place tip = arrow.from + shownVector(arrow);
    if (isWithinReach(arrow.from) && isWithinReach(tip))
      keep(std::move(arrow));
    else
      keepLine(arrow, arrow.from, tip);
  }
  void operator()(PlanePatchMark patch) {
    patch.center = position(patch.center);
    for (Place &covered : patch.covers)
      covered = position(covered);
    if (isWithinReach(patch.center))
      keep(std::move(patch));
  }
  void operator()(PolygonMark polygon) {
    for (Place &corner : polygon.corners)
      corner = position(corner);
    if (std::all_of(polygon.corners.begin(), polygon.corners.end(), isWithinReach))
      keep(std::move(polygon));
  }
  void operator()(SphereMark sphere) {
    sphere.center = position(sphere.center);
    sphere.radius /= m_unit;
    if (isWithinReach(sphere.center) && sphere.radius <= drawnReach)
      keep(std::move(sphere));
  }
  void operator()(MeshMark mesh) {
    mesh.place = position(mesh.place);
    mesh.axes /= m_unit;
    const std::vector<Place> corners = outlineOf(mesh, 1).path;
    if (std::all_of(corners.begin(), corners.end(), isWithinReach))
      keep(std::move(mesh));
  }
  void operator()(ArcMark arc) {
    arc.center = position(arc.center);
    if (isWithinReach(arc.center))
      keep(std::move(arc));
  }
  void operator()(RightAngleMark corner) {
    corner.at = position(corner.at);
    if (isWithinReach(corner.at))
      keep(std::move(corner));
  }

private:
  [[nodiscard]] Place position(const Place &place) const { return (place - m_middle) / m_unit; }
  void keep(Mark mark) { m_figure.add(std::move(mark)); }
  void keepLine(MarkBase base, Place from, Place to) {
    if (cutToReach(from, to))
      keep(SegmentMark{std::move(base), from, to});
  }

  Place m_middle;
  double m_unit;
  bool m_isUsual;
  Figure m_figure;
};

} // namespace

Rational Stage::unit() const { return powerOfTen(exponent); }

int suitingExponent(double across) {
  if (across > stageReach)
    return static_cast<int>(std::ceil(std::log10(across / 50)));
  if (across > 0 && across < smallestAcross)
    return static_cast<int>(std::floor(std::log10(across / 2)));
  return 0;
}

Stage stageOf(const Scene &scene, const std::vector<PlacedObject> &bound) {
  Stage stage;
  const Box box = boxAround(scene, bound);
  const double distance = box.distance();
  const double across = box.across(); // 0 for a single position: then there is nothing to be told apart
  const bool standsApart = distance > stageReach && across > 0 && across < togetherPart * distance;
  stage.exponent = standsApart ? std::max(0, suitingExponent(across)) : suitingExponent(distance);
  if (!standsApart)
    return stage;
  const Place middle = (box.low + box.high) / 2.0;
  const Rational step = stage.unit() * middleStep;
  for (int axis = 0; axis < 3; ++axis)
    stage.middle[axis] = roundToMultiple(middle[axis], step);
  if (abs(stage.middle.z) <= stage.unit() * farthestGround)
    stage.middle.z = 0;
  return stage;
}

ExactVec3 toStage(const ExactVec3 &value, CoordinateRole role, const Stage &stage) {
  if (role == CoordinateRole::Number)
    return value;
  return (role == CoordinateRole::Position ? value - stage.middle : value) * powerOfTen(-stage.exponent);
}

ExactVec3 fromStage(const ExactVec3 &value, CoordinateRole role, const Stage &stage) {
  if (role == CoordinateRole::Number)
    return value;
  const ExactVec3 length = value * stage.unit();
  return role == CoordinateRole::Position ? length + stage.middle : length;
}

PlacedScene toStage(PlacedScene placed, const Stage &stage) {
  if (stage == Stage())
    return placed;
  const auto move = [&](Object &object) {
    for (std::size_t i = 0; i < object.size(); ++i)
      object[i] = toStage(object[i], coordinatesOf(object)[i].role, stage);
  };
  for (Entry &entry : placed.scene.entries)
    if (auto *object = std::get_if<Object>(&entry.content))
      move(*object);
  for (PlacedObject &bound : placed.bound) {
    move(bound.point.object);
    move(bound.host);
  }
  placed.origin = toStage(placed.origin, CoordinateRole::Position, stage);
  return placed;
}

Object fromStage(Object object, const Stage &stage) {
  if (stage == Stage())
    return object;
  for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i)
    coordinate(object, i) = fromStage(coordinate(object, i), coordinatesOf(object)[i].role, stage);
  return object;
}

Figure toStage(const Figure &figure, const Stage &stage) {
  Stager stager(stage);
  for (const Mark &mark : figure.marks)
    std::visit(stager, mark);
  return stager.take();
}

} // namespace halfspace
