// Planes by three points.
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (const ExactVec3 normal = normalOfCorners(given.object); !isZero(normal))
    marks.push_back(PlanePatchMark{wholeOf(given, Subject::Plane),
                                   place(given.object[0]),
                                   unitOf(normal),
                                   {place(given.object[1]), place(given.object[2])}});
  addPoints(given, Subject::Plane, marks);
  return marks;
}

} // namespace

namespace object_kinds {

Kind plane_through_points() {
  return {.word = "plane-through-points",
          .noun = [] { return words("a plane through points"); },
          .meaning = "a plane by three points of it",
          .subject = Subject::Plane,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offerCorners,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
