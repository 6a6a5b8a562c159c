#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {
namespace {

struct TwoVectors {
  explicit TwoVectors(Objects objects)
      : v(objectAs<VectorObject>(*objects[0])->vector), w(objectAs<VectorObject>(*objects[1])->vector),
        vw(product(v, w)) {}

  bool pointSomewhere() const { return !vanishes(v) && !vanishes(w); }
  bool areParallel() const { return pointSomewhere() && vanishes(perpendicular(v, w)); }

  ExactVec3 v, w;
  Rational vw;
};

bool pointSomewhere(const TwoVectors &at) { return at.pointSomewhere(); }
bool hasFirst(const TwoVectors &at) { return !vanishes(at.v); }
/// What is left of w, times v·v.
ExactVec3 rest(const TwoVectors &at) { return at.w * product(at.v, at.v) - at.v * at.vw; }
bool hasSecond(const TwoVectors &at) { return !vanishes(at.w); }

} // namespace

namespace claims {

Claims dot_product_projection() {
  return claimsAbout<TwoVectors>({
      {"{zero} is the zero vector: it points nowhere, so it makes no angle, and nothing can be projected "
       "onto it.",
       [](const TwoVectors &at, const Said &said) { return vanishes(said.at("zero") == "v" ? at.v : at.w); }},
      {"{v} and {w} point in the same direction: nothing is left across.",
       [](const TwoVectors &at) { return at.areParallel() && at.vw > 0; }},
      {"{v} and {w} point in opposite directions: nothing is left across.",
       [](const TwoVectors &at) { return at.areParallel() && at.vw < 0; }},
      {"{product}: the vectors are perpendicular, and the projections are zero.",
       [](const TwoVectors &at) { return at.pointSomewhere() && at.vw == 0; }},
      {"{product} is positive: the angle is smaller than 90°.",
       [](const TwoVectors &at) { return at.vw > 0; }},
      {"{product} is negative: the angle is larger than 90°, and the projections point backwards.",
       [](const TwoVectors &at) { return at.vw < 0; }},
      {"Multiply x by x, y by y and z by z, and add the three products.", always},
      {"θ{degrees}°: the angle between {v} and {w}.",
       [](const TwoVectors &at, const Said &said) {
         return at.pointSomewhere() && isAngleBetween(at.v, at.w, said.at("degrees"));
       }},
      {"This is how far {w} reaches along {v}. It is negative when {w} reaches backwards.", pointSomewhere},
      {"The arrow of length 1 in the direction of {v}.", hasFirst},
      {"The same number once more: with a unit vector there is nothing to divide by.", pointSomewhere},
      {"With a unit vector there is nothing to divide by.", hasFirst},
      {"{w} projected onto {v}: the shadow as an arrow.", hasFirst},
      {"{v} projected onto {w}.", hasSecond},
      {"What is left of {w} when its part along {v} is taken away.", hasFirst},
      {"Always 0: the rest is perpendicular to {v}.",
       [](const TwoVectors &at) { return hasFirst(at) && !vanishes(rest(at)); }},
      {"0, because nothing is left.",
       [](const TwoVectors &at) { return hasFirst(at) && vanishes(rest(at)); }},
  });
}

} // namespace claims
} // namespace halfspace::test
