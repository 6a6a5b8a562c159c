// The mirror image of a point in a plane: as far behind it as the point is before it, on the line through the
// point and its foot.
#include "geometry/case_names.h"
#include "geometry/reflect_vector.h"
#include "lessons/construction/parts/point_at_plane.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

/// Of a plane with a normal; where there is none, nothing is mirrored.
ExactVec3 imageOf(const ExactVec3 &point, const PlaneObject &plane) {
  if (isZero(plane.normal))
    return point;
  return plane.point + reflectVector(ExactVec3(point - plane.point), plane.normal);
}

struct Out : MeasuredPoint {
  explicit Out(const PointAtPlane &objects) : MeasuredPoint(objects) {}

  Term S = madeName("S", imageOf(in.Q.object.at, in.E.object));
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.which));
  switch (at.which) {
  case PointPlaneCase::Positive:
    return {caseName, words("{Q} lies on the side that {n} points to, and its mirror image {S} lies as far "
                            "from the plane on the other side.",
                            at.letters)};
  case PointPlaneCase::Negative:
    return {caseName,
            words("{Q} lies on the side that {n} points away from, and its mirror image {S} lies as "
                  "far from the plane on the other side.",
                  at.letters)};
  case PointPlaneCase::On:
    return {caseName, words("{Q} lies in the plane, and is its own mirror image.", at.letters)};
  case PointPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

std::string imageWords(const Out &at) {
  return at.which == PointPlaneCase::On
             ? words("The mirror image is {Q} itself: f({Q}) is 0.", at.letters)
             : words("The mirror image: from {Q} through the foot, and as far again.", at.letters);
}

WorkingLine imageLine(const Out &at) {
  const Term times = at.f / dot(at.n, at.n);
  return asked(withNumbers(at.S == at.Q - 2 * times * at.n), imageWords(at),
               {{at.Q - times * at.n, words("{answer} is the foot: go on as far again behind the plane.")},
                {at.Q + 2 * times * at.n,
                 words("{answer} is three times as far from the plane as {Q}: take the multiple of {n} away.",
                       at.letters)},
                {at.Q - 2 * at.f * at.n,
                 words("{answer} is right only when |{n}| = 1: divide by {n}·{n}.", at.letters)},
                {-at.Q, words("{answer} is {Q} mirrored in the origin, a point.", at.letters)}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  figure.reaches.push_back({at.in.E.id, place(at.F)});
  figure.add(pointOf(at.F, Role::Derived, Subject::Measure));
  figure.add(pointOf(at.S, Role::Result, Subject::Point));
  if (at.which == PointPlaneCase::On)
    return figure;
  drawDistance(figure, at);
  figure.add(SegmentMark{{at.S->mark + "/way", Role::Helper, Subject::Measure}, place(at.F), place(at.S)});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.hasPlane || at.which == PointPlaneCase::On)
    return {};
  return {{is("case", nameOf(PointPlaneCase::On)),
           words("{Q} would lie in the plane, and be its own mirror image.", at.letters), "Q",
           PointObject{at.measured.foot}}};
}

} // namespace

Construction mirror_point() {
  return taught<Out, PlaneObject, PointObject>(
      {.id = "mirror-point",
       .word = "mirror",
       .title = [] { return words("mirror image"); },
       .roles = {"E", "Q"},
       .makes = {{"F", &Out::hasPlane, &Out::F}, {"S", &Out::hasPlane, &Out::S}},
       .letters = {"f", "dist"},
       .cases = {"positive", "negative", "on", "zero-normal"},
       .values = {{named::number("f"), always, &Out::f},
                  {named::number("signed_distance"), &Out::hasPlane, &Out::dist},
                  {named::vector("foot"), &Out::hasPlane, &Out::F},
                  {named::vector("image"), &Out::hasPlane, &Out::S}},
       .lines = {{"f", always, valueLine},
                 {"distance", &Out::hasPlane, distanceLine},
                 {"foot", &Out::hasPlane, footLine},
                 {"image", &Out::hasPlane, imageLine},
                 {"middle", &Out::hasPlane,
                  [](const Out &at) { return withNumbers(at.F == (at.Q + at.S) / 2); },
                  says("The foot once more: it is the midpoint of {Q} and {S}.")}},
       .marks = {"F", "S", "distance"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
