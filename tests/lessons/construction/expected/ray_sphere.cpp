#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// What is known without solving anything: how far the line passes from the centre, and where.
struct Passing {
  ExactVec3 nearest;
  Rational t;             ///< of the nearest point
  Rational heightSquared; ///< of the centre over the line
  Rational partSquared;   ///< of t, from there to where the line meets the sphere; negative where it does not
};

Passing passingOf(const SphereObject &S, const RayObject &L) {
  const ExactVec3 toCenter = S.center - L.origin;
  const Rational square = product(L.direction, L.direction);
  const ExactVec3 across = perpendicular(L.direction, toCenter);
  const Rational t = product(toCenter, L.direction) / square;
  const Rational height = product(across, across) / square;
  return {L.origin + L.direction * t, t, height, Rational((S.radius * S.radius - height) / square)};
}

/// number + factor·√square, with the sign of the factor.
SumWithRoot sumWithRoot(const Rational &number, const Rational &factor, const Rational &square) {
  return {number, Rational(signedSquare(factor) * square)};
}

Quantity quantityOf(const SumWithRoot &sum) {
  const Surd root = Surd::root(abs(sum.signedSquare), sum.signedSquare < 0 ? -1 : 1);
  return quantity(root + sum.number); // which is exactly 0 where the parts cancel
}

Quantity quantityOf(const SumsWithRoots &sums) {
  std::vector<Quantity> all;
  for (const SumWithRoot &sum : sums)
    all.push_back(quantityOf(sum));
  return together(all);
}

/// What a contact adds, on the side of the nearest point that `sign` tells.
void addContact(Recomputed &expected, const SphereObject &S, const RayObject &L, const Passing &passing,
                int sign, const std::string &index, const std::string &group) {
  SumsWithRoots point;
  SumsWithRoots normal;
  for (int i = 0; i < 3; ++i) {
    const Rational part = sign * L.direction[i];
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

void addContacts(Recomputed &expected, const SphereObject &S, const RayObject &L, const Passing &passing) {
  const bool touches = passing.partSquared == 0;
  addContact(expected, S, L, passing, -1, "1", "first");
  SumsWithRoots parameters{sumWithRoot(passing.t, -1, passing.partSquared)};
  if (!touches) {
    addContact(expected, S, L, passing, 1, "2", "second");
    parameters.push_back(sumWithRoot(passing.t, 1, passing.partSquared));
    const Rational chord = passing.partSquared * product(L.direction, L.direction);
    expected.names["s"] = quantityOverRoot(chord, chord);
  }
  expected.values["t"] = parameters;
  expected.values["contacts"] = touches ? "tangent" : "two";
  expected.solution = Names{{"t", expected.names["t_1"]}};
}

Recomputed recompute(Objects objects) {
  const auto S = objectAs<SphereObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 w = L.origin - S.center;
  Recomputed expected;
  expected.names = {{"c", quantity(S.center)},
                    {"R", quantity(S.radius)},
                    {"Q", quantity(L.origin)},
                    {"\\vec r", quantity(L.direction)},
                    {"\\vec w", quantity(w)}};
  expected.unknowns = {{"t", quantity(somewhere.x)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = S.radius == 0 || vanishes(L.direction);
  if (S.radius == 0) {
    expected.caseName = "zero-radius";
    expected.vanished.insert("S");
    return expected;
  }
  const Rational outside = product(w, w) - S.radius * S.radius;
  expected.values["origin"] = outside > 0 ? "outside" : outside < 0 ? "inside" : "on";
  if (vanishes(L.direction)) {
    expected.caseName = "zero-direction";
    return expected;
  }
  const Passing passing = passingOf(S, L);
  const Rational square = product(L.direction, L.direction);
  const Rational discriminant = passing.partSquared * square * square;
  expected.values["discriminant"] = number(discriminant);
  expected.values["nearest"] = numbers(passing.nearest);
  expected.values["distance"] = SignedSquares{passing.heightSquared};
  expected.names["a"] = quantity(square);
  expected.names["b"] = quantity(Rational(-passing.t * square));
  expected.names["k"] = quantity(outside);
  expected.names["D"] = quantity(discriminant);
  expected.names["M"] = quantity(passing.nearest);
  expected.names["h"] = quantity(Surd::root(passing.heightSquared));
  if (passing.heightSquared == 0)
    expected.vanished.insert("it.h");
  if (passing.partSquared < 0) {
    expected.caseName = "miss";
    expected.values["contacts"] = "none";
    return expected;
  }
  addContacts(expected, S, L, passing);
  // Behind the start: outside, and the nearest point is passed already.
  expected.caseName = outside > 0 && passing.t < 0 ? "behind" : "hit";
  return expected;
}

void addRoots(std::vector<WrongAnswer> &all, const Rational &a, const Rational &b,
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

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto S = objectAs<SphereObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (S.radius == 0 || vanishes(L.direction))
    return all;
  const ExactVec3 w = L.origin - S.center;
  const Rational a = times(L.direction, L.direction);
  const Rational b = times(L.direction, w);
  const Rational radiusSquared = S.radius * S.radius;
  const Rational k = times(w, w) - radiusSquared;
  const Rational discriminant = b * b - a * k;
  addProduct(all, "a", L.direction, L.direction);
  addProduct(all, "b", L.direction, w);
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
    const Passing passing = passingOf(S, L);
    const Rational chord = radiusSquared - passing.heightSquared;
    Line half("s", Surd::root(chord), all);
    half.add("the root forgotten", chord);
    half.add("squares added", Surd::root(Rational(radiusSquared + passing.heightSquared)));
  }
  return all;
}

} // namespace

namespace expected {

Expected ray_sphere() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
