#include "tests/lessons/construction/expected/bodies.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// The base of a prism; nothing of other solids.
CornerList baseOf(const Object &solid) {
  CornerList base;
  for (const std::size_t corner : halfspace::cornersOf(solid))
    base.push_back(solid[corner]);
  return base;
}

/// By base and height, without tetrahedra: a·b·c of a box, the base of a prism times its height, and of a
/// tetrahedron a third of that, where the base is half a parallelogram.
Rational sixTimesVolume(const Object &solid) {
  if (kindOf(solid) == "box")
    return 6 * solid[1].x * solid[2].x * solid[3].x;
  if (kindOf(solid) == "tetrahedron")
    return abs(product(perpendicular(ExactVec3(solid[2] - solid[1]), ExactVec3(solid[3] - solid[1])),
                       ExactVec3(solid[0] - solid[1])));
  return 3 * abs(product(twiceAreaOf(baseOf(solid)), solid[1]));
}

std::string caseOf(const Object &solid, const Body &body) {
  if (areInOnePlane(body.corners))
    return "flat";
  const CornerList base = baseOf(solid);
  if (base.empty())
    return "solid";
  return !areInOnePlane(base) ? "not-planar" : doesBoundaryMeetItself(base) ? "self-meeting" : "solid";
}

/// The triangles of the faces that do not have the first corner, as the ways to their corners.
std::vector<std::array<ExactVec3, 3>> trianglesOf(const Body &body) {
  std::vector<std::array<ExactVec3, 3>> triangles;
  for (const Face &face : body.faces) {
    if (std::find(face.begin(), face.end(), 0U) != face.end())
      continue;
    const CornerList corners = cornersOf(body, face);
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back(
          {corners[0] - body.corners[0], corners[i - 1] - body.corners[0], corners[i] - body.corners[0]});
  }
  return triangles;
}

Recomputed recompute(Objects objects) {
  const Object &solid = *objects[0];
  const Body body = bodyOf(solid);
  Recomputed expected;
  expected.caseName = caseOf(solid, body);
  expected.degenerate = expected.caseName != "solid";
  expected.names = body.names;
  if (expected.caseName == "not-planar")
    return expected;
  std::size_t index = 0;
  for (const auto &[a, b, c] : trianglesOf(body))
    expected.names[numbered("D", ++index)] = quantity(determinant(a, b, c));
  const Rational volume = sixTimesVolume(solid) / 6;
  expected.values["volume"] = number(volume);
  expected.names["V"] = quantity(volume);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Object &solid = *objects[0];
  const Body body = bodyOf(solid);
  std::vector<WrongAnswer> all;
  if (caseOf(solid, body) != "solid")
    return all;
  std::size_t index = 0;
  for (const auto &[a, b, c] : trianglesOf(body)) {
    const Rational value = determinant(a, b, c);
    Line line("det" + std::to_string(++index), value, all);
    line.add("the sign lost", Rational(-value));
    for (int i = 0; i < 3; ++i) {
      const Rational falls = a[i] * b[(i + 1) % 3] * c[(i + 2) % 3];
      const Rational rises = a[i] * b[(i + 2) % 3] * c[(i + 1) % 3];
      line.add("a product with plus dropped", Rational(value - falls));
      line.add("a product with minus dropped", Rational(value + rises));
    }
  }
  const Rational six = sixTimesVolume(solid);
  Line volume("volume", Rational(six / 6), all);
  volume.add("not divided", six);
  volume.add("a third", Rational(six / 3));
  volume.add("a half", Rational(six / 2));
  volume.add("the sign lost", Rational(-six / 6));
  return all;
}

} // namespace

namespace expected {

Expected solid_volume() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.2};
}

} // namespace expected
} // namespace halfspace::test
