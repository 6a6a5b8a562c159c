#include "tests/lessons/construction/claims/ray_at_triangle.h"

namespace halfspace::test {
namespace {

/// What the notes print about a triangle and a ray. A line that says nothing here is not refuted.
struct PrintedLines : RayAtTriangle {
  explicit PrintedLines(Objects objects)
      : RayAtTriangle(objects), uu(product(u, u)), vv(product(v, v)), uv(product(u, v)),
        D(product(n, corners[0])) {}

  bool hasAngle() const { return uu != 0 && vv != 0; }

  /// D − ax + by + cz is ax + by + cz − D exactly when ax is D.
  bool isDistanceRefuted() const { return isTriangle() && n.x * L.origin.x != D; }
  /// (u·v)v − (v·u)u is (u·u)v − (v·u)u exactly when u·v is u·u, or v is zero.
  bool isPerpRefuted() const { return vv != 0 && uv != uu; }
  bool isCosineRefuted() const { return hasAngle() && !isTriangle() && uv < 0; }
  bool isFacingRefuted() const { return crosses() && rn > 0; }
  bool isDirectionRefuted() const { return isTriangle() && D < 0; }
  bool isOnEdgeLine() const {
    const auto all = weights();
    return std::find(all.begin(), all.end(), Rational(0)) != all.end();
  }
  bool isPerimeterRefuted() const { return misses() && isOnEdgeLine(); }
  bool isCorner() const {
    const auto all = weights();
    return std::count(all.begin(), all.end(), Rational(0)) == 2;
  }
  bool isVertexRefuted() const { return crosses() && isCorner(); }
  bool isStartRefuted() const { return isBehind(); }

  long refuted() const {
    const std::array all{isDistanceRefuted(),  isPerpRefuted(),      isCosineRefuted(), isFacingRefuted(),
                         isDirectionRefuted(), isPerimeterRefuted(), isVertexRefuted(), isStartRefuted()};
    return std::count(all.begin(), all.end(), true);
  }

