// The implicit equation of a plane: 0 = n·(P − P0), numbers put in, expanded, collected, normalized (note PG
// 1 and 3).
#include "geometry/point_plane.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In {
  PlaneObject E;
};

struct Out : PlaneTerms {
  Plane<Rational> plane;
  bool zeroNormal;
  Term P, P1; ///< any point of space, a second one of the plane
  Term left;  ///< of the equation: n·(P − P0)
};

/// A vector in the plane with short coordinates, for n ≠ 0.
Term vectorInPlane(const ExactVec3 &normal, const Term &n) {
  if (normal.x == 0 && normal.y == 0)
    return list({2, 0, 0});
  return cross(n, list({0, 0, 1}));
}

Out compute(const In &in) {
  const PlaneTerms E = termsOf(in.E, "E");
  const auto plane = planeThrough(in.E.point, in.E.normal);
  const Term second = E.P0 + vectorInPlane(in.E.normal, E.n);
  return {E,
          plane,
          isZero(in.E.normal),
          anyPoint(),
          name(letter("P", "1"), second->value).standingFor(second).marked("P1"),
          dot(E.n, anyPoint() - E.P0)};
}

CaseWords tell(const In &in, const Out &at) {
  if (at.zeroNormal)
    return zeroNormalWords();
  return {"plane", words("A point P lies in the plane exactly when {equation}.",
                         {{"equation", plainText(equationOf(in.E))}})};
}

std::vector<NamedValue> valuesOf(const Out &at) {
  const auto &plane = at.plane;
  std::vector<NamedValue> values{
      {"coefficients", list({unknown("a"), unknown("b"), unknown("c"), unknown("d")}),
       std::vector<Surd>{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}}};
  if (at.zeroNormal)
    return values;
  std::vector<Surd> primitive;
  for (const Integer &integer : primitiveCoefficients(plane))
    primitive.emplace_back(Rational(integer));
  const auto normalized = normalizedCoefficients(plane);
  values.push_back({"primitive", words("in lowest integers"), primitive});
  values.push_back({"normalized", words("normalized"), std::vector(normalized.begin(), normalized.end())});
  values.push_back({"origin_distance", words("signed distance of the origin"),
                    measurePointPlane(ExactVec3(0), plane).signedDistance});
  return values;
}

WorkingLine collectLine(const Out &at) {
  const Chain collected = (0 == at.left)
                              .then(calculated(dot(at.n, at.P)) - multipliedOut(dot(at.n, at.P0)))
                              .then(calculated(at.left).marked("E"));
  const Term onlyAdded = sum(calculated(at.P0)->parts);
  return askedEquation(
      "collect", condition(collected),
      words("Collected: the numbers before x, y and z are the coordinates of n, and the constant is −n·P₀."),
      {{dot(at.n, at.P) + dot(at.n, at.P0),
        words("In {answer} the constant is n·P₀: the minus sign of P − P₀ is lost.")},
       {dot(at.n, at.P) - onlyAdded, words("In {answer} the coordinates of P₀ are only added up: each is "
                                           "multiplied by that of n first.")}});
}

std::string normalizedWords(const Out &at) {
  if (isUnit(at.n))
    return words("|n| is 1: the equation is normalized already, so its left side gives distances.");
  return words(
      "Divided by the length of the normal, {length}: the normalized form. The plane is the same, and "
      "the left side now gives distances.",
      {{"length", equation(norm(at.n))}});
}

WorkingLine normalizedLine(const Out &at) {
  const Term unit = at.left / norm(at.n);
  return asked(
      "normalized",
      condition((0 == unit).then(calculated(at.left) / calculated(norm(at.n))).then(calculated(unit))),
      normalizedWords(at),
      {{at.left, words("{answer} is not normalized: every number is divided by |n|.")},
       {at.left / dot(at.n, at.n), words("{answer} is divided by n·n: divide by its root, |n|.")}});
}

WorkingLine scaledLine(const Out &at) {
  const Term twice = dot((2 * at.n).marked("kn"), at.P - at.P0);
  return line(
      "scaled", condition((0 == twice).then(calculated(twice))),
      words("Twice the normal doubles every number and changes nothing: the same points make it zero."));
}

Working explain(const Out &at) {
  const Chain implicit = 0 == at.left;
  Working working{
      {line("implicit", condition(implicit),
            words("A vector from P₀ to another point of the plane is perpendicular to n. So P lies in the "
                  "plane exactly when this dot product is zero.")),
       line("insert", condition(Chain(0).then(namesPutIn(at.left)).then(numbersPutIn(at.left))),
            words("The numbers put in, with P = (x, y, z)."))}};
  if (at.zeroNormal)
    return working;
  working.add(askedEquation("expand", condition(implicit.then(multipliedOut(at.left))),
                            words("The dot product multiplied out, coordinate by coordinate.")));
  working.add(collectLine(at));
  working.add(asked("constant", withProducts(dot(at.n, at.P1)),
                    words("{point} is another point of the plane. It gives the same number as P₀, so the "
                          "constant does not depend on the point you start from.",
                          {{"point", equation(at.P1)}})));
  working.add(normalizedLine(at));
  working.add(scaledLine(at));
  return working;
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Place point = place(at.P0);
  const Place normal = place(at.n);
  const Place other = place(at.P1);
  drawPlane(figure, in.E, at.zeroNormal ? std::vector<Place>{} : std::vector<Place>{other});
  if (at.zeroNormal)
    return figure;
  figure.add(SegmentMark{{"P1-way", Role::Helper}, point, other});
  figure.add(pointOf(at.P1, Role::Derived, Subject::Plane));
  figure.add(RightAngleMark{{"P1-angle", Role::Helper}, point, normal, other - point});
  figure.add(ArrowMark{{"kn", Role::Ghost, Subject::Plane, "2\\vec n"}, point + normal, normal});
  return figure;
}

} // namespace

Construction plane_implicit() {
  return makeConstruction<In, Out>("plane-implicit", compute, tell, valuesOf, explain, draw,
                                   TypedRole<In, PlaneObject>{"E", &In::E});
}

} // namespace halfspace
