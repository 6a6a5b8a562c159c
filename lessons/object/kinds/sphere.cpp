#include "lessons/object/kinds/sphere.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

enum Coordinates : std::uint8_t { Center, Radius };

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  if (given.object[Radius].x != 0)
    marks.push_back(SphereMark{wholeOf(given, Subject::Triangle), place(given.object[Center]),
                               toDouble(given.object[Radius].x)});
  marks.push_back(pointMark(given, Center, Subject::Triangle));
  return marks;
}

std::vector<Handle> ownHandles(const std::string &name, const Object &sphere) {
  return {lengthHandle(name, sphere, Radius, 0)};
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerPoint(given, Center, words("centre {name}", {{"name", plainText(given.letters[Center])}}), found);
  if (const Rational &radius = given.object[Radius].x; radius > 0)
    found.spheres.push_back({given.object[Center], radius, plainText(given.symbol)});
}

} // namespace

SphereTerms termsOf(const Given<SphereObject> &sphere) {
  return {coordinateTerm(sphere, Center), coordinateTerm(sphere, Radius).marked(sphere.id)};
}

namespace object_kinds {

Kind sphere() {
  return {.word = SphereObject::kind,
          .noun = [] { return words("a sphere"); },
          .meaning = "a sphere by its centre and its radius",
          .subject = Subject::Triangle,
          .coordinates = {{"c", CoordinateRole::Position}, {"R", CoordinateRole::Length}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleLengths,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
