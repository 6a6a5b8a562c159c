// The implicit equation of a plane: 0 = n·(P − P0), numbers put in, expanded, collected, normalized (note PG
// 1 and 3).
#include "geometry/point_plane.h"
#include "lessons/construction.h"
#include "lessons/drawing.h"
#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

struct In {
  PlaneObject E;
};

struct Out {
  Plane<Rational> plane;
  bool zeroNormal = false;
  Rational constant;              // n·P0
  Rational coordinateSum;         // of P0: what is left when n is forgotten
  Rational normalSquared;         // n·n
  Surd length;                    // |n|
  std::vector<Surd> coefficients; // a, b, c, d
  std::vector<Surd> primitive;    // the same in integers without a common factor
  std::vector<Surd> normalized;   // divided by |n|
  Rational dividedBySquare;       // d/(n·n)
  Surd originDistance;            // of the origin, signed
  ExactVec3 otherPoint;           // a second point P1 of the plane
  Rational otherConstant;         // n·P1
  Plane<Rational> scaled;         // by kn, k = scale
};

/// The k of "k·n gives the same plane".
const Rational scale = 2;

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
  out.constant = dot(in.E.normal, in.E.point);
  out.coordinateSum = in.E.point.x + in.E.point.y + in.E.point.z;
  out.normalSquared = dot(in.E.normal, in.E.normal);
  out.coefficients = coefficientsOf(out.plane);
  if (out.zeroNormal)
    return out;
  out.length = Surd::root(out.normalSquared);
  for (const Integer &integer : primitiveCoefficients(out.plane))
    out.primitive.emplace_back(Rational(integer));
  for (const Surd &coefficient : normalizedCoefficients(out.plane))
    out.normalized.push_back(coefficient);
  out.dividedBySquare = out.plane.offset / out.normalSquared;
  out.originDistance = measurePointPlane(ExactVec3(0), out.plane).signedDistance;
  out.otherPoint = in.E.point + vectorInPlane(in.E.normal);
  out.otherConstant = dot(in.E.normal, out.otherPoint);
  out.scaled = planeThrough(in.E.point, ExactVec3(in.E.normal * scale));
  return out;
}

CaseWords tell(const In &, const Out &out) {
  if (out.zeroNormal)
    return {"zero-normal", words("The normal n is the zero vector: it points nowhere, so there is no plane."),
            true};
  return {"plane", words("A point P lies in the plane exactly when {equation}.",
                         {{"equation", plainText(planeEquation(out.coefficients))}})};
}

std::vector<NamedValue> list(const Out &out) {
  std::vector<NamedValue> values{{"coefficients", "(a,b,c,d)", out.coefficients}};
  if (out.zeroNormal)
    return values;
  values.push_back({"primitive", "\\text{in lowest integers}", out.primitive});
  values.push_back({"normalized", "\\text{normalized}", out.normalized});
  values.push_back({"origin_distance", "\\text{signed distance of the origin}", out.originDistance});
  return values;
}

const std::string n = marked("n", "\\vec n");
const std::string P0 = marked("P0", "P_0");
const std::string P1 = marked("P1", "P_1");

/// x − 5, x + 5 or x
std::string difference(Formula &f, const char *variable, const Rational &value) {
  return variable + f.addend(Rational(-value));
}

std::string expanded(Formula &f, const PlaneObject &plane) {
  const std::array<std::string, 3> variables{"x", "y", "z"};
  std::string sum;
  for (int i = 0; i < 3; ++i)
    sum += (sum.empty() ? "" : " + ") + f.factor(plane.normal[i]) + "(" +
           difference(f, variables[static_cast<std::size_t>(i)].c_str(), plane.point[i]) + ")";
  return sum;
}

WorkingLine implicitLine() {
  return {"implicit", "0 = " + n + "\\cdot(P - " + P0 + ")", "", "",
          words("A vector from P₀ to another point of the plane is perpendicular to n. So P lies in the "
                "plane exactly when this dot product is zero.")};
}

WorkingLine insertLine(const In &in) {
  Formula f;
  const std::string normal = f(in.E.normal);
  const std::string inserted = f.equals(normal + "\\cdot\\bigl((x,\\,y,\\,z) - " + f(in.E.point) + "\\bigr)");
  Formula g;
  const std::string variables = "\\left(" + difference(g, "x", in.E.point.x) + ",\\," +
                                difference(g, "y", in.E.point.y) + ",\\," + difference(g, "z", in.E.point.z) +
                                "\\right)";
  const std::string subtracted = g.equals(g(in.E.normal) + "\\cdot " + variables);
  return {"insert", "0", inserted, subtracted, words("The numbers put in, with P = (x, y, z).")};
}

