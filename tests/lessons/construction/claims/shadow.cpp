#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

/// By the sides of the plane on which things lie, and how far from it.
struct Lights {
  explicit Lights(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        A(objectAs<PointObject>(*objects[2])->at), B(objectAs<PointObject>(*objects[3])->at),
        C(objectAs<PointObject>(*objects[4])->at), r(objectAs<VectorObject>(*objects[5])->vector) {}

  Rational f(const ExactVec3 &point) const { return product(E.normal, ExactVec3(point - E.point)); }
  bool isPlane() const { return !vanishes(E.normal); }
  bool isSun() const { return isPlane() && !vanishes(r); }
  int along() const { return product(E.normal, r).sign(); }
  /// Whether a step of the light, or none, leads from the point towards the plane.
  bool isSunny(const ExactVec3 &point) const { return along() != 0 && f(point).sign() * along() <= 0; }
  bool isSunny() const { return isSunny(A) && isSunny(B) && isSunny(C); }
  /// Whether the point is on the lamp's side, nearer to the plane; or in the plane.
  bool isLampLit(const ExactVec3 &point) const {
    return f(Q) != 0 && f(point) * f(Q) >= 0 && abs(f(point)) < abs(f(Q));
  }
  bool isLampLit() const { return isLampLit(A) && isLampLit(B) && isLampLit(C); }

  ExactVec3 midpoint() const { return ExactVec3(A + B) / Rational(2); }
  /// The point that a line is about, by the letter at its end.
  ExactVec3 named(const Said &said) const {
    switch (said.line.back()) {
    case 'A':
      return A;
    case 'B':
      return B;
    case 'C':
      return C;
    default:
      return midpoint();
    }
  }
  /// On the line from the lamp: weighted by how far both are from the plane.
  ExactVec3 lampPlace(const ExactVec3 &point) const {
    return (Q * f(point) - point * f(Q)) / Rational(f(point) - f(Q));
  }
  bool hasPart() const {
    return isPlane() && f(Q) != 0 && f(A) != f(Q) && f(B) != f(Q) && f(midpoint()) != f(Q);
  }
  bool isOneLine() const { return vanishes(perpendicular(ExactVec3(A - Q), ExactVec3(B - Q))); }
  /// How much nearer to the place of A than to that of B the place of M is, squared.
  Rational nearness() const {
    const ExactVec3 toA = lampPlace(A) - lampPlace(midpoint());
    const ExactVec3 toB = lampPlace(B) - lampPlace(midpoint());
    return product(toB, toB) - product(toA, toA);
  }

  PlaneObject E;
  ExactVec3 Q;
  ExactVec3 A;
  ExactVec3 B;
  ExactVec3 C;
  ExactVec3 r;
};

using At = Lights;

Claims claimsOfSun() {
  return claimsAbout<At>({
      {"Negative: the sunlight goes against {n}.", [](const At &at) { return at.along() < 0; }},
      {"Positive: the sunlight goes to the side that {n} points to.",
       [](const At &at) { return at.along() > 0; }},
      {"Zero: the sunlight runs along the plane and comes no nearer to it.",
       [](const At &at) { return at.isSun() && at.along() == 0; }},
      {"It takes this many steps {r} to get from {point} to the plane.",
       [](const At &at, const Said &said) { return at.f(at.named(said)).sign() * at.along() < 0; }},
      {"Negative: on its way the light gets to the plane before it comes to {point}.",
       [](const At &at, const Said &said) { return at.f(at.named(said)).sign() * at.along() > 0; }},
      {"0: {point} lies in the plane.",
       [](const At &at, const Said &said) { return at.isSun() && at.f(at.named(said)) == 0; }},
      {"Here the sun throws the shadow of {point}.",
       [](const At &at, const Said &said) { return at.isSunny(at.named(said)); }},
      {"Here the light gets to the plane before it comes to {point}: this is no shadow.",
       [](const At &at, const Said &said) { return at.along() != 0 && !at.isSunny(at.named(said)); }},
      {"The midpoint of the edge from {A} to {B}.", always},
      {"The mean of both: half-way along the edge, half of the change.",
       [](const At &at) { return at.along() != 0; }},
      {"The midpoint of {from} and {to}.", [](const At &at) { return at.along() != 0; }},
  });
}

Claims claimsOfLamp() {
  return claimsAbout<At>({
      {"Negative: the ray from {Q} to {point} leads away from the plane.",
       [](const At &at, const Said &said) {
         const Rational f = at.f(at.named(said));
         return f * at.f(at.Q) > 0 && abs(f) > abs(at.f(at.Q));
       }},
      {"0: {Q} lies in the plane.", [](const At &at) { return at.isPlane() && at.f(at.Q) == 0; }},
      {"Smaller than 1: the ray gets to the plane before it comes to {point}.",
       [](const At &at, const Said &said) { return at.f(at.named(said)) * at.f(at.Q) < 0; }},
      {"1: {point} lies in the plane.",
       [](const At &at, const Said &said) { return at.isPlane() && at.f(at.named(said)) == 0; }},
      {"It takes this many steps, each as long as the way from {Q} to {point}.",
       [](const At &at, const Said &said) {
         return at.isLampLit(at.named(said)) && at.f(at.named(said)) != 0;
       }},
      {"Here the lamp throws the shadow of {point}.",
       [](const At &at, const Said &said) { return at.isLampLit(at.named(said)); }},
      {"Only the line backwards from {Q} gets to the plane here: this is no shadow.",
       [](const At &at, const Said &said) {
         const Rational f = at.f(at.named(said));
         return f * at.f(at.Q) > 0 && abs(f) > abs(at.f(at.Q));
       }},
      {"Here the ray gets to the plane before it comes to {point}: this is no shadow.",
       [](const At &at, const Said &said) {
         const Rational f = at.f(at.named(said));
         return f * at.f(at.Q) < 0 || (at.f(at.Q) == 0 && f != 0);
       }},
      {"One half: measured along {n}, {A} and {B} are equally far from {Q}.",
       [](const At &at) { return at.hasPart() && at.f(at.A) == at.f(at.B); }},
      {"This part of the way from {from} to {to} leads to {middle}.",
       [](const At &at) { return at.hasPart() && at.f(at.A) != at.f(at.B); }},
      {"It is the same point as {from} and {to}.",
       [](const At &at) { return at.hasPart() && at.isOneLine(); }},
      {"The middle between {from} and {to}.", [](const At &at) { return at.nearness() == 0; }},
      {"Nearer to {from} than to {to}, so not the middle.", [](const At &at) { return at.nearness() > 0; }},
      {"Nearer to {to} than to {from}, so not the middle.", [](const At &at) { return at.nearness() < 0; }},
  });
}

} // namespace

namespace claims {

Claims shadow() {
  return together({claimsAbout<At>({
                       {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
                        [](const At &at) { return !at.isPlane(); }},
                       {"{r} is the zero vector: the sunlight has no direction.",
                        [](const At &at) { return vanishes(at.r); }},
                       {"The sun and the lamp throw shadows of {A}, {B} and {C} onto the plane.",
                        [](const At &at) { return at.isSunny() && at.isLampLit(); }},
                       {"The sun throws shadows of {A}, {B} and {C} onto the plane. The lamp does not throw "
                        "all three.",
                        [](const At &at) { return at.isSunny() && !at.isLampLit(); }},
                       {"The lamp throws shadows of {A}, {B} and {C} onto the plane. The sun does not throw "
                        "all three.",
                        [](const At &at) { return !at.isSunny() && at.isLampLit(); }},
                       {"Neither the sun nor the lamp throws shadows of all three corners onto the plane.",
                        [](const At &at) { return !at.isSunny() && !at.isLampLit(); }},
                   }),
                   claimsOfSun(), claimsOfLamp()});
}

} // namespace claims
} // namespace halfspace::test
