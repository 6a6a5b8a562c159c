#include "lessons/lesson/new_numbers/faces.h"

#include "lessons/object/corners.h"
#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/screen.h"

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

/// The axes, beginning with any of them.
class Axes {
public:
  explicit Axes(Dice &dice) : m_first(dice.between(0, 2)) {}

  /// Along the first axis, or so many behind it.
  [[nodiscard]] ExactVec3 arrow(int behind, int length) const {
    ExactVec3 along{};
    along[(m_first + behind) % 3] = length;
    return along;
  }

private:
  int m_first;
};

Net drawPolygon(Object &object, Dice &dice) {
  const ExactVec3 first = dice.direction(1);
  ExactVec3 second = first;
  while (isZero(cross(first, second)))
    second = dice.direction(1);
  Net face{dice.position(), {first, second}, cross(first, second), 3};
  const WholeFace &corners = wholeFace(object.size());
  for (std::size_t i = 0; i < object.size(); ++i)
    object[i] = face.after({corners[i].x, corners[i].y});
  return face;
}

/// Square to the axes. Its pixels are two units large, so that their centres are whole points, unless there
/// are too many. Others aim at places around its middle, before it and behind it.
Net drawScreen(Object &object, Dice &dice) {
  ScreenObject screen = objectAs<ScreenObject>(object).value();
  const Axes axes(dice);
  const Rational most = std::max(screen.w, screen.h);
  const Rational pixel = 2 * most < largestShortNumber ? Rational(2)
                         : most <= largestShortNumber  ? Rational(1)
                                                       : longestSide / most;
  const ExactVec3 across = axes.arrow(1, dice.sign()) * pixel;
  const ExactVec3 down = axes.arrow(2, dice.sign()) * pixel;
  const int depth = dice.between(1, longestStep);
  screen.u = across * screen.w;
  screen.v = down * screen.h;
  const ExactVec3 middle = dice.position();
  screen.corner = middle - across * floorOf(Rational(screen.w / 2)) - down * floorOf(Rational(screen.h / 2));
  object = screen;
  return {middle, {across, down}, axes.arrow(0, depth), 0};
}

// Solids are square to the axes as far as they can be: rays meet their other faces at short numbers too.

/// What all solids begin with, in this order.
struct SolidStart {
  explicit SolidStart(Dice &dice)
      : axes(dice), size(dice.between(smallestTriangle, largestTriangle)), corner(dice.position()) {}

  Axes axes;
  int size;
  ExactVec3 corner;
};

Net drawBox(Object &box, Dice &dice) {
  const auto [axes, size, corner] = SolidStart(dice);
  box[0] = corner;
  for (std::size_t i = 1; i < box.size(); ++i)
    box[i].x = dice.between(smallestTriangle, longestSide);
  return {corner, {axes.arrow(1, 1), axes.arrow(2, 1)}, axes.arrow(0, 1), smallestTriangle};
}

Net drawTetrahedron(Object &tetrahedron, Dice &dice) {
  const auto [axes, size, corner] = SolidStart(dice);
  Net face{corner, {axes.arrow(1, dice.sign()), axes.arrow(2, dice.sign())}, axes.arrow(0, 1), size};
  tetrahedron[0] = corner;
  for (std::size_t i = 0; i < 2; ++i)
    tetrahedron[i + 1] = corner + face.steps[i] * Rational(size);
  tetrahedron[3] = corner + axes.arrow(0, size * dice.sign());
  return face;
}

Net drawPrism(Object &prism, Dice &dice) {
  const auto [axes, size, corner] = SolidStart(dice);
  Net face{corner, {axes.arrow(1, dice.sign()), axes.arrow(2, dice.between(1, 2))}, axes.arrow(0, 1), 3};
  const std::vector<std::size_t> base = cornersOf(prism);
  const WholeFace &corners = wholeFace(base.size());
  for (std::size_t i = 0; i < base.size(); ++i)
    prism[base[i]] = face.after({corners[i].x, corners[i].y});
  prism[1] = axes.arrow(0, dice.sign() * dice.between(smallestTriangle, longestSide));
  return face;
}

using DrawFace = Net (*)(Object &, Dice &);

/// By the words of the kinds.
const std::map<std::string_view, DrawFace> &facesDrawn() {
  static const std::map<std::string_view, DrawFace> all{{PolygonObject::kind, drawPolygon},
                                                        {ScreenObject::kind, drawScreen},
                                                        {BoxObject::kind, drawBox},
                                                        {"tetrahedron", drawTetrahedron},
                                                        {"prism", drawPrism}};
  return all;
}

} // namespace

bool hasFace(std::string_view kind) { return facesDrawn().contains(kind); }

std::optional<Net> drawFace(Object &object, Dice &dice) {
  const auto found = facesDrawn().find(kindOf(object));
  return found == facesDrawn().end() ? std::nullopt : std::optional(found->second(object, dice));
}

} // namespace halfspace
