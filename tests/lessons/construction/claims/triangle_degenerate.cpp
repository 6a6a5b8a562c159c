#include "tests/lessons/construction/claims/said_angle.h"
#include "tests/lessons/construction/claims/triangle_words.h"

namespace halfspace::test {
namespace {

bool isProper(const TriangleCorners &at) { return at.isTriangle(); }
bool isNone(const TriangleCorners &at) { return !at.isTriangle(); }
bool hasAngle(const TriangleCorners &at) { return !vanishes(at.u) && !vanishes(at.v); }

/// The square of the cosine, with the cosine's sign.
Rational cosineOf(const TriangleCorners &at) {
  return signedSquare(product(at.u, at.v), product(at.u, at.u) * product(at.v, at.v));
}

/// An angle whose cosine's square is a fraction has a number of degrees that can be written for these alone
/// (Niven, Irrational Numbers, corollary 3.12): 0, 30, 45, 60, 90 and what is left of them to 180.
bool isWrittenExactly(const TriangleCorners &at) {
  const Rational square = abs(cosineOf(at));
  return Rational(square * 4).denominator() == 1 || square == Rational(1, 2);
}

/// Whether the test of a line finds that something is wrong with the corners.
bool isSeen(const TriangleCorners &at, const Said &said) {
  if (said.line == "test-u")
    return vanishes(at.u);
  if (said.line == "test-v")
    return vanishes(at.v);
  return said.line == "test-squares" ? !at.isTriangle() : cosineOf(at) == 1;
}

} // namespace

namespace claims {

Claims triangle_degenerate() {
  const Claims own = claimsAbout<TriangleCorners>({
      {"{P0}, {P1} and {P2} are the corners of a triangle: u and v point along different lines.", isProper},
      {"{P0}, {P1} and {P2} lie on one line, and u and v point in opposite directions: this is no triangle.",
       [](const TriangleCorners &at) { return at.isCollinear() && product(at.u, at.v) < 0; }},
      {"{P0}, {P1} and {P2} lie on one line, and u and v point in the same direction: this is no triangle.",
       [](const TriangleCorners &at) { return at.isCollinear() && product(at.u, at.v) > 0; }},
      {"Two sides, both from {P0}.", always},
      {"The two lengths: for the cosine the dot product is divided by them.", hasAngle},
      {"0: nothing can be divided by it, so there is no cosine.",
       [](const TriangleCorners &at) { return !hasAngle(at); }},
      {"θ{degrees}°: the angle between u and v.",
       [](const TriangleCorners &at, const Said &said) {
         return hasAngle(at) && isAngleBetween(at.u, at.v, said.at("degrees")) &&
                isWrittenExactly(at) == (said.at("degrees").find('=') != std::string::npos);
       }},
      {"Not 0: a triangle. G is the denominator of s and t.", isProper},
      {"0: no triangle. G would be the denominator of s and t.", isNone},
      {"Lagrange's identity. It is −G: so G is 0 exactly where u × v is the zero vector.", always},
      {"It finds nothing wrong, and nothing is.",
       [](const TriangleCorners &at, const Said &said) { return at.isTriangle() && !isSeen(at, said); }},
      {"It sees that something is wrong: {P0}, {P1} and {P2} lie on one line.",
       [](const TriangleCorners &at, const Said &said) { return at.isCollinear() && isSeen(at, said); }},
      {"It is blind: {first} and {second} are the same point, and this test misses it.",
       [](const TriangleCorners &at, const Said &said) {
         return areSamePoint(at, said) && !isSeen(at, said);
       }},
      {"It is blind: {P0}, {P1} and {P2} lie on one line, and this test misses it.",
       [](const TriangleCorners &at, const Said &said) { return at.isCollinear() && !isSeen(at, said); }},
  });
  return together(
      {own,
       coincidenceClaims("{first} and {second} are the same point: this is no triangle.",
                         "{first}, {second} and {third} are the same point: this is no triangle."),
       coincidenceClaims("It sees that something is wrong: {first} and {second} are the same point.",
                         "It sees that something is wrong: {first}, {second} and {third} are the same point.",
                         isSeen),
       coincidenceClaims("There is no cosine, so this test cannot be made: {first} and {second} are the same "
                         "point.",
                         "There is no cosine, so this test cannot be made: {first}, {second} and {third} are "
                         "the same point.",
                         [](const TriangleCorners &at, const Said &) { return !hasAngle(at); }),
       crossProductClaims()});
}

} // namespace claims
} // namespace halfspace::test
