// A line and a sphere, recomputed by how far the line passes from the centre: no equation is solved.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/sphere.h"

namespace halfspace::test {

/// Where the line passes the centre.
struct Passing {
  ExactVec3 nearest;
  Rational t;             ///< of the nearest point
  Rational heightSquared; ///< of the centre over the line
  Rational partSquared;   ///< of t, from there to where the line meets the sphere; negative where it does not
};

inline Passing passingOf(const SphereObject &S, const LineObject &g) {
  const ExactVec3 toCenter = S.center - g.point;
  const Rational square = product(g.direction, g.direction);
  const ExactVec3 across = perpendicular(g.direction, toCenter);
  const Rational t = product(toCenter, g.direction) / square;
  const Rational height = product(across, across) / square;
  return {g.point + g.direction * t, t, height, Rational((S.radius * S.radius - height) / square)};
}

/// number + factor·√square, with the sign of the factor.
inline SumWithRoot sumWithRoot(const Rational &number, const Rational &factor, const Rational &square) {
  return {number, Rational(signedSquare(factor) * square)};
}

inline Quantity quantityOf(const SumWithRoot &sum) {
  const Surd root = Surd::root(abs(sum.signedSquare), sum.signedSquare < 0 ? -1 : 1);
  return quantity(root + sum.number); // which is exactly 0 where the parts cancel
}

inline Quantity quantityOf(const SumsWithRoots &sums) {
  std::vector<Quantity> all;
  for (const SumWithRoot &sum : sums)
    all.push_back(quantityOf(sum));
  return together(all);
}

/// What a contact adds, on the side of the nearest point that `sign` tells.
inline void addContact(Recomputed &expected, const SphereObject &S, const LineObject &g,
                       const Passing &passing, int sign, const std::string &index, const std::string &group) {
  SumsWithRoots point;
  SumsWithRoots normal;
  for (int i = 0; i < 3; ++i) {
    const Rational part = sign * g.direction[i];
    point.push_back(sumWithRoot(passing.nearest[i], part, passing.partSquared));
    normal.push_back(sumWithRoot(Rational((passing.nearest[i] - S.center[i]) / S.radius),
                                 Rational(part / S.radius), passing.partSquared));
  }
  expected.names["t_" + index] = quantityOf(sumWithRoot(passing.t, sign, passing.partSquared));
  expected.names["H_" + index] = quantityOf(point);
  expected.names["\\vec n_" + index] = quantityOf(normal);
  expected.values[group + ".point"] = point;
  expected.values[group + ".normal"] = normal;
}

/// One where the line touches, else two.
inline void addContacts(Recomputed &expected, const SphereObject &S, const LineObject &g,
                        const Passing &passing) {
  addContact(expected, S, g, passing, -1, "1", "first");
  SumsWithRoots parameters{sumWithRoot(passing.t, -1, passing.partSquared)};
  if (passing.partSquared > 0) {
    addContact(expected, S, g, passing, 1, "2", "second");
    parameters.push_back(sumWithRoot(passing.t, 1, passing.partSquared));
    const Rational chord = passing.partSquared * product(g.direction, g.direction);
    expected.names["s"] = quantityOverRoot(chord, chord);
  }
  expected.values["t"] = parameters;
  expected.solution = Names{{"t", expected.names["t_1"]}};
}

/// All that a line with a direction and a sphere with a radius come to but the case; how the line passes the
/// centre.
inline Passing addLineAtSphere(Recomputed &expected, const SphereObject &S, const LineObject &g) {
  const Passing passing = passingOf(S, g);
  const ExactVec3 w = g.point - S.center;
  const Rational square = product(g.direction, g.direction);
  const Rational discriminant = passing.partSquared * square * square;
  expected.values["discriminant"] = number(discriminant);
  expected.values["nearest"] = numbers(passing.nearest);
  expected.values["distance"] = SignedSquares{passing.heightSquared};
  expected.names["a"] = quantity(square);
  expected.names["b"] = quantity(Rational(-passing.t * square));
  expected.names["k"] = quantity(Rational(product(w, w) - S.radius * S.radius));
  expected.names["D"] = quantity(discriminant);
  expected.names["M"] = quantity(passing.nearest);
  expected.names["h"] = quantity(Surd::root(passing.heightSquared));
  if (passing.heightSquared == 0)
    expected.vanished.insert("it.h");
  if (passing.partSquared >= 0)
    addContacts(expected, S, g, passing);
  return passing;
}

inline std::string contactsWord(const Passing &passing) {
  return passing.partSquared < 0 ? "none" : passing.partSquared == 0 ? "tangent" : "two";
}

inline void addRoots(std::vector<WrongAnswer> &all, const Rational &a, const Rational &b,
                     const Rational &discriminant) {
  const auto solution = [&](const Rational &middle, int sign, const Rational &square, const Rational &below) {
    return Surd::root(square, Rational(Rational(sign) / below)) + Rational(middle / below);
  };
  for (const int sign : {-1, 1}) {
    Line line(sign < 0 ? "t1" : "t2", solution(Rational(-b), sign, discriminant, a), all);
    line.add("not divided", solution(Rational(-b), sign, discriminant, 1));
    line.add("divided by 2a", solution(Rational(-b), sign, discriminant, Rational(2 * a)));
    line.add("b without its minus", solution(b, sign, discriminant, a));
    line.add("the other sign of the root", solution(Rational(-b), -sign, discriminant, a));
    line.add("without the root", Rational(-b / a));
    line.add("the root forgotten", Rational((-b + sign * discriminant) / a));
    line.add("only the root divided", Surd::root(discriminant, Rational(Rational(sign) / a)) + Rational(-b));
    line.add("both signs wrong", solution(b, -sign, discriminant, a));
  }
}

/// Of a line with a direction and a sphere with a radius.
inline std::vector<WrongAnswer> wrongAnswersAtSphere(const SphereObject &S, const LineObject &g) {
  std::vector<WrongAnswer> all;
  const ExactVec3 w = g.point - S.center;
  const Rational a = times(g.direction, g.direction);
  const Rational b = times(g.direction, w);
  const Rational radiusSquared = S.radius * S.radius;
  const Rational k = times(w, w) - radiusSquared;
  const Rational discriminant = b * b - a * k;
  addProduct(all, "a", g.direction, g.direction);
  addProduct(all, "b", g.direction, w);
  Line constant("k", k, all);
  constant.add("R not squared", Rational(times(w, w) - S.radius));
  constant.add("R² added", Rational(times(w, w) + radiusSquared));
  constant.add("R² forgotten", times(w, w));
  constant.add("the difference reversed", Rational(-k));
  Line line("discriminant", discriminant, all);
  line.add("with b for half of it", Rational(4 * discriminant));
  line.add("a 4 too many", Rational(b * b - 4 * a * k));
  line.add("b not squared", Rational(b - a * k));
  line.add("added", Rational(b * b + a * k));
  line.add("b² forgotten", Rational(-a * k));
  line.add("a·k forgotten", Rational(b * b));
  line.add("reversed", Rational(-discriminant));
  if (discriminant > 0) {
    addRoots(all, a, b, discriminant);
    const Passing passing = passingOf(S, g);
    const Rational chord = radiusSquared - passing.heightSquared;
    Line half("s", Surd::root(chord), all);
    half.add("the root forgotten", chord);
    half.add("squares added", Surd::root(Rational(radiusSquared + passing.heightSquared)));
  }
  return all;
}

} // namespace halfspace::test
