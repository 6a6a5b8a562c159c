#include "tests/lessons/construction/recomputed.h"
#include "lessons/object/line.h"
#include "lessons/object/plane.h"
#include "lessons/object/point.h"
#include "lessons/object/ray.h"
#include "lessons/object/triangle.h"

#include <algorithm>
#include <array>

namespace halfspace::test {
namespace {

using Objects = std::span<const Object *const>;

Rational product(const ExactVec3 &a, const ExactVec3 &b) {
  Rational sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += a[i] * b[i];
  return sum;
}

ExactVec3 perpendicular(const ExactVec3 &a, const ExactVec3 &b) {
  ExactVec3 result;
  for (int i = 0; i < 3; ++i)
    result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  return result;
}

/// Of the matrix with these columns.
Rational determinant(const ExactVec3 &a, const ExactVec3 &b, const ExactVec3 &c) {
  return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) + c.x * (a.y * b.z - a.z * b.y);
}

bool vanishes(const ExactVec3 &v) { return product(v, v) == 0; }

SignedSquares numbers(const ExactVec3 &v) {
  return {signedSquare(v.x), signedSquare(v.y), signedSquare(v.z)};
}
SignedSquares number(const Rational &x) { return {signedSquare(x)}; }

/// Divided by |n|.
SignedSquares normalizedNumbers(const ExactVec3 &v, const Rational &normalSquared) {
  return {signedSquare(v.x, normalSquared), signedSquare(v.y, normalSquared),
          signedSquare(v.z, normalSquared)};
}

/// The shortest positive multiple in integers: times the common denominator, by the common factor.
SignedSquares primitiveOf(const std::array<Rational, 4> &coefficients) {
  Integer multiple = 1;
  for (const Rational &each : coefficients)
    multiple *= each.denominator();
  Integer factor = 0;
  for (const Rational &each : coefficients)
    factor = mp::gcd(factor, (each * Rational(multiple)).numerator());
  SignedSquares result;
  for (const Rational &each : coefficients)
    result.push_back(signedSquare(Rational(each * Rational(multiple, factor))));
  return result;
}

/// The foot of a point: its multiplier k solves n·(x − k·n − P0) = 0.
ExactVec3 footOf(const ExactVec3 &x, const PlaneObject &plane) {
  const Rational k = product(plane.normal, ExactVec3(x - plane.point)) / product(plane.normal, plane.normal);
  ExactVec3 foot;
  for (int i = 0; i < 3; ++i)
    foot[i] = x[i] - k * plane.normal[i];
  return foot;
}

Names coordinatesAt(const ExactVec3 &at) {
  return {{"x", quantity(at.x)}, {"y", quantity(at.y)}, {"z", quantity(at.z)}, {"P", quantity(at)}};
}

/// Places without a pattern, off every plane that the tests make.
const ExactVec3 somewhere{Rational(137, 11), Rational(-71, 13), Rational(53, 17)};

Recomputed planeImplicit(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 &n = E.normal;
  // The equation's left side at the origin and one step along each axis tells its coefficients.
  const auto leftSide = [&](const ExactVec3 &x) { return product(n, ExactVec3(x - E.point)); };
  const Rational d = leftSide({0, 0, 0});
  const std::array<Rational, 4> all{leftSide({1, 0, 0}) - d, leftSide({0, 1, 0}) - d, leftSide({0, 0, 1}) - d,
                                    d};
  Recomputed expected;
  SignedSquares coefficients;
  for (const Rational &each : all)
    coefficients.push_back(signedSquare(each));
  expected.values["coefficients"] = coefficients;
  expected.names = {{"\\vec n", quantity(n)}, {"P_0", quantity(E.point)}};
  expected.unknowns = coordinatesAt(somewhere);
  expected.degenerate = vanishes(n);
  expected.caseName = vanishes(n) ? "zero-normal" : "plane";
  expected.solution = coordinatesAt(vanishes(n) ? somewhere : footOf(somewhere, E));
  if (vanishes(n)) {
    expected.vanished = {"E.n"};
    return expected;
  }
  const Rational square = product(n, n);
  SignedSquares normalized = normalizedNumbers(n, square);
  normalized.push_back(signedSquare(d, square));
  expected.values["primitive"] = primitiveOf(all);
  expected.values["normalized"] = normalized;
  expected.values["origin_distance"] = SignedSquares{signedSquare(d, square)};
  // Which second point the program shows is its choice; that it lies in the plane is what its line says.
  const ExactVec3 along = n.x == 0 && n.y == 0 ? ExactVec3{2, 0, 0} : ExactVec3{n.y, Rational(-n.x), 0};
  expected.names["P_1"] = quantity(ExactVec3(E.point + along));
  return expected;
}

Recomputed signedDistance(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const Rational f = product(E.normal, Q) - product(E.normal, E.point);
  const Rational square = product(E.normal, E.normal);
  const ExactVec3 w = Q - E.point;
  Recomputed expected;
  expected.values["f"] = number(f);
  expected.names = {{"\\vec n", quantity(E.normal)},
                    {"P_0", quantity(E.point)},
                    {"Q", quantity(Q)},
                    {"f(Q)", quantity(f)},
                    {"\\vec w", quantity(w)}};
  expected.degenerate = square == 0;
  if (square == 0) {
    expected.caseName = "zero-normal";
    expected.vanished = {"E.n"};
    return expected;
  }
  expected.caseName = f > 0 ? "positive" : f < 0 ? "negative" : "on";
  if (f == 0)
    expected.vanished = {"it.distance"};
  const ExactVec3 foot = footOf(Q, E);
  expected.values["side"] = expected.caseName;
  expected.values["signed_distance"] = SignedSquares{signedSquare(f, square)};
  expected.values["foot"] = numbers(foot);
  expected.names["F"] = quantity(foot);
  expected.names["\\operatorname{dist}"] = quantityOverRoot(f, square);
  if (vanishes(w))
    return expected;
  const Rational both = square * product(w, w);
  expected.values["cos_angle"] = SignedSquares{signedSquare(f, both)};
  expected.names["\\cos\\theta"] = quantityOverRoot(f, both);
  return expected;
}

Recomputed rayPlane(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 &n = E.normal;
  const Rational atStart = product(n, L.origin) - product(n, E.point);
  const Rational atTip = product(n, ExactVec3(L.origin + L.direction)) - product(n, E.point);
  const Rational slope = atTip - atStart;
  Recomputed expected;
  expected.values = {{"numerator", number(Rational(-atStart))}, {"denominator", number(slope)}};
  expected.names = {{"\\vec n", quantity(n)},    {"\\vec r", quantity(L.direction)},
                    {"P_0", quantity(E.point)},  {"Q", quantity(L.origin)},
                    {"f(Q)", quantity(atStart)}, {"d", quantity(Rational(-product(n, E.point)))}};
  expected.unknowns = {{"t", quantity(somewhere.x)}};
  if (vanishes(n))
    expected.vanished.insert("E.n");
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = vanishes(n) || vanishes(L.direction);
  if (slope == 0) {
    expected.caseName = vanishes(n)             ? "zero-normal"
                        : vanishes(L.direction) ? "zero-direction"
                        : atStart == 0          ? "in-plane"
                                                : "parallel";
    return expected;
  }
  // Where the plane's left side, which changes evenly along the ray, becomes zero.
  const Rational t = atStart / (atStart - atTip);
  const ExactVec3 point = L.origin + L.direction * t;
  const ExactVec3 facing = slope > 0 ? ExactVec3(-n) : n;
  const Rational square = product(n, n);
  expected.caseName = t < 0 ? "behind" : "hit";
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.values["facing_normal"] = normalizedNumbers(facing, square);
  expected.solution = Names{{"t", quantity(t)}};
  expected.names["H"] = quantity(point);
  Quantity unit;
  for (int i = 0; i < 3; ++i)
    unit.push_back(quantityOverRoot(facing[i], square)[0]);
  expected.names["\\vec n_f"] = unit;
  return expected;
}

Recomputed planePlane(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  const Rational d1 = -product(E.normal, E.point);
  const Rational d2 = -product(F.normal, F.point);
  Recomputed expected;
  expected.names = {{"\\vec n_E", quantity(E.normal)},
                    {"\\vec n_F", quantity(F.normal)},
                    {"P_{0,E}", quantity(E.point)},
                    {"P_{0,F}", quantity(F.point)},
                    {"d_E", quantity(d1)},
                    {"d_F", quantity(d2)}};
  expected.degenerate = vanishes(E.normal) || vanishes(F.normal);
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (vanishes(F.normal))
    expected.vanished.insert("F.n");
  if (expected.degenerate) {
    expected.caseName = "zero-normal";
    return expected;
  }
  const Rational f = product(E.normal, F.normal);
  const Rational squares = product(E.normal, E.normal) * product(F.normal, F.normal);
  expected.values["cos_angle"] = SignedSquares{signedSquare(f, squares)};
  expected.names["\\cos\\varphi"] = quantityOverRoot(f, squares);
  const ExactVec3 direction = perpendicular(E.normal, F.normal);
  expected.names["\\vec v"] = quantity(direction);
  if (f * f == squares) { // the normals are parallel
    const bool isSame = product(E.normal, ExactVec3(F.point - E.point)) == 0;
    expected.caseName = isSame ? "coincident" : "parallel";
    expected.vanished.insert("it.g.v");
    expected.vanished.insert("it.phi");
    return expected;
  }
  expected.caseName = "line";
  // The point as a sum of the two normals that both equations fit, by Cramer's rule.
  const Rational ee = product(E.normal, E.normal);
  const Rational ff = product(F.normal, F.normal);
  const Rational whole = ee * ff - f * f;
  const ExactVec3 point =
      E.normal * Rational((f * d2 - ff * d1) / whole) + F.normal * Rational((f * d1 - ee * d2) / whole);
  const ExactVec3 moment = perpendicular(point, direction);
  expected.values["direction"] = numbers(direction);
  expected.values["moment"] = numbers(moment);
  expected.values["point"] = numbers(point);
  expected.names["\\vec m"] = quantity(moment);
  expected.names["A"] = quantity(point);
  return expected;
}

Recomputed pointLine(Objects objects) {
  const ExactVec3 Q = objectAs<PointObject>(*objects[0])->at;
  const auto g = objectAs<LineObject>(*objects[1]).value();
  const ExactVec3 w = Q - g.point;
  Recomputed expected;
  expected.names = {{"Q", quantity(Q)},
                    {"A", quantity(g.point)},
                    {"\\vec v", quantity(g.direction)},
                    {"\\vec w", quantity(w)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  expected.degenerate = vanishes(g.direction);
  if (expected.degenerate) {
    expected.caseName = "zero-direction";
    expected.vanished.insert("g.v");
    return expected;
  }
  const Rational square = product(g.direction, g.direction);
  const Rational t = product(w, g.direction) / square;
  const ExactVec3 across = perpendicular(w, g.direction);
  const ExactVec3 foot = g.point + g.direction * t;
  expected.caseName = vanishes(across) ? "on" : "off";
  if (vanishes(across))
    expected.vanished.insert("it.h");
  expected.values = {{"t", number(t)},
                     {"foot", numbers(foot)},
                     {"distance", SignedSquares{Rational(product(across, across) / square)}}};
  expected.names["t"] = quantity(t);
  expected.names["F"] = quantity(foot);
  expected.names["\\vec h"] = quantity(ExactVec3(Q - foot));
  expected.names["\\operatorname{dist}"] =
      quantityOverRoot(product(across, across) / square, product(across, across) / square);
  if (vanishes(across))
    expected.names["\\operatorname{dist}"] = quantity(Rational(0));
  return expected;
}

/// Where a point of the triangle's plane lies, by the signs of the areas that it makes with each side.
struct Location {
  std::string word;
  std::optional<int> feature;
};

Location locationOf(const ExactVec3 &point, const std::array<ExactVec3, 3> &corners,
                    const ExactVec3 &normal) {
  std::vector<int> zero;
  std::vector<int> positive;
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const ExactVec3 &from = corners[(index + 1) % 3];
    const Rational area =
        determinant(normal, ExactVec3(corners[(index + 2) % 3] - from), ExactVec3(point - from));
    if (area < 0)
      return {"outside", {}};
    (area == 0 ? zero : positive).push_back(i);
  }
  return zero.empty()       ? Location{"interior", {}}
         : zero.size() == 1 ? Location{"edge", zero.front()}
                            : Location{"vertex", positive.front()};
}

/// The triangle's own values and names; true where it is a triangle.
bool recomputeTriangle(const TriangleObject &T, Recomputed &expected) {
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const ExactVec3 uPerp = perpendicular(n, u);
  const ExactVec3 vPerp = perpendicular(n, v);
  expected.values = {
      {"perp.u_perp", numbers(uPerp)},    {"perp.v_perp", numbers(vPerp)},
      {"perp.uu", number(product(u, u))}, {"perp.uv", number(product(u, v))},
      {"perp.vv", number(product(v, v))}, {"perp.denominator", number(Rational(-product(n, n)))}};
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)},
                    {"\\vec u^{\\perp}", quantity(uPerp)},
                    {"\\vec v^{\\perp}", quantity(vPerp)},
                    {"D", quantity(Rational(-product(n, n)))}};
  if (!vanishes(n))
    return true;
  expected.degenerate = true;
  expected.vanished = {"it.n", "it.uperp", "it.vperp"};
  expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
  return false;
}

