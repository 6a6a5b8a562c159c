// Prisms: a polygon and the same moved along an arrow.
#include "lessons/object/corners.h"
#include "lessons/object/kind.h"

namespace halfspace {
namespace {

/// The arrow stands second: a direction starts from the first position, and vertices stand last.
constexpr std::size_t way = 1;

std::vector<ExactVec3> baseOf(const Object &prism) {
  std::vector<ExactVec3> base;
  for (const std::size_t corner : cornersOf(prism))
    base.push_back(prism[corner]);
  return base;
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<ExactVec3> corners = baseOf(given.object);
  const std::size_t count = corners.size();
  std::vector<std::vector<std::size_t>> faces(2);
  for (std::size_t i = 0; i < count; ++i) {
    corners.push_back(corners[i] + given.object[way]);
    faces[0].push_back(i);
    faces[1].push_back(i + count);
    faces.push_back({i, (i + 1) % count, (i + 1) % count + count, i + count});
  }
  std::vector<Mark> marks;
  addFaces(given, corners, faces, marks);
  if (!isZero(given.object[way]))
    marks.push_back(arrowMark(given, way, Subject::Triangle));
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerRing(given, cornersOf(given.object), found);
}

} // namespace

namespace object_kinds {

Kind prism() {
  return {.word = "prism",
          .meaning = "a prism by the corners of its base, three to eight, and the arrow to its top",
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"h", CoordinateRole::Direction},
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
          .aim = aimDirections};
}

} // namespace object_kinds
} // namespace halfspace
