#include "lessons/object/kinds/vector.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (!isZero(given.object[1])) {
    ArrowMark arrow = arrowMark(given, 1, Subject::Neutral);
    arrow.coordinates = writtenVector(coordinateTerm(given, 1));
    marks.push_back(std::move(arrow));
  }
  PointMark start = pointMark(given, 0, Subject::Neutral);
  start.label.clear(); // the vector is the same wherever it starts
  marks.push_back(std::move(start));
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, 0, words("start of {name}", {{"name", plainText(given.letters[1])}}), found);
  offerPoint(given, 1, words("tip of {name}", {{"name", plainText(given.letters[1])}}), found);
  found.points.back().at += given.object[0];
}

} // namespace

Term termOf(const Given<VectorObject> &vector) { return coordinateTerm(vector, 1); }

namespace object_kinds {

Kind vector() {
  return {.word = VectorObject::kind,
          .noun = [] { return words("a vector"); },
          .meaning = "a vector, drawn from a point",
          .subject = Subject::Neutral,
          .coordinates = {{"A", CoordinateRole::Position}, {"v", CoordinateRole::Direction, true}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimDirections};
}

} // namespace object_kinds
} // namespace halfspace
