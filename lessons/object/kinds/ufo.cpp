#include "lessons/object/kinds/ufo.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (!isZero(given.object[1]))
    marks.push_back(arrowMark(given, 1, Subject::Neutral));
  if (!isZero(given.object[2]))
    marks.push_back(arrowMark(given, 2, Subject::Ray));
  marks.push_back(pointMark(given, 0, Subject::Point));
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, 0, words("start {name}", {{"name", plainText(given.letters[0])}}), found);
}

} // namespace

UfoTerms termsOf(const Given<UfoObject> &ufo) {
  return {coordinateTerm(ufo, 0), coordinateTerm(ufo, 1), coordinateTerm(ufo, 2),
          coordinateTerm(ufo, 3).marked({})};
}

namespace object_kinds {

Kind ufo() {
  return {.word = UfoObject::kind,
          .noun = [] { return words("a flying saucer"); },
          .meaning =
              "a flying saucer by where it starts, how far it flies in a hundred frames, where its barrel "
              "points, and how long that is",
          .subject = {},
          .coordinates = {{"S", CoordinateRole::Position},
                          {"c", CoordinateRole::Direction},
                          {"g", CoordinateRole::Direction},
                          {"l", CoordinateRole::Length}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleLengths,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimDirections};
}

} // namespace object_kinds
} // namespace halfspace
