#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/segment.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct SegmentAtPlane {
  explicit SegmentAtPlane(Objects objects)
      : s(objectAs<SegmentObject>(*objects[0]).value()), E(objectAs<PlaneObject>(*objects[1]).value()),
        a(product(E.normal, s.from) - product(E.normal, E.point)),
        b(product(E.normal, s.to) - product(E.normal, E.point)) {}

  bool isPlane() const { return !vanishes(E.normal); }
  bool isSegment() const { return s.from != s.to; }
  bool areBoth() const { return isPlane() && isSegment(); }
  /// The line of the segment has one point in the plane.
  bool isAcross() const { return product(E.normal, ExactVec3(s.to - s.from)) != 0; }
  bool isInside() const { return isAcross() && a * b <= 0; }
  /// f at the end that a sentence names.
  const Rational &at(const Said &said) const { return said.at("end") == "A" ? a : b; }

  SegmentObject s;
  PlaneObject E;
  Rational a, b;
};

} // namespace

namespace claims {

Claims segment_plane() {
  using At = SegmentAtPlane;
  return claimsAbout<At>({
      {"{f_A} and {f_B} have different signs: the segment {s} crosses the plane {E} in {point}.",
       [](const At &at) { return at.areBoth() && at.a * at.b < 0; }},
      {"f({end}) = 0: the segment {s} touches the plane {E} with its end {end} alone.",
       [](const At &at, const Said &said) { return at.areBoth() && at.at(said) == 0 && at.a + at.b != 0; }},
      {"{f_A} and {f_B} have the same sign: the whole segment {s} is on one side of the plane {E} and does "
       "not "
       "reach it.",
       [](const At &at) { return at.areBoth() && at.a * at.b > 0; }},
      {"{f_A}, and f({B}) is the same number: the segment {s} is parallel to the plane {E}.",
       [](const At &at) { return at.areBoth() && !at.isAcross() && at.a == at.b && at.a != 0; }},
      {"f is 0 all along the segment {s}: it lies in the plane {E}.",
       [](const At &at) { return at.areBoth() && at.a == 0 && at.b == 0; }},
      {"{A} and {B} are the same point: the segment {s} has no length.",
       [](const At &at) { return !at.isSegment(); }},
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const At &at) { return !at.isPlane(); }},
      {"Positive: {end} lies on the side that {n} points to.",
       [](const At &at, const Said &said) { return at.at(said) > 0; }},
      {"Negative: {end} lies on the side that {n} points away from.",
       [](const At &at, const Said &said) { return at.at(said) < 0; }},
      {"0: {end} lies in the plane.",
       [](const At &at, const Said &said) { return at.isPlane() && at.at(said) == 0; }},
      // Away from the plane f grows in size.
      {"Negative: the line of the segment meets the plane before {A}.",
       [](const At &at) { return at.isAcross() && at.a * at.b > 0 && abs(at.a) < abs(at.b); }},
      {"More than 1: the line of the segment meets the plane behind {B}.",
       [](const At &at) { return at.isAcross() && at.a * at.b > 0 && abs(at.a) > abs(at.b); }},
      {"0 is {A}, and 1 is {B}: it is an end that lies in the plane.",
       [](const At &at) { return at.isAcross() && at.a * at.b == 0; }},
      {"Between 0 and 1: this part of the way from {A} to {B} leads to the plane.",
       [](const At &at) { return at.isAcross() && at.a * at.b < 0; }},
      {"The only point that the segment and the plane share.", [](const At &at) { return at.isInside(); }},
  });
}

} // namespace claims
} // namespace halfspace::test
