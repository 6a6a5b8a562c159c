#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/screen.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// By Cramer's rule: P0 + a·u + b·v = Q + k·(X − Q).
struct Camera {
  explicit Camera(Objects objects)
      : Q(objectAs<PointObject>(*objects[0])->at), S(objectAs<ScreenObject>(*objects[1]).value()),
        X(objectAs<PointObject>(*objects[2])->at), back(Q - X), way(Q - S.corner),
        volume(determinant(S.u, S.v, back)), isScreen(!vanishes(perpendicular(S.u, S.v))),
        isCamera(determinant(S.u, S.v, way) != 0) {
    if (!isCamera || volume == 0)
      return;
    p = S.w * determinant(way, S.v, back) / volume;
    q = S.h * determinant(S.u, way, back) / volume;
    k = determinant(S.u, S.v, way) / volume;
    i = before(p, S.w);
    j = before(q, S.h);
  }

  /// The number of the pixel in which a place is; −1 where there is none.
  static int before(const Rational &place, const Rational &pixels) {
    for (int number = 0; number < pixels; ++number)
      if (number <= place && place < number + 1)
        return number;
    return -1;
  }

  bool hasImage() const { return isCamera && volume != 0; }
  bool isSeen() const { return hasImage() && k > 0 && i >= 0 && j >= 0; }
  ExactVec3 image() const { return Q * Rational(1 - k) + X * k; }
  /// The middle of two opposite corners of the pixel.
  ExactVec3 corner(int further) const {
    return S.corner + (S.u * S.h * Rational(i + further) + S.v * S.w * Rational(j + further)) / (S.w * S.h);
  }
  ExactVec3 centre() const { return (corner(0) + corner(1)) / Rational(2); }
  /// As far from the image as the pixel's centre is, enlarged.
  ExactVec3 passing() const { return X + ExactVec3(centre() - image()) / k; }

  ExactVec3 Q;
  ScreenObject S;
  ExactVec3 X;
  ExactVec3 back;
  ExactVec3 way;
  Rational volume;
  bool isScreen;
  bool isCamera;
  Rational p, q, k;
  int i = -1;
  int j = -1;
};

std::string caseOf(const Camera &at) {
  return !at.isScreen     ? "no-screen"
         : !at.isCamera   ? "eye-in-screen"
         : !at.hasImage() ? "level"
         : at.k < 0       ? "behind"
         : at.isSeen()    ? "seen"
                          : "beside";
}

void addPixel(Recomputed &expected, const Camera &at) {
  const ExactVec3 r = at.centre() - at.Q;
  const Rational t = 1 / at.k;
  const Rational width = product(at.S.u, at.S.u) * t * t / (at.S.w * at.S.w); // squared
  expected.vanished.insert("it.L.Q"); // the eye, which is drawn as itself
  expected.values["column"] = number(at.i);
  expected.values["row"] = number(at.j);
  expected.values["corner"] = numbers(at.corner(0));
  expected.values["centre"] = numbers(at.centre());
  expected.values["direction"] = numbers(r);
  expected.values["t"] = number(t);
  expected.values["passing"] = numbers(at.passing());
  expected.values["through"] = at.centre() == at.image() ? "yes" : "no";
  expected.values["patch"] = SignedSquares{width};
  expected.names.insert({{"i", quantity(Rational(at.i))},
                         {"j", quantity(Rational(at.j))},
                         {"A", quantity(at.corner(0))},
                         {"C", quantity(at.centre())},
                         {"\\vec r", quantity(r)},
                         {"t", quantity(t)},
                         {"H", quantity(at.passing())}});
}

Recomputed recompute(Objects objects) {
  const Camera at(objects);
  const ExactVec3 n = perpendicular(at.S.u, at.S.v);
  Recomputed expected;
  expected.caseName = caseOf(at);
  expected.degenerate = !at.isCamera;
  expected.names = {{"Q", quantity(at.Q)},          {"X", quantity(at.X)},
                    {"P_0", quantity(at.S.corner)}, {"\\vec u", quantity(at.S.u)},
                    {"\\vec v", quantity(at.S.v)},  {"w", quantity(at.S.w)},
                    {"h", quantity(at.S.h)},        {"\\vec n", quantity(n)}};
  if (vanishes(at.S.u))
    expected.vanished.insert("S.u");
  if (vanishes(at.S.v))
    expected.vanished.insert("S.v");
  if (at.isScreen)
    expected.values["normal"] = numbers(n);
  if (!at.hasImage())
    return expected;
  expected.values["k"] = number(at.k);
  expected.values["image"] = numbers(at.image());
  expected.values["p"] = number(at.p);
  expected.values["q"] = number(at.q);
  expected.names.insert(
      {{"k", quantity(at.k)}, {"X'", quantity(at.image())}, {"p", quantity(at.p)}, {"q", quantity(at.q)}});
  if (at.p == 0)
    expected.vanished.insert("it.p");
  if (at.q == 0)
    expected.vanished.insert("it.q");
  if (at.isSeen())
    addPixel(expected, at);
  return expected;
}

/// w times the dot product of the way to the image with an edge, over the edge's square.
void addPixels(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &way, const ExactVec3 &edge,
               const Rational &pixels) {
  const Rational top = times(way, edge);
  const Rational square = times(edge, edge);
  Line line(id, Rational(pixels * top / square), all);
  line.addRatio("the pixels forgotten", top, square);
  line.addRatio("divided by the pixels", top, Rational(square * pixels));
  line.add("not divided", Rational(pixels * top));
  line.addOverRoot("divided by the length", Rational(pixels * top), square);
  line.addRatio("upside down", Rational(pixels * square), top);
}

void addPixelOf(std::vector<WrongAnswer> &all, const Camera &at) {
  for (const auto &[id, number, place] : {std::tuple("column", at.i, at.p), {"row", at.j, at.q}}) {
    Line line(id, Rational(number), all);
    line.add("counted from 1", Rational(number + 1));
    line.add("not cut off", place);
  }
  addVector(all, "corner", "the other end of the pixel", at.corner(1), at.corner(0));
  addVector(all, "centre", "the corner", at.corner(0), at.centre());
  addVector(all, "centre", "the other end of the pixel", at.corner(1), at.centre());
  addVector(all, "direction", "reversed", ExactVec3(at.Q - at.centre()), ExactVec3(at.centre() - at.Q));
  addVector(all, "direction", "added", ExactVec3(at.Q + at.centre()), ExactVec3(at.centre() - at.Q));
  addPointOnRay(all, "passing", at.Q, Rational(1 / at.k), ExactVec3(at.centre() - at.Q));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Camera at(objects);
  std::vector<WrongAnswer> all;
  if (!at.hasImage())
    return all;
  const ExactVec3 n = perpendicular(at.S.u, at.S.v);
  addParameter(all, "k", n, at.S.corner, {at.Q, ExactVec3(at.X - at.Q)});
  addPointOnRay(all, "image", at.Q, at.k, ExactVec3(at.X - at.Q));
  if (times(at.S.u, at.S.v) == 0) {
    addPixels(all, "p", ExactVec3(at.image() - at.S.corner), at.S.u, at.S.w);
    addPixels(all, "q", ExactVec3(at.image() - at.S.corner), at.S.v, at.S.h);
  }
  if (at.isSeen())
    addPixelOf(all, at);
  return all;
}

} // namespace

namespace expected {

Expected camera_ray() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
