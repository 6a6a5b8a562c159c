#include "lessons/object/kind.h"

#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// The handle of a whole keeps so far away from its corners, in units of the picture: where it lay on one, it
/// could not be told from it.
constexpr int leastWayToCorners = 1;

/// The heights above a place, from one to another, that are too near to a corner.
struct Heights {
  Rational from;
  Rational to;
};

/// Those for a corner that lies beside the place as `way` says; nothing where all are far enough away.
std::optional<Heights> heightsNear(const ExactVec3 &way) {
  const Rational left = leastWayToCorners * leastWayToCorners - way.x * way.x - way.y * way.y;
  if (left <= 0)
    return {};
  const Rational half = exactly(std::sqrt(toDouble(left)));
  return Heights{way.z - half, way.z + half};
}

/// How far a place is lifted to be away from all corners: not at all where it is already. A corner that comes
/// to it from the side lifts it without a jump.
Rational liftOver(const std::vector<ExactVec3> &corners, const ExactVec3 &place) {
  std::vector<Heights> taken;
  for (const ExactVec3 &corner : corners)
    if (const auto heights = heightsNear(corner - place))
      taken.push_back(*heights);
  std::sort(taken.begin(), taken.end(), [](const Heights &a, const Heights &b) { return a.from < b.from; });
  Rational lift = 0;
  for (const Heights &heights : taken)
    if (heights.from < lift && lift < heights.to)
      lift = heights.to;
  return lift;
}

} // namespace

void settleNothing(Object &) {}

std::vector<Mark> drawNothing(const Given<Object> &) { return {}; }

std::vector<Handle> noHandles(const std::string &, const Object &) { return {}; }

void offerNothing(const Given<Object> &, Surroundings &) {}

void aimAtNothing(const Given<Object> &, const Handle &, const Surroundings &, std::vector<SnapTarget> &) {}

MarkBase wholeOf(const Given<Object> &given, Subject subject) {
  return inLook(given.look, MarkBase{given.id, Role::Given, subject, latexOf(given.symbol)});
}

MarkBase partOf(const Given<Object> &given, std::size_t index, Subject subject) {
  return inLook(given.look, MarkBase{coordinateId(given.id, coordinatesOf(given.object)[index]), Role::Given,
                                     subject, latexOf(given.letters[index])});
}

PointMark pointMark(const Given<Object> &given, std::size_t index, Subject subject) {
  MarkBase base = partOf(given, index, subject);
  base.coordinates = writtenCoordinates(coordinateTerm(given, index));
  return {std::move(base), place(given.object[index])};
}

ArrowMark arrowMark(const Given<Object> &given, std::size_t index, Subject subject) {
  return {partOf(given, index, subject), place(given.object[0]), place(given.object[index]), true};
}

void addPoints(const Given<Object> &given, Subject subject, std::vector<Mark> &marks) {
  const auto specs = coordinatesOf(given.object);
  for (std::size_t i = 0; i < specs.size(); ++i)
    if (specs[i].role == CoordinateRole::Position)
      marks.push_back(pointMark(given, i, subject));
}

void addFace(const MarkBase &base, const std::vector<ExactVec3> &corners, std::vector<Mark> &marks) {
  std::vector<Place> places;
  places.reserve(corners.size());
  for (const ExactVec3 &corner : corners)
    places.push_back(place(corner));
  if (isFlatAndConvex(corners)) {
    marks.push_back(PolygonMark{base, std::move(places)});
    return;
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const Place &next = places[(i + 1) % places.size()]; next != places[i])
      marks.push_back(inLook(
          base.look,
          SegmentMark{{base.id + "/side" + std::to_string(i), base.role, base.subject}, places[i], next}));
}

std::string faceId(const std::string &object, std::size_t face) {
  return face == 0 ? object : object + "/face" + std::to_string(face);
}

