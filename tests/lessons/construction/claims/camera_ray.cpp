#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/screen.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

/// By volumes of u, v and a way from the eye: how far a place is from the eye, across the screen.
struct Camera {
  explicit Camera(Objects objects)
      : Q(objectAs<PointObject>(*objects[0])->at), S(objectAs<ScreenObject>(*objects[1]).value()),
        X(objectAs<PointObject>(*objects[2])->at), toScreen(determinant(S.u, S.v, ExactVec3(S.corner - Q))),
        toX(determinant(S.u, S.v, ExactVec3(X - Q))) {}

  bool isScreen() const { return !vanishes(perpendicular(S.u, S.v)); }
  bool isCamera() const { return toScreen != 0; }
  bool hasImage() const { return isCamera() && toX != 0; }
  bool isAhead() const { return hasImage() && (toX > 0) == (toScreen > 0); }
  bool isBehind() const { return hasImage() && !isAhead(); }
  /// Whether X is in the pyramid of the eye and the screen, without its faces along the two edges opposite
  /// to the corner: on which side of each face it is.
  bool isSeen() const {
    if (!isAhead())
      return false;
    const ExactVec3 a = S.corner - Q;
    const ExactVec3 b = a + S.u;
    const ExactVec3 c = b + S.v;
    const ExactVec3 d = a + S.v;
    const int way = toScreen > 0 ? 1 : -1;
    const auto side = [&](const ExactVec3 &first, const ExactVec3 &second) {
      return way * determinant(first, second, ExactVec3(X - Q)).sign();
    };
    return side(a, b) >= 0 && side(d, a) >= 0 && side(b, c) > 0 && side(c, d) > 0;
  }
  bool isRectangle() const { return product(S.u, S.v) == 0; }

  ExactVec3 Q;
  ScreenObject S;
  ExactVec3 X;
  Rational toScreen;
  Rational toX;
};

bool isScreen(const Camera &at) { return at.isScreen(); }
bool isSeen(const Camera &at) { return at.isSeen(); }

/// Whether the line of sight runs through the centre of any pixel.
bool isCentred(const Camera &at) {
  for (int i = 0; i < at.S.w; ++i)
    for (int j = 0; j < at.S.h; ++j) {
      const ExactVec3 centre = at.S.corner + at.S.u * (Rational(2 * i + 1) / (2 * at.S.w)) +
                               at.S.v * (Rational(2 * j + 1) / (2 * at.S.h));
      if (vanishes(perpendicular(ExactVec3(centre - at.Q), ExactVec3(at.X - at.Q))))
        return true;
    }
  return false;
}

} // namespace

namespace claims {

Claims camera_ray() {
  return claimsAbout<Camera>({
      {"{u} and {v} lie along one line, or one of them is the zero vector: they span no screen.",
       [](const Camera &at) { return !at.isScreen(); }},
      {"{Q} lies in the plane of the screen: from there the screen is only a line.",
       [](const Camera &at) { return at.isScreen() && !at.isCamera(); }},
      {"{X} is at the eye itself: no line of sight leads to it.",
       [](const Camera &at) { return at.isCamera() && at.X == at.Q; }},
      {"({X} − {Q})·n = 0: the line of sight runs parallel to the screen and never meets its plane. {X} has "
       "no image.",
       [](const Camera &at) { return at.isCamera() && at.toX == 0 && at.X != at.Q; }},
      {"{k} is negative: {X} is behind the eye, and is not seen.",
       [](const Camera &at) { return at.isBehind(); }},
      {"The line of sight passes beside all pixels: {X} is not in the image.",
       [](const Camera &at) { return at.isAhead() && !at.isSeen(); }},
      {"{X} is seen in the pixel with {i} and {j}.", isSeen},
      {"Perpendicular to the screen.", isScreen},
      {"Negative: from {Q}, the screen and {X} lie on opposite sides.",
       [](const Camera &at) { return at.isBehind(); }},
      {"This part of the way from {Q} to {X} leads to the plane of the screen.",
       [](const Camera &at) { return at.isAhead() && abs(at.toX) > abs(at.toScreen); }},
      {"1: {X} lies in the plane of the screen.",
       [](const Camera &at) { return at.isCamera() && at.toX == at.toScreen; }},
      {"Larger than 1: {X} is between the eye and the plane of the screen.",
       [](const Camera &at) { return at.isAhead() && abs(at.toX) < abs(at.toScreen); }},
      {"The image of {X}: here the line of sight meets the plane of the screen.",
       [](const Camera &at) { return at.isAhead(); }},
      {"Only the line backwards from {Q} meets the plane of the screen here.",
       [](const Camera &at) { return at.isBehind(); }},
      {"How far the image lies from {P0} along {edge}, in pixels.",
       [](const Camera &at) { return at.hasImage() && at.isRectangle(); }},
      {"The edges make no right angle, so a vector perpendicular to {other} takes the place of {edge}.",
       [](const Camera &at) { return at.hasImage() && !at.isRectangle(); }},
      {"The whole pixels before it. Counting begins with 0.", isSeen},
      {"The corner where the pixel begins.", isSeen},
      {"The centre: half a pixel further in both directions.", isSeen},
      {"From the eye to the centre of the pixel.", isSeen},
      {"It takes this many steps to get to the plane through {X} that is parallel to the screen.", isSeen},
      {"This is {X} itself: {X} is seen exactly in the centre of the pixel.",
       [](const Camera &at) { return at.isSeen() && isCentred(at); }},
      {"Here the pixel's ray passes by {X}.", [](const Camera &at) { return at.isSeen() && !isCentred(at); }},
      {"How wide a piece of the plane through {X}, parallel to the screen, the pixel shows.", isSeen},
  });
}

} // namespace claims
} // namespace halfspace::test
