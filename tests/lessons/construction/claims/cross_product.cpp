#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {
namespace {

struct Spanned {
  explicit Spanned(Objects objects)
      : u(objectAs<VectorObject>(*objects[0])->vector), v(objectAs<VectorObject>(*objects[1])->vector) {}

  const ExactVec3 &named(const std::string &letter) const { return letter == "u" ? u : v; }
  /// Whether one of them is so many times the other, however many.
  bool areOnOneLine() const { return product(u, v) * product(u, v) == product(u, u) * product(v, v); }
  bool pointSomewhere() const { return !vanishes(u) && !vanishes(v); }

  ExactVec3 u, v;
};

bool isProper(const Spanned &at) { return !at.areOnOneLine(); }
bool isFlat(const Spanned &at) { return at.areOnOneLine(); }
bool isFlatAndNotZero(const Spanned &at) { return at.areOnOneLine() && at.pointSomewhere(); }

} // namespace

namespace claims {

Claims cross_product() {
  return claimsAbout<Spanned>({
      {"n is perpendicular to {u} and to {v}, and its length is the area of their parallelogram.", isProper},
      {"{zero} is the zero vector, and so is the cross product: there is no parallelogram.",
       [](const Spanned &at, const Said &said) { return vanishes(at.named(said.at("zero"))); }},
      {"{u} and {v} point in the same direction: their cross product is the zero vector, which points "
       "nowhere.",
       [](const Spanned &at) { return isFlatAndNotZero(at) && product(at.u, at.v) > 0; }},
      {"{u} and {v} point in opposite directions: their cross product is the zero vector, which points "
       "nowhere.",
       [](const Spanned &at) { return isFlatAndNotZero(at) && product(at.u, at.v) < 0; }},
      {"The first coordinate takes y and z, the second z and x, the third x and y.", always},
      {"The zero vector: {u} and {v} lie along one line.", isFlat},
      {"0, because n is perpendicular to {vector}.",
       [](const Spanned &at, const Said &said) {
         const ExactVec3 n = perpendicular(at.u, at.v);
         return !vanishes(n) && product(n, at.named(said.at("vector"))) == 0;
       }},
      {"0, because n is the zero vector.", isFlat},
      {"The area of the parallelogram of {u} and {v}.", isProper},
      {"0: there is no parallelogram, only a line or a point.", isFlat},
      {"The height of the parallelogram over {u}: its area divided by its base.", isProper},
      {"The triangle of {u} and {v} is half of it.", isProper},
      {"The square of the area, from three dot products.", always},
      {"θ{degrees}°: the angle between {u} and {v}. The angle 180° − θ has the same sine.",
       [](const Spanned &at, const Said &said) {
         return at.pointSomewhere() && isAngleBetween(at.u, at.v, said.at("degrees"));
       }},
      {"The opposite vector: in each coordinate the two products have changed places.",
       [](const Spanned &at) {
         return isProper(at) && vanishes(ExactVec3(perpendicular(at.u, at.v) + perpendicular(at.v, at.u)));
       }},
      {"The zero vector in this order, too.", isFlat},
      {"It is perpendicular to n, and to {u}.", isProper},
      {"The zero vector, because n is the zero vector.", isFlat},
      {"The same vector, put together from {u} and {v}: so it lies in their plane.", isProper},
      {"{u} after a quarter turn about n. It is as long as {u}.", isProper},
  });
}

} // namespace claims
} // namespace halfspace::test
