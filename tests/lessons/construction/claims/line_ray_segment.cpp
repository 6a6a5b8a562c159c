#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

/// The point between two others, or beyond one of them, is told by the angle in which it sees them.
struct OnLine {
  explicit OnLine(Objects objects)
      : A(objectAs<LineObject>(*objects[0])->point), v(objectAs<LineObject>(*objects[0])->direction),
        P(objectAs<PointObject>(*objects[1])->at), Q(objectAs<PointObject>(*objects[2])->at) {}

  bool isLine() const { return !vanishes(v); }
  bool isOn(const ExactVec3 &X) const { return isLine() && vanishes(perpendicular(v, ExactVec3(A + v - X))); }
  bool isBetween(const ExactVec3 &X) const {
    return isOn(X) && product(ExactVec3(A - X), ExactVec3(A + v - X)) <= 0;
  }
  bool isBehind(const ExactVec3 &X) const { return isOn(X) && product(ExactVec3(X - A), v) < 0; }
  bool isBeyond(const ExactVec3 &X) const { return isOn(X) && product(ExactVec3(X - A - v), v) > 0; }

  static int axisOf(const std::string &text) { return text.front() - 'x'; }
  /// No point of the line has that coordinate of Q.
  bool isNever(int axis) const { return v[axis] == 0 && Q[axis] != A[axis]; }
  bool isNeverSomewhere() const { return isNever(0) || isNever(1) || isNever(2); }

  ExactVec3 A;
  ExactVec3 v;
  ExactVec3 P;
  ExactVec3 Q;
};

using At = OnLine;

bool isLine(const At &at) { return at.isLine(); }
bool isWalked(const At &at) { return at.isOn(at.P); }
int axisAt(const Said &said) { return At::axisOf(said.at("axis")); }

Claims caseClaims() {
  return claimsAbout<At>({
      {"{t}: {Q} lies on the segment from {A} to {B}.", [](const At &at) { return at.isBetween(at.Q); }},
      {"{t} is larger than 1: {Q} lies on the ray, beyond {B}.",
       [](const At &at) { return at.isBeyond(at.Q); }},
      {"{t} is negative: {Q} lies on the line {g}, behind {A}, where the ray never goes.",
       [](const At &at) { return at.isBehind(at.Q); }},
      {"No t leads from {A} to {Q}: it lies beside the line {g}.",
       [](const At &at) { return at.isLine() && !at.isOn(at.Q); }},
      {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
       [](const At &at) { return !at.isLine(); }},
  });
}

Claims walkClaims() {
  return claimsAbout<At>({
      {"One step from {A}: a point plus a vector is a point.", isLine},
      {"From {A} to {B}: a point minus a point is a vector.", isLine},
      {"From {A} so many steps {v} lead to {P}.", isWalked},
      {"The same point as a mixture of {A} and {B}.", isWalked},
      {"The weight of {A} and that of {B}. Together they make 1.", isWalked},
      {"Negative: {P} lies behind {A}, on the line but not on the ray.",
       [](const At &at) { return at.isBehind(at.P); }},
      {"Neither negative nor larger than 1: {P} lies on the segment.",
       [](const At &at) { return at.isBetween(at.P); }},
      {"Larger than 1: {P} lies beyond {B}, on the ray but not on the segment.",
       [](const At &at) { return at.isBeyond(at.P); }},
  });
}

Claims stepClaims() {
  return claimsAbout<At>({
      {"So many steps of {step} lead from {start} to {end}.",
       [](const At &at, const Said &said) {
         const int axis = said.line.back() - 'x';
         return at.v[axis] != 0;
       }},
      {"No step changes {axis}, and {end} is {start} already: every t is right here.",
       [](const At &at, const Said &said) {
         return at.isLine() && at.v[axisAt(said)] == 0 && !at.isNever(axisAt(said));
       }},
      {"No step changes {axis}, and {end} is not {start}: no t is right here.",
       [](const At &at, const Said &said) { return at.isLine() && at.isNever(axisAt(said)); }},
      {"One t is right for all coordinates: {Q} lies on the line.",
       [](const At &at) { return at.isOn(at.Q); }},
      {"Every point of the line has the {axis} of {A}, and {Q} has another: no t leads there.",
       [](const At &at, const Said &said) { return at.isLine() && at.isNever(axisAt(said)); }},
      {"They are not all the same: no t leads to {Q}.",
       [](const At &at) { return at.isLine() && !at.isOn(at.Q) && !at.isNeverSomewhere(); }},
  });
}

} // namespace

namespace claims {

Claims line_ray_segment() { return together({caseClaims(), walkClaims(), stepClaims()}); }

} // namespace claims
} // namespace halfspace::test
