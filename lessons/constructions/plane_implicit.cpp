// The implicit equation of a plane: 0 = n·(P − P0), numbers put in, expanded, collected, normalized (note PG
// 1 and 3).
#include "geometry/point_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/given.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"
#include "lessons/worked_lines.h"

namespace halfspace {
namespace {

struct In {
  PlaneObject E;
};

struct Out {
  Plane<Rational> plane;
  bool zeroNormal = false;
  Surd length;                  // |n|
  std::vector<Surd> primitive;  // a, b, c, d in integers without a common factor
  std::vector<Surd> normalized; // divided by |n|
  Surd originDistance;          // of the origin, signed
  ExactVec3 otherPoint;         // a second point P1 of the plane
};

/// A vector in the plane with short coordinates, for n ≠ 0.
ExactVec3 vectorInPlane(const ExactVec3 &n) {
  if (n.x == 0 && n.y == 0)
    return {2, 0, 0};
  return {n.y, Rational(-n.x), 0};
}

Out compute(const In &in) {
  Out out;
  out.plane = planeThrough(in.E.point, in.E.normal);
  out.zeroNormal = isZero(in.E.normal);
  if (out.zeroNormal)
    return out;
  out.length = Surd::root(dot(in.E.normal, in.E.normal));
  for (const Integer &integer : primitiveCoefficients(out.plane))
    out.primitive.emplace_back(Rational(integer));
  for (const Surd &coefficient : normalizedCoefficients(out.plane))
    out.normalized.push_back(coefficient);
  out.originDistance = measurePointPlane(ExactVec3(0), out.plane).signedDistance;
  out.otherPoint = in.E.point + vectorInPlane(in.E.normal);
  return out;
}

CaseWords tell(const In &in, const Out &out) {
  if (out.zeroNormal)
    return {"zero-normal", words("The normal n is the zero vector: it points nowhere, so there is no plane."),
            true};
  return {"plane", words("A point P lies in the plane exactly when {equation}.",
                         {{"equation", plainText(equationOf(in.E))}})};
}

std::vector<NamedValue> list(const In &, const Out &out) {
  const auto &plane = out.plane;
  std::vector<NamedValue> values{
      {"coefficients", halfspace::list({unknown("a"), unknown("b"), unknown("c"), unknown("d")}),
       std::vector<Surd>{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}}};
  if (out.zeroNormal)
    return values;
  values.push_back({"primitive", words("in lowest integers"), out.primitive});
  values.push_back({"normalized", words("normalized"), out.normalized});
  values.push_back({"origin_distance", words("signed distance of the origin"), out.originDistance});
  return values;
}

/// The letters of the lines.
struct Letters : PlaneTerms {
  Term P, P1, d;
  Term left; ///< of the equation: n·(P − P0)
};

/// `vectorInPlane` as it follows from n.
Term inPlane(const ExactVec3 &normal, const Term &n) {
  if (normal.x == 0 && normal.y == 0)
    return halfspace::list({2, 0, 0});
  return cross(n, halfspace::list({0, 0, 1}));
}

Letters lettersOf(const In &in, const Out &out) {
  const PlaneTerms E = termsOf(in.E, "E");
  const Term P = anyPoint();
  return {E, P,
          name(letter("P", "1"), out.otherPoint).standingFor(E.P0 + inPlane(in.E.normal, E.n)).marked("P1"),
          name(letter("d"), out.plane.offset).standingFor(-dot(E.n, E.P0)), dot(E.n, P - E.P0)};
}

/// ax + by + cz + d, in letters only.
Term generalForm(const Term &d) {
  const auto summand = [](const char *coefficient, const char *variable) {
    return unknown(coefficient) * unknown(variable);
  };
  return summand("a", "x") + summand("b", "y") + summand("c", "z") + d;
}

WorkingLine implicitLine(const Letters &at) {
  return line("implicit", {condition(0 == at.left)},
              words("A vector from P₀ to another point of the plane is perpendicular to n. So P lies in the "
                    "plane exactly when this dot product is zero."));
}

WorkingLine insertLine(const Letters &at) {
  return line("insert", {condition(Chain(0).then(namesPutIn(at.left)).then(numbersPutIn(at.left)))},
              words("The numbers put in, with P = (x, y, z)."));
}

WorkingLine expandLine(const Letters &at) {
  return line("expand", {condition(Chain(0).then(multipliedOut(at.left)))},
              words("The dot product multiplied out, coordinate by coordinate."));
}

WorkingLine collectLine(const Letters &at) {
  const Chain collected = Chain(0)
                              .then(calculated(dot(at.n, at.P)) - multipliedOut(dot(at.n, at.P0)))
                              .then(calculated(at.left).marked("E"));
  const Term coordinateSum = sum(calculated(at.P0)->parts);
  return askedFor(
      at.d == -dot(at.n, at.P0), generalForm(at.d),
      line("collect", {condition(collected)},
           words("Collected: the numbers before x, y and z are the coordinates of n, and the constant is "
                 "−n·P₀.")),
      {{dot(at.n, at.P0), words("{answer} is n·P₀: the minus sign of P − P₀ is lost.")},
       {coordinateSum,
        words("{answer} only adds up the coordinates of P₀: each is multiplied by that of n first.")},
       {at.d / norm(at.n),
        words("{answer} belongs to the normalized equation: here nothing is divided by |n|.")}});
}

WorkingLine constantLine(const Letters &at) {
  return asked(line("constant", {withProducts(dot(at.n, at.P1))},
                    words("{point} is another point of the plane. It gives the same number as P₀, so the "
                          "constant does not depend on the point you start from.",
                          {{"point", equation(at.P1)}})));
}

std::string normalizedWords(const Letters &at, const Out &out) {
  if (out.length == Surd(1))
    return words("|n| is 1: the equation is normalized already, so its left side gives distances.");
  return words(
      "Divided by the length of the normal, {length}: the normalized form. The plane is the same, and "
      "the left side now gives distances.",
      {{"length", equation(norm(at.n))}});
}

WorkingLine normalizedLine(const Letters &at, const Out &out) {
  const Chain divided =
      Chain(0).then(calculated(at.left) / calculated(norm(at.n))).then(calculated(at.left / norm(at.n)));
  return askedFor(at.d / norm(at.n) == at.d / norm(at.n), generalForm(at.d) / norm(at.n),
                  line("normalized", {condition(divided)}, normalizedWords(at, out)),
                  {{at.d, words("{answer} is not normalized: d is divided by |n| as well.")},
                   {at.d / dot(at.n, at.n), words("{answer} is divided by n·n: divide by its root, |n|.")}});
}

WorkingLine scaledLine(const Letters &at) {
  const Term twice = dot((2 * at.n).marked("kn"), at.P - at.P0);
  return line(
      "scaled", {condition((0 == twice).then(calculated(twice)))},
      words("Twice the normal doubles every number and changes nothing: the same points make it zero."));
}

Working explain(const In &in, const Out &out) {
  const Letters at = lettersOf(in, out);
  if (out.zeroNormal)
    return {{implicitLine(at), insertLine(at)}};
  return {{implicitLine(at), insertLine(at), expandLine(at), collectLine(at), constantLine(at),
           normalizedLine(at, out), scaledLine(at)}};
}

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const Place point = place(in.E.point);
  const Place normal = place(in.E.normal);
  const Place other = place(out.otherPoint);
  drawPlane(figure, in.E, out.zeroNormal ? std::vector<Place>{} : std::vector<Place>{other});
  if (out.zeroNormal)
    return figure;
  figure.marks.push_back(SegmentMark{{"P1-way", Role::Helper, Subject::Neutral, ""}, point, other});
  figure.marks.push_back(PointMark{{"P1", Role::Derived, Subject::Plane, "P_1"}, other});
  figure.marks.push_back(
      RightAngleMark{{"P1-angle", Role::Helper, Subject::Neutral, ""}, point, normal, other - point});
  figure.marks.push_back(ArrowMark{{"kn", Role::Ghost, Subject::Plane, "2\\vec n"}, point + normal, normal});
  return figure;
}

} // namespace

Construction plane_implicit() {
  return makeConstruction<In, Out>("plane-implicit", compute, tell, list, explain, draw,
                                   TypedRole<In, PlaneObject>{"E", &In::E});
}

} // namespace halfspace
