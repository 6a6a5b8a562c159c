// The angle between a line and a plane: that of the line with its shadow on the plane, by the sine, as the
// plane is known by its normal.
#include "geometry/angle.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/acute_angle.h"
#include "lessons/construction/taught.h"
#include "lessons/object/flat.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/term/angle.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<PlaneObject> E;
};

struct Out : Computed<In>, LineTerms, PlaneTerms {
  explicit Out(const In &objects)
      : Computed(objects), LineTerms(termsOf(objects.g)), PlaneTerms(termsOf(objects.E)) {}

  const ExactVec3 &normal = in.E.object.normal;
  const ExactVec3 &direction = in.g.object.direction;
  AcuteAngle<Rational> toNormal = measureAcuteAngle(normal, direction);
  LinePlane<Rational> meet =
      intersectLinePlane(lineAlong(in.g.object.point, direction), planeThrough(in.E.object.point, normal));
  bool hasAngle = toNormal.which != AcuteAngleCase::ZeroVector;
  bool isRight = toNormal.which == AcuteAngleCase::Parallel;

  Term alpha = ownName(letter("α"), std::nullopt).marked(mark("alpha"));
  Term sine = applied(word("sin"), alpha, toNormal.cosine);

  /// The cosine of α is the sine of the angle to the normal.
  [[nodiscard]] WrittenNumber degrees() const { return degreesOf(Term(toNormal.sine)); }
};

CaseWords tell(const Out &at) {
  switch (at.toNormal.which) {
  case AcuteAngleCase::Perpendicular:
    return {"parallel", at.meet.which == LinePlaneCase::InPlane
                            ? words("{g} lies in {E}: the angle is 0°.", at.letters)
                            : words("{g} is parallel to {E}: the angle is 0°.", at.letters)};
  case AcuteAngleCase::Parallel:
    return {"perpendicular", words("{v} is a multiple of {n}: {g} meets {E} at a right angle.", at.letters)};
  case AcuteAngleCase::Oblique:
    return {"oblique", words("{g} meets {E} at the angle α{degrees}°.", at.letters,
                             {{"degrees", relatedText(at.degrees())}})};
  case AcuteAngleCase::ZeroVector:
    break;
  }
  return isZero(at.normal) ? zeroNormalWords(at) : zeroLineWords(at, "zero-direction");
}

std::string productWords(const Out &at) {
  return at.toNormal.product == 0
             ? words("Zero: {v} is perpendicular to {n}, so it runs along the plane.", at.letters)
             : words("Not 0: {v} leads out of the plane. On which side does not matter to the angle.",
                     at.letters);
}

std::string sineWords(const Out &at) {
  return words("α{degrees}°: the angle between {g} and {E}. With {n} the line has the angle 90° − α, whose "
               "cosine this is.",
               at.letters, {{"degrees", relatedText(at.degrees())}});
}

/// The direction and its shadow from the common point; a line straight along the normal has none, and any
/// direction of the plane is at a right angle to it.
Figure draw(const Out &at) {
  Figure figure;
  if (at.meet.which != LinePlaneCase::Point)
    return figure;
  const Place point = place(at.meet.point);
  const ExactVec3 shadow =
      at.isRight ? anyPerpendicular(at.normal) : projectVector(at.direction, at.normal).rejection;
  addAngle(figure, {at.alpha, at.degrees(), at.isRight}, point, {place(at.v), Subject::Ray, at.in.g.look},
           {place(shadow), Subject::Plane, at.in.E.look});
  figure.reaches = {{at.in.g.id, point}, {at.in.E.id, point}};
  return figure;
}

/// The plane turned about its point, and not the line, which may be made by others.
std::vector<SpecialCase> nearby(const Out &at) {
  if (at.toNormal.which != AcuteAngleCase::Oblique)
    return {};
  const auto parts = projectVector(at.normal, at.direction);
  const ExactVec3 &point = at.in.E.object.point;
  return {{is("case", "perpendicular"), words("The line would meet the plane at a right angle."), "E",
           PlaneObject{point, parts.projection}},
          {is("case", "parallel"), words("The angle of the line with the plane would be 0°."), "E",
           PlaneObject{point, parts.rejection}}};
}

} // namespace

Construction line_plane_angle() {
  return taught<Out, LineObject, PlaneObject>(
      {.id = "line-plane-angle",
       .word = "angle",
       .title = [] { return words("angle of line and plane"); },
       .roles = {"g", "E"},
       .letters = {"α"},
       .cases = {"parallel", "oblique", "perpendicular", "zero-direction", "zero-normal"},
       .values = {{named::number("dot"), &Out::hasAngle, [](const Out &at) { return dot(at.n, at.v); }},
                  {named::number("sine"), &Out::hasAngle, &Out::sine}},
       .lines = {{"dot", &Out::hasAngle, [](const Out &at) { return withProducts(dot(at.n, at.v)); },
                  productWords},
                 {"length-n", &Out::hasAngle, [](const Out &at) { return lengthLine(at.n); }},
                 {"length-v", &Out::hasAngle, [](const Out &at) { return lengthLine(at.v); }},
                 {"angle", &Out::hasAngle,
                  [](const Out &at) { return acuteLine(at.sine, at.n, at.v, sineWords(at)); }}},
       .marks = {"alpha"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
