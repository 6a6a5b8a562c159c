// Boxes along the axes.
#include "lessons/object/kind.h"

namespace halfspace {
namespace {

/// The corners, counted by which lengths are added: x, y, z as the bits 1, 2, 4.
std::vector<ExactVec3> cornersOf(const Object &box) {
  std::vector<ExactVec3> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    ExactVec3 corner = box[0];
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((i >> axis) % 2 == 1)
        corner[static_cast<int>(axis)] += box[axis + 1].x;
    corners.push_back(corner);
  }
  return corners;
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  addFaces(given, cornersOf(given.object),
           {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, marks);
  marks.push_back(pointMark(given, 0, Subject::Triangle));
  return marks;
}

std::vector<Handle> ownHandles(const std::string &name, const Object &box) {
  return {lengthHandle(name, box, 1, 0), lengthHandle(name, box, 2, 1), lengthHandle(name, box, 3, 2)};
}

void offer(const Given<Object> &given, Surroundings &found) { offerVertex(given, 0, found); }

} // namespace

namespace object_kinds {

Kind box() {
  return {.word = "box",
          .meaning = "a box along the axes, by its lowest corner and three lengths",
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"a", CoordinateRole::Length},
                          {"b", CoordinateRole::Length},
                          {"c", CoordinateRole::Length}},
          .leavableVertices = 0,
          .binding = {},
          .settle = settleLengths,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
