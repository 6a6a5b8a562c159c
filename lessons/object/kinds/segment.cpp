#include "lessons/object/kinds/segment.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (given.object[0] != given.object[1]) // its ends have names enough
    marks.push_back(inLook(
        given.look,
        SegmentMark{{given.id, Role::Given, Subject::Ray}, place(given.object[0]), place(given.object[1])}));
  addPoints(given, Subject::Point, marks);
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerVertex(given, 0, found);
  offerVertex(given, 1, found);
  offerEdge(given, 0, 1, found);
}

} // namespace

SegmentTerms termsOf(const Given<SegmentObject> &segment) {
  return {coordinateTerm(segment, 0), coordinateTerm(segment, 1)};
}

namespace object_kinds {

Kind segment() {
  return {.word = SegmentObject::kind,
          .noun = [] { return words("a segment"); },
          .meaning = "a segment by its ends",
          .subject = Subject::Ray,
          .coordinates = {{"A", CoordinateRole::Position}, {"B", CoordinateRole::Position}},
          .leavableVertices = 0,
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
