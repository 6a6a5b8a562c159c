#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/ufo.h"
#include "tests/lessons/construction/expected/torpedo_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Given {
  UfoObject ufo;
  Rational frame;
  Rational seed;
};

Given read(Objects objects) {
  return {objectAs<UfoObject>(*objects[0]).value(), objectAs<NumberObject>(*objects[1])->value,
          objectAs<NumberObject>(*objects[2])->value};
}

/// The number of four digits nearest to length/√square, which is none itself.
Rational factorBy(const Rational &square, const Rational &length) {
  Rational unit = 1; // of its last digit
  const auto isAtMost = [&](const Rational &number) { return number * number * square <= length * length; };
  while (isAtMost(unit * 10'000))
    unit *= 10;
  while (!isAtMost(unit * 1000))
    unit /= 10;
  const int digits =
      largest(10'000, [&](const Rational &count) { return isAtMost((count - Rational(1, 2)) * unit); });
  return unit * digits;
}

ExactVec3 directionOf(const ExactVec3 &barrel, const Rational &barrelLength) {
  const Rational square = product(barrel, barrel);
  const auto length = rootOf(square);
  const Rational factor = length ? Rational(barrelLength / *length) : factorBy(square, barrelLength);
  ExactVec3 direction;
  for (int i = 0; i < 3; ++i)
    direction[i] = factor * barrel[i];
  return direction;
}

ExactVec3 startOf(const Given &given, const LastShot &shot) {
  return given.ufo.start + given.ufo.velocity * shot.frame / Rational(100);
}

Recomputed recompute(Objects objects) {
  const Given given = read(objects);
  const auto &[start, velocity, barrel, barrelLength] = given.ufo;
  const LastShot shot = lastShot(given.frame, given.seed, barrel);
  Recomputed expected;
  expected.names = {{"S", quantity(start)},
                    {"\\vec c", quantity(velocity)},
                    {"\\vec g", quantity(barrel)},
                    {"l", quantity(barrelLength)}};
  if (vanishes(velocity))
    expected.vanished.insert("U.c");
  if (vanishes(barrel))
    expected.vanished.insert("U.g");
  expected.degenerate = vanishes(shot.barrel) || barrelLength <= 0;
  expected.caseName = expected.degenerate ? "zero-direction" : given.seed == 0 ? "by-hand" : "seeded";
  if (expected.degenerate)
    return expected;
  const ExactVec3 Q = startOf(given, shot);
  const ExactVec3 r = directionOf(shot.barrel, barrelLength);
  expected.names["Q"] = quantity(Q);
  expected.names["\\vec r"] = quantity(r);
  expected.names["\\vec d"] = quantity(shot.barrel);
  expected.values = {{"start", numbers(Q)},
                     {"direction", numbers(r)},
                     {"length", SignedSquares{product(shot.barrel, shot.barrel)}}};
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Given given = read(objects);
  const LastShot shot = lastShot(given.frame, given.seed, given.ufo.barrel);
  std::vector<WrongAnswer> all;
  if (vanishes(shot.barrel) || given.ufo.barrelLength <= 0)
    return all;
  addLength(all, "length", shot.barrel);
  if (shot.frame != 0)
    addPointOnRay(all, "start", given.ufo.start, shot.frame / 100, given.ufo.velocity);
  return all;
}

} // namespace

namespace expected {

Expected torpedo_shot() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.1};
}

} // namespace expected
} // namespace halfspace::test
