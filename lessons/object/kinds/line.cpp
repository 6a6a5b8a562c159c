#include "lessons/object/kinds/line.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  const auto [point, direction] = as<LineObject>(given).object;
  std::vector<Mark> marks;
  if (!isZero(direction)) {
    marks.push_back(LineMark{wholeOf(given, Subject::Ray), place(point), unitOf(direction)});
    marks.push_back(arrowMark(given, 1, Subject::Ray));
  }
  marks.push_back(pointMark(given, 0, Subject::Ray));
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, 0, words("point {name}", {{"name", plainText(given.letters[0])}}), found);
  if (!isZero(given.object[1]))
    found.lines.push_back(
        {given.object[0], given.object[1], words("line {name}", {{"name", plainText(given.symbol)}})});
}

} // namespace

LineTerms termsOf(const Given<LineObject> &line) {
  return {coordinateTerm(line, 0), coordinateTerm(line, 1)};
}

namespace object_kinds {

Kind line() {
  return {.word = LineObject::kind,
          .noun = [] { return words("a line"); },
          .meaning = "a line by a point of it and a direction",
          .subject = Subject::Ray,
          .coordinates = {{"A", CoordinateRole::Position}, {"v", CoordinateRole::Direction}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimStartAndDirection};
}

} // namespace object_kinds
} // namespace halfspace
