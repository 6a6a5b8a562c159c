// Polygons: flat and convex ones are filled, others only outlined.
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"

namespace halfspace {
namespace {

std::vector<Place> places(const Object &polygon) {
  std::vector<Place> all;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    all.push_back(place(polygon[i]));
  return all;
}

/// Whether the corners lie in one plane and turn the same way everywhere, once around.
bool isFlatAndConvex(const Object &polygon) {
  const std::size_t count = polygon.size();
  const ExactVec3 normal = cross(polygon[1] - polygon[0], polygon[2] - polygon[1]);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 2; k < count; ++k) {
      // Every other corner on the same side of every edge: so a star that goes around twice is none.
      const ExactVec3 &from = polygon[i];
      const ExactVec3 edge = polygon[(i + 1) % count] - from;
      const ExactVec3 other = polygon[(i + k) % count] - from;
      const ExactVec3 turn = cross(edge, other);
      if (dot(normal, other) != 0 || dot(turn, normal) <= 0)
        return false;
    }
  return true;
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  std::vector<Place> corners = places(given.object);
  if (isFlatAndConvex(given.object)) {
    marks.push_back(PolygonMark{wholeOf(given, Subject::Triangle), std::move(corners)});
  } else {
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (const Place &next = corners[(i + 1) % corners.size()]; next != corners[i])
        marks.push_back(SegmentMark{
            {given.id + "/" + std::to_string(i), Role::Given, Subject::Triangle}, corners[i], next});
  }
  for (std::size_t i = 0; i < given.object.size(); ++i)
    marks.push_back(pointMark(given, i, Subject::Triangle));
  return marks;
}

std::vector<Handle> ownHandles(const Given<Object> &given) { return {wholeHandle(given)}; }

void offer(const Given<Object> &given, Surroundings &found) { offerVertices(given, 0, true, found); }

} // namespace

namespace object_kinds {

Kind polygon() {
  return {.word = "polygon",
          .meaning = "a polygon by three to eight corners; filled where it is flat and convex",
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position},
                          {"P3", CoordinateRole::Position},
                          {"P4", CoordinateRole::Position},
                          {"P5", CoordinateRole::Position},
                          {"P6", CoordinateRole::Position},
                          {"P7", CoordinateRole::Position}},
          .leavableVertices = 5,
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
