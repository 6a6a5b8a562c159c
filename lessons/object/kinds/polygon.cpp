// Polygons: flat and convex ones are filled, others only outlined.
#include "lessons/object/kinds/polygon.h"

#include "lessons/object/corners.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  addFace(wholeOf(given, Subject::Triangle), as<PolygonObject>(given).object.corners, marks);
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerRing(given, cornersOf(given.object), found);
}

} // namespace

template <> Object::Object(const PolygonObject &polygon) : Object(detail::kindNamed(PolygonObject::kind)) {
  while (size() < polygon.corners.size())
    addVertex();
  std::copy(polygon.corners.begin(), polygon.corners.end(), m_coordinates.begin());
}

template <> std::optional<PolygonObject> objectAs<PolygonObject>(const Object &object) {
  if (kindOf(object) != PolygonObject::kind)
    return {};
  PolygonObject polygon;
  for (std::size_t i = 0; i < object.size(); ++i)
    polygon.corners.push_back(object[i]);
  return polygon;
}

std::vector<Term> cornerTermsOf(const Given<PolygonObject> &polygon) {
  std::vector<Term> corners;
  for (std::size_t i = 0; i < polygon.object.corners.size(); ++i)
    corners.push_back(coordinateTerm(polygon, i));
  return corners;
}

namespace object_kinds {

Kind polygon() {
  return {.word = PolygonObject::kind,
          .noun = [] { return words("a polygon"); },
          .meaning = "a polygon by three to eight corners; filled where it is flat and convex",
          .subject = Subject::Triangle,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position},
                          {"P3", CoordinateRole::Position},
                          {"P4", CoordinateRole::Position},
                          {"P5", CoordinateRole::Position},
                          {"P6", CoordinateRole::Position},
                          {"P7", CoordinateRole::Position}},
          .leavableVertices = 5,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
