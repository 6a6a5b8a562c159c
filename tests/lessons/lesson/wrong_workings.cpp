#include "tests/lessons/lesson/wrong_workings.h"
#include "lessons/object/line.h"
#include "lessons/object/plane.h"
#include "lessons/object/point.h"
#include "lessons/object/ray.h"
#include "lessons/object/triangle.h"

#include <array>
#include <map>

namespace halfspace::test {
namespace {

using Objects = std::span<const Object *const>;

/// The three products of a dot product.
std::array<Rational, 3> productsOf(const ExactVec3 &a, const ExactVec3 &b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

Rational total(const std::array<Rational, 3> &products) { return products[0] + products[1] + products[2]; }

Rational times(const ExactVec3 &a, const ExactVec3 &b) { return total(productsOf(a, b)); }

Rational coordinateSum(const ExactVec3 &a) { return a.x + a.y + a.z; }

ExactVec3 perpendicular(const ExactVec3 &a, const ExactVec3 &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

ExactVec3 swapped(ExactVec3 a, int i, int j) {
  std::swap(a[i], a[j]);
  return a;
}

/// The wrong answers to one line.
class Line {
public:
  /// `before`: what is typed before the number, where it is part of an equation.
  Line(std::string id, Surd right, std::vector<WrongAnswer> &all, std::string before = {})
      : m_id(std::move(id)), m_right(std::move(right)), m_all(all), m_before(std::move(before)) {}

  void add(const char *how, const Surd &value) {
    const auto text = toText(value);
    if (text && !(value == m_right))
      m_all.push_back({m_id, how, m_before.empty() ? *text : m_before + "+(" + *text + ")"});
  }
  /// top/bottom, where that is a number.
  void addRatio(const char *how, const Rational &top, const Rational &bottom) {
    if (bottom != 0)
      add(how, Rational(top / bottom));
  }
  /// top/√square
  void addOverRoot(const char *how, const Rational &top, const Rational &square) {
    if (square > 0)
      add(how, Surd::root(square, Rational(top / square)));
  }

private:
  std::string m_id;
  Surd m_right;
  std::vector<WrongAnswer> &m_all;
  std::string m_before;
};

/// (1)x+(2)y+(2)z
std::string variablePart(const ExactVec3 &n) {
  const auto factor = [](const Rational &number) { return "(" + toText(number) + ")"; };
  return factor(n.x) + "x+" + factor(n.y) + "y+" + factor(n.z) + "z";
}

/// Numbers that a dot product comes to when one thing is done wrongly, by how.
using Slips = std::vector<std::pair<const char *, Rational>>;

Slips dotSlips(const ExactVec3 &a, const ExactVec3 &b) {
  Slips slips;
  const auto products = productsOf(a, b);
  const Rational right = total(products);
  for (const Rational &product : products) {
    if (product < 0)
      slips.emplace_back("the sign of one product lost", Rational(right - 2 * product));
    if (product != 0)
      slips.emplace_back("one product dropped", Rational(right - product));
    if (product > 0)
      slips.emplace_back("one product subtracted", Rational(right - 2 * product));
  }
  for (int i = 0; i < 3; ++i) {
    const Rational sum = a[i] + b[i];
    slips.emplace_back("one product added up instead",
                       Rational(right - products.at(static_cast<std::size_t>(i)) + sum));
  }
  slips.emplace_back("coordinates added up instead of multiplied",
                     Rational(coordinateSum(a) + coordinateSum(b)));
  slips.emplace_back("one vector reversed", Rational(-right));
  for (const auto &[i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
    slips.emplace_back("two coordinates swapped", times(swapped(a, i, j), b));
  return slips;
}

/// What n·(to − from) comes to.
Slips differenceSlips(const ExactVec3 &n, const ExactVec3 &to, const ExactVec3 &from) {
  const ExactVec3 way = to - from;
  Slips slips = dotSlips(n, way);
  slips.emplace_back("points added", times(n, ExactVec3(to + from)));
  slips.emplace_back("the second point forgotten", times(n, to));
  slips.emplace_back("the first point forgotten", times(n, from));
  slips.emplace_back("the first point forgotten, with its sign", Rational(-times(n, from)));
  for (int i = 0; i < 3; ++i) {
    ExactVec3 wrong = way;
    wrong[i] = -way[i];
    slips.emplace_back("one coordinate's difference reversed", times(n, wrong));
    wrong[i] = to[i] + from[i];
    slips.emplace_back("one coordinate added", times(n, wrong));
    wrong[i] = to[i];
    slips.emplace_back("one coordinate not subtracted", times(n, wrong));
  }
  return slips;
}

void addSlips(Line &line, const Slips &slips) {
  for (const auto &[how, value] : slips)
    line.add(how, value);
}

void addProduct(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &a, const ExactVec3 &b) {
  Line line(id, times(a, b), all);
  addSlips(line, dotSlips(a, b));
  if (a == b) {
    line.add("the root taken", Surd::root(times(a, a)));
    line.add("coordinates not squared", coordinateSum(a));
  }
}

void addLength(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &n) {
  const Rational square = times(n, n);
  Line line(id, Surd::root(square), all);
  line.add("the root forgotten", square);
  line.add("coordinates not squared", coordinateSum(n));
  line.add("sizes of coordinates added", Rational(abs(n.x) + abs(n.y) + abs(n.z)));
  line.add("halved instead of the root taken", Rational(square / 2));
  if (coordinateSum(n) >= 0)
    line.add("the root of the coordinates' sum", Surd::root(coordinateSum(n)));
  for (int i = 0; i < 3; ++i) {
    const Rational part = n[i] * n[i];
    line.add("one square dropped", Surd::root(Rational(square - part)));
    if (n[i] < 0 && square >= 2 * part)
      line.add("a negative coordinate's square taken as negative", Surd::root(Rational(square - 2 * part)));
    if (const Rational doubled = square - part + 2 * n[i]; doubled >= 0)
      line.add("one coordinate doubled instead of squared", Surd::root(doubled));
  }
}

/// A fraction of two numbers, each of which may have gone wrong.
void addFraction(Line &line, const Rational &top, const Rational &bottom) {
  line.addRatio("upside down", bottom, top);
  line.addRatio("the sign lost", Rational(-top), bottom);
  line.add("not divided", top);
  line.add("only the denominator", bottom);
  line.addRatio("divided by the square", top, Rational(bottom * bottom));
  line.add("multiplied instead of divided", Rational(top * bottom));
}

/// The ray's parameter t.
void addParameter(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &n, const ExactVec3 &p0,
                  const RayObject &ray) {
  const Rational top = times(n, ExactVec3(p0 - ray.origin));
  const Rational bottom = times(n, ray.direction);
  Line line(id, Rational(top / bottom), all);
  addFraction(line, top, bottom);
  line.addRatio("divided by n·n", top, times(n, n));
  line.addRatio("divided by r·r", top, times(ray.direction, ray.direction));
  line.addOverRoot("divided by |n|", top, times(n, n));
  line.addOverRoot("divided by |r|", top, times(ray.direction, ray.direction));
  line.addRatio("in the numerator: the second point forgotten", times(n, p0), bottom);
  line.addRatio("in the numerator: points added", times(n, ExactVec3(p0 + ray.origin)), bottom);
  line.addRatio("in the numerator: the first point forgotten", times(n, ray.origin), bottom);
  for (const auto &[how, value] : dotSlips(n, ExactVec3(p0 - ray.origin)))
    if (std::string_view(how) == "one product dropped" ||
        std::string_view(how) == "the sign of one product lost")
      line.addRatio("in the numerator: a product dropped or its sign lost", value, bottom);
  for (const auto &[how, value] : dotSlips(n, ray.direction))
    if (std::string_view(how) == "one product dropped" ||
        std::string_view(how) == "the sign of one product lost")
      line.addRatio("in the denominator: a product dropped or its sign lost", top, value);
}

std::vector<WrongAnswer> planeImplicit(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 &n = E.normal;
  const Rational square = times(n, n);
  std::vector<WrongAnswer> all;
  if (square == 0)
    return all;
  const Rational d = -times(n, E.point);
  Line collect("collect", d, all, variablePart(n));
  for (const auto &[how, value] : dotSlips(n, E.point))
    collect.add(how, Rational(-value));
  for (const auto &[how, value] : dotSlips(n, E.point))
    collect.add("the minus lost, and more", value);
  collect.add("only P0 added up", coordinateSum(E.point));
  collect.add("P0 added up and subtracted", Rational(-coordinateSum(E.point)));
  collect.addOverRoot("normalized too early", d, square);
  // Any second point will do: the number is the same. The program's own is not known here.
  const ExactVec3 along = n.x == 0 && n.y == 0 ? ExactVec3{2, 0, 0} : ExactVec3{n.y, Rational(-n.x), 0};
  addProduct(all, "constant", n, ExactVec3(E.point + along));
  Line normalized("normalized", Surd::root(square, Rational(d / square)), all,
                  "(" + variablePart(n) + ")/sqrt(" + toText(square) + ")");
  normalized.add("not divided", d);
  normalized.addOverRoot("the sign lost", Rational(-d), square);
  normalized.addRatio("divided by n·n", d, square);
  normalized.addRatio("divided by the coordinates' sum", d, coordinateSum(n));
  normalized.add("multiplied instead of divided", Surd::root(square, d));
  normalized.add("only the length", Surd::root(square));
  if (d != 0)
    normalized.add("upside down", Surd::root(square, Rational(1 / d)));
  for (const auto &[how, value] : dotSlips(n, E.point))
    if (std::string_view(how) == "one product dropped")
      normalized.addOverRoot("in d: one product dropped", Rational(-value), square);
  return all;
}

void addDistance(std::vector<WrongAnswer> &all, const ExactVec3 &n, const Rational &f) {
  const Rational square = times(n, n);
  Line line("distance", Surd::root(square, Rational(f / square)), all);
  line.add("not divided", f);
  line.add("not divided, the sign lost", Rational(-f));
  line.addOverRoot("the sign lost", Rational(-f), square);
  line.addRatio("divided by n·n", f, square);
  line.addRatio("divided by n·n, the sign lost", Rational(-f), square);
  line.addRatio("divided by the coordinates' sum", f, coordinateSum(n));
  line.add("multiplied instead of divided", Surd::root(square, f));
  line.add("only the length", Surd::root(square));
  if (f != 0)
    line.add("upside down", Surd::root(square, Rational(1 / f)));
}

void addCosine(std::vector<WrongAnswer> &all, const ExactVec3 &n, const ExactVec3 &w,
               const char *id = "cosine") {
  const Rational f = times(n, w);
  const Rational nn = times(n, n);
  const Rational ww = times(w, w);
  Line line(id, Surd::root(Rational(nn * ww), Rational(f / (nn * ww))), all);
  line.add("not divided", f);
  line.addOverRoot("divided by |n| only", f, nn);
  line.addOverRoot("divided by |w| only", f, ww);
  line.addRatio("divided by the squares of both lengths", f, Rational(nn * ww));
  line.addRatio("divided by n·n", f, nn);
  line.addRatio("divided by w·w", f, ww);
  line.addOverRoot("the sign lost", Rational(-f), Rational(nn * ww));
  line.add("only the lengths", Surd::root(Rational(nn * ww)));
  if (f != 0)
    line.add("upside down", Surd::root(Rational(nn * ww), Rational(1 / f)));
  for (const auto &[how, value] : dotSlips(n, w))
    if (std::string_view(how) == "one product dropped" ||
        std::string_view(how) == "the sign of one product lost")
      line.addOverRoot("in the numerator: a product dropped or its sign lost", value, Rational(nn * ww));
}

std::vector<WrongAnswer> signedDistance(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 w = Q - E.point;
  const Rational f = times(E.normal, w);
  std::vector<WrongAnswer> all;
  Line line("f", f, all);
  addSlips(line, differenceSlips(E.normal, Q, E.point));
  if (times(E.normal, E.normal) == 0)
    return all;
  line.addOverRoot("divided by the length already", f, times(E.normal, E.normal));
  addLength(all, "length", E.normal);
  addDistance(all, E.normal, f);
  if (times(w, w) != 0)
    addCosine(all, E.normal, w);
  return all;
}

std::vector<WrongAnswer> rayPlane(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  Line numerator("numerator", times(E.normal, ExactVec3(E.point - L.origin)), all);
  addSlips(numerator, differenceSlips(E.normal, E.point, L.origin));
  addProduct(all, "denominator", L.direction, E.normal);
  if (times(L.direction, E.normal) != 0)
    addParameter(all, "t", E.normal, E.point, L);
  return all;
}

/// The five dot products, as the share of u or of v takes them.
struct Products {
  Rational uv;
  Rational own;   ///< of the other side with itself: v·v for s, u·u for t
  Rational other; ///< of w with the other side: w·v for s, w·u for t
  Rational same;  ///< of w with the side itself: w·u for s, w·v for t
};

/// s = ((u·v)(w·v) − (v·v)(w·u))/D, and t likewise.
void addShare(std::vector<WrongAnswer> &all, const char *id, const Products &of, const Rational &D,
              const Rational &otherShare) {
  const Rational first = of.uv * of.other;
  const Rational second = of.own * of.same;
  const Rational top = first - second;
  Line line(id, Rational(top / D), all);
  addFraction(line, top, D);
  line.add("the other share", otherShare);
  line.add("what is left to one", Rational(1 - top / D));
  line.addRatio("in the numerator: the second part dropped", first, D);
  line.addRatio("in the numerator: the first part dropped", Rational(-second), D);
  line.addRatio("in the numerator: parts added", Rational(first + second), D);
  line.addRatio("in the numerator: w·u and w·v swapped", Rational(of.uv * of.same - of.own * of.other), D);
  const Rational uu_vv = of.uv * of.uv - D;
  line.addRatio("in the denominator: u·v not squared", top, Rational(of.uv - uu_vv));
  line.addRatio("in the denominator: the second part dropped", top, Rational(of.uv * of.uv));
  line.addRatio("in the denominator: the first part dropped", top, Rational(-uu_vv));
  line.addRatio("in the denominator: parts added", top, Rational(of.uv * of.uv + uu_vv));
}

void addDenominator(std::vector<WrongAnswer> &all, const ExactVec3 &u, const ExactVec3 &v) {
  const Rational uv = times(u, v);
  const Rational uu = times(u, u);
  const Rational vv = times(v, v);
  const Rational D = uv * uv - uu * vv;
  Line line("denominator", D, all);
  line.add("the sign lost", Rational(-D));
  line.add("u·v not squared", Rational(uv - uu * vv));
  line.add("u·v doubled instead of squared", Rational(2 * uv - uu * vv));
  line.add("the second part dropped", Rational(uv * uv));
  line.add("the first part dropped", Rational(-uu * vv));
  line.add("the first part and a sign dropped", Rational(uu * vv));
  line.add("parts added", Rational(uv * uv + uu * vv));
  line.add("u·u and v·v added", Rational(uv * uv - (uu + vv)));
  line.add("u·u only", Rational(uv * uv - uu));
  line.add("v·v only", Rational(uv * uv - vv));
  line.add("u·u for v·v", Rational(uv * uv - uu * uu));
  line.add("v·v for u·u", Rational(uv * uv - vv * vv));
  line.add("the square and its parts negative", Rational(-uv * uv - uu * vv));
}

std::vector<WrongAnswer> rayTriangle(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  std::vector<WrongAnswer> all;
  addProduct(all, "uu", u, u);
  addProduct(all, "uv", u, v);
  addProduct(all, "vv", v, v);
  addDenominator(all, u, v);
  if (times(n, L.direction) == 0)
    return all;
  addParameter(all, "plane-t", n, T.p0, L);
  const Rational lambda = times(n, ExactVec3(T.p0 - L.origin)) / times(n, L.direction);
  const ExactVec3 w = L.origin + L.direction * lambda - T.p0;
  addProduct(all, "wu", w, u);
  addProduct(all, "wv", w, v);
  const Rational D = -times(n, n);
  const Rational s = times(perpendicular(w, v), n) / -D;
  const Rational t = times(perpendicular(u, w), n) / -D;
  addShare(all, "s", {times(u, v), times(v, v), times(w, v), times(w, u)}, D, t);
  addShare(all, "t", {times(u, v), times(u, u), times(w, u), times(w, v)}, D, s);
  const ExactVec3 uPerp = perpendicular(n, u);
  addProduct(all, "a", w, uPerp);
  addProduct(all, "b", v, uPerp);
  return all;
}

std::vector<WrongAnswer> planePlane(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (times(E.normal, E.normal) == 0 || times(F.normal, F.normal) == 0)
    return all;
  for (const auto &[id, plane] : {std::pair("d1", E), std::pair("d2", F)}) {
    const Rational product = times(plane.normal, plane.point);
    Line line(id, Rational(-product), all);
    line.add("the minus forgotten", product);
    for (const auto &[how, value] : dotSlips(plane.normal, plane.point))
      line.add(how, Rational(-value));
  }
  addCosine(all, E.normal, F.normal, "angle");
  return all;
}

std::vector<WrongAnswer> pointLine(Objects objects) {
  const ExactVec3 Q = objectAs<PointObject>(*objects[0])->at;
  const auto g = objectAs<LineObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  const Rational square = times(g.direction, g.direction);
  if (square == 0)
    return all;
  const ExactVec3 w = Q - g.point;
  const Rational top = times(w, g.direction);
  Line t("t", Rational(top / square), all);
  addFraction(t, top, square);
  t.addOverRoot("divided by the length", top, square);
  for (const auto &[how, value] : dotSlips(w, g.direction))
    t.addRatio(how, value, square);
  addLength(all, "distance", ExactVec3(w - g.direction * Rational(top / square)));
  return all;
}

} // namespace

std::vector<WrongAnswer> wrongAnswers(std::string_view construction, Objects objects) {
  static const std::map<std::string_view, std::vector<WrongAnswer> (*)(Objects)> all{
      {"plane-implicit", planeImplicit},  {"signed-distance", signedDistance}, {"ray-plane-dot", rayPlane},
      {"ray-triangle-perp", rayTriangle}, {"plane-plane", planePlane},         {"point-line", pointLine}};
  return all.at(construction)(objects);
}

} // namespace halfspace::test
