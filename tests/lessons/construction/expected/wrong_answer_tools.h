// What wrong workings of several constructions share. It knows nothing of how the program finds mistakes.
#pragma once

#include "tests/lessons/construction/expected/expected.h"

#include "lessons/object/kinds/ray.h"

#include <array>
#include <map>

namespace halfspace::test {

/// The three products of a dot product.
inline std::array<Rational, 3> productsOf(const ExactVec3 &a, const ExactVec3 &b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

inline Rational total(const std::array<Rational, 3> &products) {
  return products[0] + products[1] + products[2];
}

inline Rational times(const ExactVec3 &a, const ExactVec3 &b) { return total(productsOf(a, b)); }

inline Rational coordinateSum(const ExactVec3 &a) { return a.x + a.y + a.z; }

inline ExactVec3 swapped(ExactVec3 a, int i, int j) {
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

/// A wrong answer to a line that asks for a vector.
inline void addVector(std::vector<WrongAnswer> &all, const char *id, const char *how, const ExactVec3 &wrong,
                      const ExactVec3 &right) {
  if (wrong != right)
    all.push_back({id, how, "(" + toText(wrong.x) + ", " + toText(wrong.y) + ", " + toText(wrong.z) + ")"});
}

/// (1)x+(2)y+(2)z
inline std::string variablePart(const ExactVec3 &n) {
  const auto factor = [](const Rational &number) { return "(" + toText(number) + ")"; };
  return factor(n.x) + "x+" + factor(n.y) + "y+" + factor(n.z) + "z";
}

/// Numbers that a dot product comes to when one thing is done wrongly, by how.
using Slips = std::vector<std::pair<const char *, Rational>>;

inline Slips dotSlips(const ExactVec3 &a, const ExactVec3 &b) {
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
inline Slips differenceSlips(const ExactVec3 &n, const ExactVec3 &to, const ExactVec3 &from) {
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

inline void addSlips(Line &line, const Slips &slips) {
  for (const auto &[how, value] : slips)
    line.add(how, value);
}

inline void addProduct(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &a,
                       const ExactVec3 &b) {
  Line line(id, times(a, b), all);
  addSlips(line, dotSlips(a, b));
  if (a == b) {
    line.add("the root taken", Surd::root(times(a, a)));
    line.add("coordinates not squared", coordinateSum(a));
  }
}

inline void addLength(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &n) {
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

/// A point of a ray: start + parameter·direction.
inline void addPointOnRay(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &start,
                          const Rational &parameter, const ExactVec3 &direction) {
  const ExactVec3 way = direction * parameter;
  const ExactVec3 right = start + way;
  const auto add = [&](const char *how, const ExactVec3 &wrong) { addVector(all, id, how, wrong, right); };
  add("subtracted", start - way);
  add("the parameter forgotten", start + direction);
  add("the parameter added", ExactVec3(start + direction) + ExactVec3(parameter));
  add("the start forgotten", way);
  add("the start multiplied too", ExactVec3(start + direction) * parameter);
  add("start and direction swapped", direction + start * parameter);
  for (int i = 0; i < 3; ++i) {
    const auto addOne = [&](const char *how, const Rational &wrong) {
      ExactVec3 other = right;
      other[i] = wrong;
      add(how, other);
    };
    addOne("one product dropped", start[i]);
    addOne("the sign of one product lost", Rational(start[i] - way[i]));
    addOne("one coordinate of the start dropped", way[i]);
    addOne("the sign of one coordinate of the start lost", Rational(way[i] - start[i]));
    addOne("one coordinate not multiplied", Rational(start[i] + direction[i]));
  }
}

/// Of a×b, with one thing done wrongly.
inline void addCross(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &a, const ExactVec3 &b) {
  ExactVec3 right;
  for (int i = 0; i < 3; ++i)
    right[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  addVector(all, id, "the other way round", ExactVec3(-right), right);
  addVector(all, id, "coordinate by coordinate", ExactVec3(a.x * b.x, a.y * b.y, a.z * b.z), right);
  addVector(all, id, "the second sign lost", {right.x, Rational(-right.y), right.z}, right);
  for (int i = 0; i < 3; ++i) {
    const Rational first = a[(i + 1) % 3] * b[(i + 2) % 3];
    const Rational second = a[(i + 2) % 3] * b[(i + 1) % 3];
    const auto addOne = [&](const char *how, const Rational &coordinate) {
      ExactVec3 wrong = right;
      wrong[i] = coordinate;
      addVector(all, id, how, wrong, right);
    };
    addOne("products added", Rational(first + second));
    addOne("the second product dropped", first);
    addOne("the first product dropped", Rational(-second));
    addOne("the difference reversed", Rational(second - first));
    addOne("a coordinate that belongs elsewhere", Rational(a[i] * b[(i + 1) % 3] - a[(i + 1) % 3] * b[i]));
  }
}

/// A fraction of two numbers, each of which may have gone wrong.
inline void addFraction(Line &line, const Rational &top, const Rational &bottom) {
  line.addRatio("upside down", bottom, top);
  line.addRatio("the sign lost", Rational(-top), bottom);
  line.add("not divided", top);
  line.add("only the denominator", bottom);
  line.addRatio("divided by the square", top, Rational(bottom * bottom));
  line.add("multiplied instead of divided", Rational(top * bottom));
}

/// The ray's parameter t.
inline void addParameter(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &n,
                         const ExactVec3 &p0, const RayObject &ray) {
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

inline void addCosine(std::vector<WrongAnswer> &all, const ExactVec3 &n, const ExactVec3 &w,
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

} // namespace halfspace::test
