#include "lessons/object/kinds/ray.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

std::vector<Mark> draw(const Given<Object> &given) {
  const auto [origin, direction] = as<RayObject>(given).object;
  std::vector<Mark> marks;
  if (!isZero(direction)) {
    // Its arrow and its start have names enough.
    marks.push_back(
        inLook(given.look, RayMark{{given.id, Role::Given, Subject::Ray}, place(origin), unitOf(direction)}));
    marks.push_back(arrowMark(given, 1, Subject::Ray));
  }
  marks.push_back(pointMark(given, 0, Subject::Point));
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, 0, words("start {name}", {{"name", plainText(given.letters[0])}}), found);
}

} // namespace

RayTerms termsOf(const Given<RayObject> &ray) { return {coordinateTerm(ray, 0), coordinateTerm(ray, 1)}; }

namespace object_kinds {

Kind ray() {
  return {.word = RayObject::kind,
          .noun = [] { return words("a ray"); },
          .meaning = "a ray by its start and its direction",
          .subject = Subject::Ray,
          .coordinates = {{"Q", CoordinateRole::Position}, {"r", CoordinateRole::Direction}},
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
