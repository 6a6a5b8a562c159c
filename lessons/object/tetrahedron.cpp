// Tetrahedra.
#include "lessons/object/kind.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  const Object &corners = given.object;
  std::vector<Mark> marks;
  addFaces(given, {corners[0], corners[1], corners[2], corners[3]},
           {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, marks);
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerRing(given, {0, 1, 2, 3}, found);
  offerEdge(given, 0, 2, found);
  offerEdge(given, 1, 3, found);
}

} // namespace

namespace object_kinds {

Kind tetrahedron() {
  return {.word = "tetrahedron",
          .meaning = "a tetrahedron by its corners",
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position},
                          {"P3", CoordinateRole::Position}},
          .leavableVertices = 0,
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
