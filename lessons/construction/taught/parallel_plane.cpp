// The plane through a point that is parallel to another one: the same normal, another constant.
#include "geometry/point_plane.h"
#include "lessons/construction/parts/made_plane.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PointObject> Q;
};

Surd size(const Surd &number) { return number.sign() < 0 ? -number : number; }

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  PointPlane<Rational> measured = measurePointPlane(in.Q.object.at, planeOf(in.E.object));
  bool hasPlane = measured.which != PointPlaneCase::ZeroNormal;
  bool isApart = hasPlane && measured.which != PointPlaneCase::On;

  PlaneTerms E = termsOf(in.E);
  Term Q = termOf(in.Q);
  PlaneTerms F = madePlane(*this, "F", Q, in.E.object.normal);
  Term d = ownName(letter("d"), planeOf(planeOf(F)).offset);
  Term f = applied(own(letter("f")), Q, measured.f);
  Term H = drawnName(letter("H"), measured.foot); ///< of Q on E
  Term dist = ownName(word("dist"), size(measured.signedDistance)).marked(mark("distance"));
};

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return zeroNormalWords(at);
  if (!at.isApart)
    return {"same",
            words("{Q} lies in {E}: the plane through {Q} with the same normal is {E} itself.", at.letters)};
  return {"parallel",
          words("{F} goes through {Q} and is parallel to {E}: {distance} from plane to plane.", at.letters,
                {{"distance", equation(name(word(words("distance")), at.dist->value))}})};
}

WorkingLine heightLine(const Out &at) {
  return asked(
      withNumbers(at.f == dot(at.E.n, at.Q - at.E.P0)),
      at.isApart
          ? words("{Q} put into the equation of {E}: not 0, so {E} does not go through {Q}.", at.letters)
          : words("{Q} put into the equation of {E}: 0, so {E} goes through {Q}.", at.letters));
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers(at.dist == norm(at.f) / norm(at.E.n)),
               words("All points of {F} are as far from {E} as {Q} is.", at.letters),
               {{norm(at.f), words("{answer} is |f({Q})|: divide by |{E.n}|.", at.letters)}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  addMadePlane(figure, at, "F", at.F);
  figure.reaches = {{at.in.E.id, place(at.H)}};
  figure.add(pointOf(at.H, Role::Derived, Subject::Plane));
  if (at.isApart)
    figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), place(at.Q), place(at.H)});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.isApart)
    return {};
  return {{is("case", "same"), words("{Q} would lie in {E}, and {F} would be {E}.", at.letters), "Q",
           PointObject{at.measured.foot}}};
}

} // namespace

Construction parallel_plane() {
  return taught<Out, PlaneObject, PointObject>(
      {.id = "parallel-plane",
       .title = [] { return words("parallel plane through the point"); },
       .roles = {"E", "Q"},
       .makes = {{"F", PlaneObject::kind, &Out::hasPlane, [](const Out &at) { return planeOf(at.F); }}},
       .letters = {"d", "f", "H", "dist"},
       .cases = {"parallel", "same", "zero-normal"},
       .values = {{named::list("coefficients", 4), &Out::hasPlane,
                   [](const Out &at) { return coefficientsValue(at.F); }},
                  {named::number("f"), &Out::hasPlane, &Out::f},
                  {named::vector("foot"), &Out::hasPlane, &Out::H},
                  {named::number("distance"), &Out::hasPlane, &Out::dist}},
       .lines =
           {{"normal", &Out::hasPlane,
             [](const Out &at) {
               return line(withNumbers(at.F.n == at.E.n),
                           words("Parallel planes have a normal in common.", at.letters));
             }},
            {"d", &Out::hasPlane,
             [](const Out &at) {
               return constantLine(at.d, at.F, words("So that {Q} fulfils the equation.", at.letters));
             }},
            {"equation", &Out::hasPlane, [](const Out &at) { return equationLine(at, "F", at.F, at.d); }},
            {"f", &Out::hasPlane, heightLine},
            {"foot", &Out::hasPlane,
             [](const Out &at) { return withNumbers(at.H == at.Q - at.f / dot(at.E.n, at.E.n) * at.E.n); },
             says("From {Q} straight along {E.n}: the point of {E} that is nearest to {Q}.")},
            {"distance", &Out::hasPlane, distanceLine}},
       .marks = {"F", "F.n", "F.P0", "H", "distance"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