WorkingLine expandLine(const In &in) {
  Formula f;
  const std::string sum = expanded(f, in.E);
  return {"expand", "0", f.equals(sum), "",
          words("The dot product multiplied out, coordinate by coordinate.")};
}

Blank constantBlank(const Out &out) {
  return {out.coefficients[3],
          {{out.constant, words("{answer} is n·P₀: the minus sign of P − P₀ is lost.")},
           {out.coordinateSum,
            words("{answer} only adds up the coordinates of P₀: each is multiplied by that of n first.")},
           {out.normalized[3],
            words("{answer} belongs to the normalized equation: here nothing is divided by |n|.")}},
          "= ax + by + cz + d,\\quad d ="};
}

Blank normalizedBlank(const Out &out) {
  return {out.normalized[3],
          {{out.coefficients[3], words("{answer} is not normalized: d is divided by |n| as well.")},
           {out.dividedBySquare, words("{answer} is divided by n·n: divide by its root, |n|.")}},
          "= \\frac{ax + by + cz + d}{\\lvert " + n + "\\rvert},\\quad \\frac{d}{\\lvert " + n +
              "\\rvert} ="};
}

WorkingLine collectLine(const In &in, const Out &out) {
  Formula f;
  const std::vector<Surd> variablesOnly(out.coefficients.begin(), out.coefficients.begin() + 3);
  const std::string left = f.linear(variablesOnly, {"x", "y", "z"});
  const std::string sum = f.equals(left + " - \\bigl(" + f.products(in.E.normal, in.E.point) + "\\bigr)");
  Formula g;
  const std::string equation = g.linear(out.coefficients, {"x", "y", "z"});
  return {
      "collect",
      "0",
      sum,
      g.equals(marked("E", equation)),
      words("Collected: the numbers before x, y and z are the coordinates of n, and the constant is −n·P₀."),
      constantBlank(out)};
}

WorkingLine constantLine(const In &in, const Out &out) {
  Formula f;
  const std::string products = f.products(in.E.normal, out.otherPoint);
  return {"constant",
          n + "\\cdot " + P1,
          f.equals(products),
          equalTo(out.otherConstant),
          words("{point} is another point of the plane. It gives the same number as P₀, so the constant "
                "does not depend on the point you start from.",
                {{"point", equation("P₁", out.otherPoint)}}),
          Blank{out.otherConstant}};
}

WorkingLine normalizedLine(const Out &out) {
  Formula f;
  const std::string divided =
      "\\frac{" + f.linear(out.coefficients, {"x", "y", "z"}) + "}{" + f(out.length) + "}";
  Formula g;
  const std::string normalized = g.linear(out.normalized, {"x", "y", "z"});
  const bool unit = out.normalSquared == 1;
  return {"normalized",
          "0",
          f.equals(divided),
          g.equals(normalized),
          unit ? words("|n| is 1: the equation is normalized already, so its left side gives distances.")
               : words("Divided by the length of the normal, {length}: the normalized form. The plane is the "
                       "same, and the left side now gives distances.",
                       {{"length", equation("|n|", out.length)}}),
          normalizedBlank(out)};
}

WorkingLine scaledLine(const Out &out) {
  Formula f;
  const std::string equation = f.linear(coefficientsOf(out.scaled), {"x", "y", "z"});
  return {"scaled", "0 = " + marked("kn", "2\\vec n") + "\\cdot(P - " + P0 + ")", f.equals(equation), "",
          words("Twice the normal doubles every number and changes nothing: the same points make it zero.")};
}

Working explain(const In &in, const Out &out) {
  if (out.zeroNormal)
    return {{implicitLine(), insertLine(in)}};
  return {{implicitLine(), insertLine(in), expandLine(in), collectLine(in, out), constantLine(in, out),
           normalizedLine(out), scaledLine(out)}};
}

Figure draw(const In &in, const Out &out) {
  Figure figure;
  const Place point = place(in.E.point);
  const Place normal = place(in.E.normal);
  const Place other = place(out.otherPoint);
  drawPlane(figure, in.E, out.coefficients,
            out.zeroNormal ? std::vector<Place>{} : std::vector<Place>{other});
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