Recomputed rayTriangle(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  Recomputed expected;
  const bool isTriangle = recomputeTriangle(T, expected);
  expected.names["Q"] = quantity(L.origin);
  expected.names["\\vec r"] = quantity(L.direction);
  if (vanishes(L.direction)) {
    expected.vanished.insert("L.r");
    expected.degenerate = true;
  }
  if (!isTriangle)
    return expected;
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  // Cramer's rule for s·u + t·v − λ·r = Q − P0.
  const ExactVec3 back = -L.direction;
  const ExactVec3 right = L.origin - T.p0;
  const Rational whole = determinant(u, v, back);
  if (whole == 0) {
    expected.caseName = vanishes(L.direction)           ? "zero-direction"
                        : determinant(u, v, right) == 0 ? "in-plane"
                                                        : "parallel";
    return expected;
  }
  const Rational s = determinant(right, v, back) / whole;
  const Rational t = determinant(u, right, back) / whole;
  const Rational lambda = determinant(u, v, right) / whole;
  const ExactVec3 point = T.p0 + u * s + v * t;
  const ExactVec3 w = point - T.p0;
  const Location location = locationOf(point, {T.p0, T.p1, T.p2}, perpendicular(u, v));
  expected.caseName = location.word == "outside" ? "miss" : lambda < 0 ? "behind" : "hit";
  expected.values["location"] = location.word;
  if (location.feature)
    expected.values["feature"] = *location.feature;
  expected.values["t"] = number(lambda);
  expected.values["point"] = numbers(point);
  expected.values["s"] = number(s);
  expected.values["t_triangle"] = number(t);
  expected.values["barycentric"] = numbers({Rational(1 - s - t), s, t});
  expected.values["perp.wu"] = number(product(w, u));
  expected.values["perp.wv"] = number(product(w, v));
  const ExactVec3 uPerp = perpendicular(perpendicular(u, v), u);
  expected.names.insert({{"I", quantity(point)},
                         {"\\vec w", quantity(w)},
                         {"\\lambda", quantity(lambda)},
                         {"s", quantity(s)},
                         {"t", quantity(t)},
                         {"a", quantity(product(w, uPerp))},
                         {"b", quantity(product(v, uPerp))}});
  return expected;
}

} // namespace

Rational signedSquare(const Rational &p, const Rational &square) { return p * abs(p) / square; }

Recomputed recompute(std::string_view construction, Objects objects) {
  static const std::map<std::string_view, Recomputed (*)(Objects)> all{
      {"plane-implicit", planeImplicit},  {"signed-distance", signedDistance}, {"ray-plane-dot", rayPlane},
      {"ray-triangle-perp", rayTriangle}, {"plane-plane", planePlane},         {"point-line", pointLine}};
  return all.at(construction)(objects);
}

} // namespace halfspace::test
