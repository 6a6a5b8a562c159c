#include "lessons/object/kinds/point.h"

#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) { return {pointMark(given, 0, Subject::Point)}; }

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, 0, words("point {name}", {{"name", plainText(given.symbol)}}), found);
}

} // namespace

Term termOf(const Given<PointObject> &point) { return coordinateTerm(point, 0); }

namespace object_kinds {

Kind point() {
  return {.word = PointObject::kind,
          .noun = [] { return words("a point"); },
          .meaning = "a free point",
          .subject = Subject::Point,
          .coordinates = {{"", CoordinateRole::Position}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
