// Polygons: flat and convex ones are filled, others only outlined.
#include "lessons/object/corners.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<ExactVec3> corners;
  for (std::size_t i = 0; i < given.object.size(); ++i)
    corners.push_back(given.object[i]);
  std::vector<Mark> marks;
  addFace(wholeOf(given, Subject::Triangle), corners, marks);
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerRing(given, cornersOf(given.object), found);
}

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
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
