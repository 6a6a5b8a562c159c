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
    positions.add(toDouble(bound.point->object[0]));
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

// Whether all that is drawn of a mark of the stage lies within reach.

bool isWithinReach(const PointMark &point) { return isWithinReach(point.at); }
bool isWithinReach(const SegmentMark &segment) {
  return isWithinReach(segment.from) && isWithinReach(segment.to);
}
bool isWithinReach(const RayMark &ray) { return isWithinReach(ray.origin) && isWithinReach(endOf(ray)); }
bool isWithinReach(const LineMark &line) {
  const auto [low, high] = endsOf(line);
  return isWithinReach(low) && isWithinReach(high);
}
bool isWithinReach(const ArrowMark &arrow) {
  return isWithinReach(arrow.from) && isWithinReach(arrow.from + shownVector(arrow));
}
bool isWithinReach(const PlanePatchMark &patch) { return isWithinReach(patch.center); }
bool isWithinReach(const PolygonMark &polygon) {
  return std::all_of(polygon.corners.begin(), polygon.corners.end(),
                     [](const Place &corner) { return isWithinReach(corner); });
}
bool isWithinReach(const SphereMark &sphere) {
  return isWithinReach(sphere.center) && sphere.radius <= drawnReach;
}
bool isWithinReach(const MeshMark &mesh) {
  const std::vector<Place> corners = outlineOf(mesh, 1).path;
  return std::all_of(corners.begin(), corners.end(),
                     [](const Place &corner) { return isWithinReach(corner); });
}
bool isWithinReach(const ArcMark &arc) { return isWithinReach(arc.center); }
bool isWithinReach(const RightAngleMark &corner) { return isWithinReach(corner.at); }

/// Puts the marks of a figure on a stage, one at a time.
class Stager {
public:
  explicit Stager(const Stage &stage)
      : m_middle(toDouble(stage.middle)), m_unit(toDouble(stage.unit())), m_isUsual(stage == Stage()) {}

  [[nodiscard]] Figure take() { return std::move(m_figure); }

  /// On the usual stage most marks are what they are in the scene.
  void add(const SharedList<Mark>::Shared &mark) {
    if (m_isUsual && std::visit([](const auto &each) { return isWithinReach(each); }, *mark))
      m_figure.marks.push_back(mark);
    else
      std::visit([this](auto each) { keep(onStage(std::move(each))); }, *mark);
  }

private:
  [[nodiscard]] Place position(const Place &place) const { return (place - m_middle) / m_unit; }

  [[nodiscard]] PointMark onStage(PointMark point) const {
    point.at = position(point.at);
    return point;
  }
  [[nodiscard]] SegmentMark onStage(SegmentMark segment) const {
    segment.from = position(segment.from);
    segment.to = position(segment.to);
    return segment;
  }
  [[nodiscard]] RayMark onStage(RayMark ray) const {
    ray.origin = position(ray.origin);
    if (ray.meets)
      ray.meets = position(*ray.meets);
    return ray;
  }
  [[nodiscard]] LineMark onStage(LineMark line) const {
    line.through = position(line.through);
    for (Place &covered : line.covers)
      covered = position(covered);
    return line;
  }
  [[nodiscard]] ArrowMark onStage(ArrowMark arrow) const {
    arrow.from = position(arrow.from);
    if (!arrow.drawnLength)
      arrow.vector /= m_unit;
    const double length = glm::length(arrow.vector);
    if (arrow.isFree && !m_isUsual && length > 0)
      arrow.drawnLength = std::clamp(length, shortestArrow, longestArrow);
    return arrow;
  }
  [[nodiscard]] PlanePatchMark onStage(PlanePatchMark patch) const {
    patch.center = position(patch.center);
    for (Place &covered : patch.covers)
      covered = position(covered);
    return patch;
  }
  [[nodiscard]] PolygonMark onStage(PolygonMark polygon) const {
    for (Place &corner : polygon.corners)
      corner = position(corner);
    return polygon;
  }
  [[nodiscard]] SphereMark onStage(SphereMark sphere) const {
    sphere.center = position(sphere.center);
    sphere.radius /= m_unit;
    return sphere;
  }
  [[nodiscard]] MeshMark onStage(MeshMark mesh) const {
    mesh.place = position(mesh.place);
    mesh.axes /= m_unit;
    return mesh;
  }
  [[nodiscard]] ArcMark onStage(ArcMark arc) const {
    arc.center = position(arc.center);
    return arc;
  }
  [[nodiscard]] RightAngleMark onStage(RightAngleMark corner) const {
    corner.at = position(corner.at);
    return corner;
  }

  /// What reaches too far is left out, where it cannot be cut off.
  template <class Kind> void keep(Kind mark) {
    if (isWithinReach(mark))
      m_figure.add(std::move(mark));
  }
  void keep(const SegmentMark &segment) { keepLine(segment, segment.from, segment.to); }
  void keep(LineMark line) {
    if (isWithinReach(line)) {
      m_figure.add(std::move(line));
      return;
    }
    const auto [low, high] = endsOf(line);
    keepLine(std::move(line), low, high);
  }
  void keep(ArrowMark arrow) {
    if (isWithinReach(arrow)) {
      m_figure.add(std::move(arrow));
      return;
    }
    const Place tip = arrow.from + shownVector(arrow);
    keepLine(arrow, arrow.from, tip);
  }
  void keep(RayMark ray) {
    Place start = ray.origin;
    Place end = endOf(ray);
    if (!isWithinReach(end) && cutToReach(start, end))
      ray.meets = end;
    if (isWithinReach(ray.origin))
      m_figure.add(std::move(ray));
  }
  void keepLine(MarkBase base, Place from, Place to) {
    if (cutToReach(from, to))
      m_figure.add(SegmentMark{std::move(base), from, to});
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
  const auto movedGiven = [&](Given<Object> given) {
    given.object = toStage(std::move(given.object), stage);
    return std::make_shared<const Given<Object>>(std::move(given));
  };
  for (std::size_t place = 0; place < placed.scene.entries.size(); ++place)
    if (const auto *object = std::get_if<Object>(&placed.scene.entries[place].content))
      placed.scene.entries.change(place, [&](Entry &entry) { entry.content = toStage(*object, stage); });
  for (PlacedObject &bound : placed.bound) {
    bound.point = movedGiven(*bound.point);
    bound.host = movedGiven(*bound.host);
  }
  placed.origin = toStage(placed.origin, CoordinateRole::Position, stage);
  return placed;
}

Object toStage(Object object, const Stage &stage) {
  for (std::size_t i = 0; i < object.size(); ++i)
    object[i] = toStage(object[i], coordinatesOf(object)[i].role, stage);
  return object;
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
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    stager.add(figure.marks.shared(place));
  return stager.take();
}

} // namespace halfspace
