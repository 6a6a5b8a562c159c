// Planes by three points.
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/term/plain_text.h"

namespace halfspace {
namespace {

ExactVec3 normalOf(const Object &plane) { return cross(plane[1] - plane[0], plane[2] - plane[0]); }

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (const ExactVec3 normal = normalOf(given.object); !isZero(normal))
    marks.push_back(PlanePatchMark{wholeOf(given, Subject::Plane),
                                   place(given.object[0]),
                                   unitOf(normal),
                                   {place(given.object[1]), place(given.object[2])}});
  for (std::size_t i = 0; i < 3; ++i)
    marks.push_back(pointMark(given, i, Subject::Plane));
  return marks;
}

std::vector<Handle> ownHandles(const Given<Object> &given) { return {wholeHandle(given)}; }

void offer(const Given<Object> &given, Surroundings &found) {
  offerVertices(given, 0, 3, true, found);
  if (const ExactVec3 normal = normalOf(given.object); !isZero(normal))
    found.planes.push_back({given.object[0], normal, plainText(given.symbol)});
}

} // namespace

namespace object_kinds {

Kind plane_through_points() {
  return {.word = "plane-through-points",
          .meaning = "a plane by three points of it",
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position}},
          .leavableVertices = 0,
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
