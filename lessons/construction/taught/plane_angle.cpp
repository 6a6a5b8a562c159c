// The angle at which two planes meet, by their normals.
#include "geometry/angle.h"
#include "geometry/intersect_planes.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/acute_angle.h"
#include "lessons/construction/parts/two_planes.h"
#include "lessons/construction/taught.h"
#include "lessons/term/angle.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  AcuteAngle<Rational> angle = measureAcuteAngle(in.E.object.normal, in.F.object.normal);
  PlanePlane<Rational> meet = intersectPlanes(planeThrough(in.E.object.point, in.E.object.normal),
                                              planeThrough(in.F.object.point, in.F.object.normal));
  bool hasAngle = angle.which != AcuteAngleCase::ZeroVector;
  bool isRight = angle.which == AcuteAngleCase::Perpendicular;

  PlaneTerms E = termsOf(in.E);
  PlaneTerms F = termsOf(in.F);
  Term phi = ownName(letter("φ"), std::nullopt).marked(mark("phi"));
  Term cosine = applied(word("cos"), phi, angle.cosine);

  [[nodiscard]] WrittenNumber degrees() const { return degreesOf(cosine); }
};

CaseWords tell(const Out &at) {
  switch (at.angle.which) {
  case AcuteAngleCase::Parallel:
    return {"parallel", at.meet.which == PlanePlaneCase::Coincident
                            ? words("{E} and {F} are the same plane: the angle is 0°.", at.letters)
                            : words("{E} and {F} are parallel: the angle is 0°.", at.letters)};
  case AcuteAngleCase::Perpendicular:
    return {"perpendicular",
            words("{E.n}·{F.n} = 0: {E} and {F} stand at a right angle to each other.", at.letters)};
  case AcuteAngleCase::Oblique:
    return {"oblique",
            words("The planes {E} and {F} meet at the angle φ{degrees}°, and on the other side at 180° − φ.",
                  at.letters, {{"degrees", relatedText(at.degrees())}})};
  case AcuteAngleCase::ZeroVector:
    break;
  }
  return zeroNormalsWords(at.E, at.F);
}

std::string productWords(const Out &at) {
  const int sign = at.angle.product.sign();
  return sign > 0   ? words("Positive: the normals are less than 90° apart.")
         : sign < 0 ? words("Negative: the normals are more than 90° apart. The angle of the planes is at "
                            "most 90°, so the sign will be left out.")
                    : words("Zero: the normals are perpendicular to each other, and so are the planes.");
}

std::string cosineWords(const Out &at) {
  return at.angle.product < 0 ? words("φ{degrees}°: the angle of the planes. The normals are 180° − φ apart.",
                                      {{"degrees", relatedText(at.degrees())}})
                              : words("φ{degrees}°: the angle of the planes, and of the normals.",
                                      {{"degrees", relatedText(at.degrees())}});
}

/// The normals from a point of the common line, that of F turned round where they are more than 90° apart.
Figure draw(const Out &at) {
  Figure figure;
  if (at.meet.which != PlanePlaneCase::Line)
    return figure;
  const Place point = place(at.meet.nearest);
  const Place second = at.angle.product < 0 ? -place(at.F.n) : place(at.F.n);
  addAngle(figure, {at.phi, at.degrees(), at.isRight}, point, {place(at.E.n), Subject::Plane, at.in.E.look},
           {second, Subject::Plane, at.in.F.look});
  figure.add(
      LineMark{{at.phi->mark + "/line", Role::Helper, Subject::Ray}, point, unitOf(at.meet.line.direction)});
  figure.reaches = {{at.in.E.id, point}, {at.in.F.id, point}};
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (at.angle.which != AcuteAngleCase::Oblique)
    return {};
  const auto &[point, normal] = at.in.E.object;
  const auto parts = projectVector(normal, at.in.F.object.normal);
  return {{is("case", "perpendicular"), words("The planes would stand at a right angle to each other."), "E",
           PlaneObject{point, parts.rejection}},
          {is("case", "parallel"), words("The angle of the planes would be 0°."), "E",
           PlaneObject{point, parts.projection}}};
}

} // namespace

Construction plane_angle() {
  return taught<Out, PlaneObject, PlaneObject>(
      {.id = "plane-angle",
       .word = "angle",
       .title = [] { return words("angle of the planes"); },
       .roles = {"E", "F"},
       .letters = {"φ"},
       .cases = {"parallel", "oblique", "perpendicular", "zero-normal"},
       .values = {{named::number("dot"), &Out::hasAngle, [](const Out &at) { return dot(at.E.n, at.F.n); }},
                  {named::number("cosine"), &Out::hasAngle, &Out::cosine}},
       .lines = {{"dot", &Out::hasAngle, [](const Out &at) { return withProducts(dot(at.E.n, at.F.n)); },
                  productWords},
                 {"length-E", &Out::hasAngle, [](const Out &at) { return lengthLine(at.E.n); }},
                 {"length-F", &Out::hasAngle, [](const Out &at) { return lengthLine(at.F.n); }},
                 {"angle", &Out::hasAngle,
                  [](const Out &at) { return acuteLine(at.cosine, at.E.n, at.F.n, cosineWords(at)); }}},
       .marks = {"phi"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
