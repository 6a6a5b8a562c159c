#include "lessons/object/kinds/plane.h"

#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// How long the normal is drawn of a plane that follows others, where only its direction was meant.
constexpr double drawnNormal = 2.5;

ArrowMark normalOf(const Given<Object> &given) {
  ArrowMark normal = arrowMark(given, 1, Subject::Plane);
  if (!given.isFree)
    normal.drawnLength = drawnNormal;
  return normal;
}

std::vector<Mark> draw(const Given<Object> &given) {
  const Given<PlaneObject> plane = as<PlaneObject>(given);
  const auto &[point, normal] = plane.object;
  std::vector<Mark> marks;
  if (!isZero(normal)) {
    MarkBase patch = wholeOf(given, Subject::Plane);
    patch.numbers = "\\colon\\ {" + latexOf(equationOf(termsOf(plane))) + "}";
    marks.push_back(PlanePatchMark{std::move(patch), place(point), place(normal), {}});
    marks.push_back(normalOf(given));
  }
  marks.push_back(pointMark(given, 0, Subject::Plane));
  return marks;
}

/// The knob that moves the plane along its normal; a zero normal points nowhere, so there is none.
std::vector<Handle> ownHandles(const std::string &name, const Object &plane) {
  if (isZero(plane[1]))
    return {};
  Handle handle;
  handle.id = name + ".offset";
  handle.object = name;
  handle.motion = Handle::Motion::AlongNormal;
  handle.at = plane[0];
  handle.axis = plane[1];
  return {handle};
}

void offer(const Given<Object> &given, Surroundings &found) {
  if (!isZero(given.object[1]))
    found.planes.push_back({given.object[0], given.object[1], plainText(given.symbol)});
}

void aim(const Given<Object> &, const Handle &handle, const Surroundings &found,
         std::vector<SnapTarget> &targets) {
  if (handle.motion == Handle::Motion::AlongNormal)
    return aimOffset(found, handle.axis, targets);
  if (handle.coordinate != 1)
    return;
  aimAlongAxes(handle.base, targets);
  aimNormal(found, handle.base, targets);
}

} // namespace

PlaneTerms termsOf(const Given<PlaneObject> &plane) {
  return {coordinateTerm(plane, 0), coordinateTerm(plane, 1)};
}

Chain equationOf(const PlaneTerms &plane) {
  return condition(calculated(dot(plane.n, anyPoint() - plane.P0)) == 0);
}

namespace object_kinds {

Kind plane() {
  return {.word = PlaneObject::kind,
          .noun = [] { return words("a plane"); },
          .meaning = "a plane by a point of it and its normal",
          .subject = Subject::Plane,
          .coordinates = {{"P0", CoordinateRole::Position}, {"n", CoordinateRole::Direction}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offer,
          .aim = aim};
}

} // namespace object_kinds
} // namespace halfspace