void addFaces(const Given<Object> &given, Subject subject, const std::vector<ExactVec3> &corners,
              const std::vector<std::vector<std::size_t>> &faces, std::vector<Mark> &marks) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    MarkBase base = wholeOf(given, subject);
    base.id = faceId(given.id, i);
    if (i > 0)
      base.label.clear();
    std::vector<ExactVec3> around;
    for (const std::size_t corner : faces[i])
      around.push_back(corners[corner]);
    addFace(base, around, marks);
  }
}

void offerPoint(const Given<Object> &given, std::size_t index, std::string words, Surroundings &found) {
  found.points.push_back({given.object[index], std::move(words)});
}

void offerVertex(const Given<Object> &given, std::size_t index, Surroundings &found) {
  offerPoint(given, index, words("corner {name}", {{"name", plainText(given.letters[index])}}), found);
}

void offerEdge(const Given<Object> &given, std::size_t from, std::size_t to, Surroundings &found) {
  if (given.object[from] != given.object[to])
    found.edges.push_back(
        {given.object[from], given.object[to],
         words("edge {name}", {{"name", edgeName(given.letters[from], given.letters[to])}})});
}

void offerRing(const Given<Object> &given, const std::vector<std::size_t> &corners, Surroundings &found) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    offerVertex(given, corners[i], found);
    offerEdge(given, corners[std::min(i, next)], corners[std::max(i, next)], found);
  }
}

ExactVec3 normalOfCorners(const Object &object) {
  return cross(object[1] - object[0], object[2] - object[0]);
}

void offerCorners(const Given<Object> &given, Surroundings &found) {
  offerRing(given, {0, 1, 2}, found);
  if (const ExactVec3 normal = normalOfCorners(given.object); !isZero(normal))
    found.planes.push_back({given.object[0], normal, plainText(given.symbol)});
}

void aimDirections(const Given<Object> &given, const Handle &handle, const Surroundings &found,
                   std::vector<SnapTarget> &targets) {
  if (handle.motion == Handle::Motion::Coordinate &&
      coordinatesOf(given.object)[handle.coordinate].role == CoordinateRole::Direction)
    aimAtSurroundings(found, handle.base, targets);
}

void aimStartAndDirection(const Given<Object> &given, const Handle &handle, const Surroundings &found,
                          std::vector<SnapTarget> &targets) {
  aimDirections(given, handle, found, targets);
  if (const ExactVec3 &direction = given.object[1]; handle.coordinate == 0 && !isZero(direction))
    aimFromStart(found, direction, targets);
}

std::vector<Handle> wholeHandle(const std::string &name, const Object &object) {
  const auto specs = coordinatesOf(object);
  std::vector<ExactVec3> corners;
  ExactVec3 sum(0);
  for (std::size_t i = 0; i < specs.size(); ++i)
    if (specs[i].role == CoordinateRole::Position) {
      corners.push_back(object[i]);
      sum += object[i];
    }
  const ExactVec3 middle = sum / Rational(corners.size());
  Handle handle;
  handle.id = name + ".whole";
  handle.object = name;
  handle.motion = Handle::Motion::Whole;
  handle.middle = middle;
  handle.at = middle + ExactVec3(0, 0, liftOver(corners, middle));
  // So the first position is the one that is snapped: parts of a middle would be no short numbers.
  handle.base = handle.at - object[0];
  return {handle};
}

Handle lengthHandle(const std::string &name, const Object &object, std::size_t index, int axis) {
  Handle handle;
  handle.id = coordinateId(name, coordinatesOf(object)[index]);
  handle.object = name;
  handle.motion = Handle::Motion::Length;
  handle.coordinate = index;
  handle.base = object[0];
  handle.axis[axis] = 1;
  handle.at = handle.base + handle.axis * object[index].x;
  return handle;
}

void settleLengths(Object &object) {
  const auto specs = coordinatesOf(object);
  for (std::size_t i = 0; i < specs.size(); ++i)
    if (specs[i].role == CoordinateRole::Length)
      object[i].x = std::max(object[i].x, Rational(0));
}

} // namespace halfspace