  Rational uu, vv, uv;
  Rational D;
};

bool isTriangle(const PrintedLines &at) { return at.isTriangle(); }
bool crosses(const PrintedLines &at) { return at.crosses(); }
bool hits(const PrintedLines &at) { return at.hits(); }
bool isBehind(const PrintedLines &at) { return at.isBehind(); }
bool misses(const PrintedLines &at) { return at.misses(); }

/// The verdict is about the distance or about the perp, as its line is.
bool isRefuted(const PrintedLines &at, const Said &said) {
  return said.line == "distance-printed" ? at.isDistanceRefuted() : at.isPerpRefuted();
}
bool isNotRefuted(const PrintedLines &at, const Said &said) { return !isRefuted(at, said); }

} // namespace

namespace claims {

Claims misprints() {
  const Claims own = claimsAbout<PrintedLines>({
      {"No printed line is refuted here.", [](const PrintedLines &at) { return at.refuted() == 0; }},
      {"Printed lines refuted here: {count}.",
       [](const PrintedLines &at, const Said &said) {
         return said.at("count") == std::to_string(at.refuted()) && at.refuted() > 0;
       }},
      {"The triangle is behind the ray: only its line goes through, at {lambda}. {count}", isBehind},
      {"The line of the ray meets the plane outside the triangle. {count}", misses},
      {"{r}·n = 0: the ray is parallel to the plane, or lies in it. {count}",
       [](const PrintedLines &at) { return at.isTriangle() && at.isRay() && at.rn == 0; }},
      {"{P0}, {P1} and {P2} lie on one line. {count}",
       [](const PrintedLines &at) { return at.isCollinear(); }},
      {"Two sides of the triangle, both from {P0}.", always},
      {"A normal of the triangle's plane, and its three numbers.", isTriangle},
      {"The same for every point of the plane.", isTriangle},
      {"As printed. {verdict}", always},
      {"Here it comes to the right result. That proves nothing.", isNotRefuted},
      {"Here it comes to the right result, {right}. That proves nothing.", isNotRefuted},
      {"Refuted: the two results differ.", isRefuted},
      {"Refuted: {printed} ≠ {right}.",
       [](const PrintedLines &at, const Said &said) {
         return isRefuted(at, said) && said.at("printed") != said.at("right");
       }},
      {"Right. Divided by |n|, it is the signed distance.", isTriangle},
      {"The foot of {Q} in the plane.", isTriangle},
      {"Right: the first bracket has the two outer vectors.", always},
      {"It is −1, not 1: by the printed test the corners are not on one line. Refuted: they are.",
       [](const PrintedLines &at) { return at.isCosineRefuted(); }},
      {"It is 1, and the corners are on one line. Here the printed test is right.",
       [](const PrintedLines &at) { return at.hasAngle() && !at.isTriangle() && at.uv > 0; }},
      {"It is not 1, and the corners are not on one line. Here the printed test is right.", isTriangle},
      {"Right: {left} against {right}. They are equal exactly when the corners lie on one line, whether the "
       "cosine is 1 or −1.",
       [](const PrintedLines &at) { return at.hasAngle(); }},
      {"One of the three conditions holds, so the note says: on the perimeter. Refuted: {I} is on the line "
       "of an edge, but outside the triangle.",
       [](const PrintedLines &at) { return at.isPerimeterRefuted(); }},
      {"At least one of the three conditions holds, and {I} is on the perimeter. Here the note is right.",
       [](const PrintedLines &at) { return at.crosses() && at.isOnEdgeLine() && !at.misses(); }},
      {"None of the three conditions holds, and {I} is not on the perimeter. Here the note is right.",
       [](const PrintedLines &at) { return at.crosses() && !at.isOnEdgeLine(); }},
      {"Two are 0, and the third is 1. The note asks for a number between 0 and 1, and finds no corner. "
       "Refuted: {I} is one.",
       [](const PrintedLines &at) { return at.isVertexRefuted(); }},
      {"{I} is no corner, and the note finds none. Here it is right.",
       [](const PrintedLines &at) { return at.crosses() && !at.isCorner(); }},
      {"The note does not look at it and says: hit. Refuted: it is negative, and the ray leads away from the "
       "triangle.",
       isBehind},
      {"Not negative: the ray gets there. Here it does no harm that the note does not look at it.", hits},
      {"The line passes outside the triangle anyway. Here the note is right.", misses},
      {"Where the line of the ray goes through the plane.", crosses},
      {"Negative: the line of the ray comes from the side to which n points. The note takes n, and here it "
       "is right.",
       [](const PrintedLines &at) { return at.crosses() && at.rn < 0; }},
      {"Positive: the line of the ray goes to the side to which n points. The note takes n even so. Refuted.",
       [](const PrintedLines &at) { return at.isFacingRefuted(); }},
      {"Right: n itself.", [](const PrintedLines &at) { return at.crosses() && at.rn < 0; }},
      {"Right: the opposite of n.", [](const PrintedLines &at) { return at.isFacingRefuted(); }},
      {"D = 0: the plane goes through O, and the distance is 0.",
       [](const PrintedLines &at) { return at.isTriangle() && at.D == 0; }},
      {"From O to B it is a positive multiple of n. The notes say so, and here it is right.",
       [](const PrintedLines &at) { return at.isTriangle() && at.D > 0; }},
      {"From O to B it is a negative multiple of n: the opposite direction. Refuted.",
       [](const PrintedLines &at) { return at.isDirectionRefuted(); }},
  });
  return together(
      {own,
       placeClaims(hits, "The ray hits inside the triangle, at {lambda}. {count}",
                   "The ray hits on the edge {edge}, at {lambda}. {count}",
                   "The ray hits at the corner {corner}, at {lambda}. {count}"),
       coincidenceClaims("{first} and {second} are the same point: this is no triangle.",
                         "{first}, {second} and {third} are the same point: this is no triangle."),
       zeroDirectionClaims(1)});
}

} // namespace claims
} // namespace halfspace::test
