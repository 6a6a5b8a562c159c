#include "lessons/object/kinds/triangle.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  const auto [p0, p1, p2] = as<TriangleObject>(given).object;
  std::vector<Mark> marks;
  if (!isZero(normalOfCorners(given.object))) // its corners have names enough
    marks.push_back(inLook(given.look, PolygonMark{{given.id, Role::Given, Subject::Triangle},
                                                   {place(p0), place(p1), place(p2)}}));
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

/// In line with the two other corners: the degenerate case that a learner is asked to find.
void aim(const Given<Object> &given, const Handle &handle, const Surroundings &,
         std::vector<SnapTarget> &targets) {
  const std::size_t first = handle.coordinate == 0 ? 1 : 0;
  const std::size_t second = handle.coordinate == 2 ? 1 : 2;
  const ExactVec3 &from = given.object[first];
  const ExactVec3 &to = given.object[second];
  if (from != to)
    targets.push_back(
        {Flat::line(from, to - from),
         words("in line with {first} and {second}",
               {{"first", plainText(given.letters[first])}, {"second", plainText(given.letters[second])}}),
         {}});
}

} // namespace

TriangleTerms termsOf(const Given<TriangleObject> &triangle) {
  return {coordinateTerm(triangle, 0), coordinateTerm(triangle, 1), coordinateTerm(triangle, 2)};
}

namespace object_kinds {

Kind triangle() {
  return {.word = TriangleObject::kind,
          .noun = [] { return words("a triangle"); },
          .meaning = "a triangle by its corners",
          .subject = Subject::Triangle,
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
          .aim = aim};
}

} // namespace object_kinds
} // namespace halfspace
