#include "lessons/object/kinds/screen.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

enum Coordinates : std::uint8_t { Corner, U, V, Columns, Rows };

/// Whole numbers of pixels, as many as there may be.
void settle(Object &screen) {
  for (const Coordinates pixels : {Columns, Rows})
    screen[pixels].x = std::clamp(floorOf(screen[pixels].x), Rational(1), Rational(ScreenObject::mostPixels));
}

/// The columns or the rows: strips beside each other, so that their edges are the lines between the pixels.
void drawStrips(const Given<Object> &given, const ExactVec3 &from, const ExactVec3 &width,
                const ExactVec3 &length, const Rational &count, std::vector<Mark> &marks) {
  for (int i = 0; i < count; ++i) {
    const ExactVec3 begin = from + width * Rational(i);
    const ExactVec3 end = begin + width;
    marks.push_back(
        inLook(given.look, PolygonMark{{faceId(given.id, marks.size()), Role::Given, Subject::Neutral},
                                       {place(begin), place(end), place(ExactVec3(end + length)),
                                        place(ExactVec3(begin + length))}}));
  }
}

std::vector<Mark> draw(const Given<Object> &given) {
  const ScreenObject screen = as<ScreenObject>(given).object;
  const auto &[corner, u, v, w, h] = screen;
  std::vector<Mark> marks;
  if (!isZero(cross(u, v))) { // its corner and its edges have names enough
    drawStrips(given, corner, ExactVec3(u / w), v, w, marks);
    drawStrips(given, corner, ExactVec3(v / h), u, h, marks);
  }
  if (!isZero(u))
    marks.push_back(arrowMark(given, U, Subject::EdgeU));
  if (!isZero(v))
    marks.push_back(arrowMark(given, V, Subject::EdgeV));
  marks.push_back(pointMark(given, Corner, Subject::Neutral));
  return marks;
}

void offer(const Given<Object> &given, Surroundings &found) {
  offerVertex(given, Corner, found);
  if (const ExactVec3 normal = cross(given.object[U], given.object[V]); !isZero(normal))
    found.planes.push_back({given.object[Corner], normal, plainText(given.symbol)});
}

} // namespace

ScreenTerms termsOf(const Given<ScreenObject> &screen) {
  return {coordinateTerm(screen, Corner), coordinateTerm(screen, U), coordinateTerm(screen, V),
          coordinateTerm(screen, Columns).marked({}), coordinateTerm(screen, Rows).marked({})};
}

namespace object_kinds {

Kind screen() {
  return {.word = ScreenObject::kind,
          .noun = [] { return words("a screen"); },
          .meaning = "a screen by a corner and two edges, with the numbers of its pixels along them",
          .subject = Subject::Neutral,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"u", CoordinateRole::Direction},
                          {"v", CoordinateRole::Direction},
                          {"w", CoordinateRole::Number},
                          {"h", CoordinateRole::Number}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settle,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimDirections};
}

} // namespace object_kinds
} // namespace halfspace
