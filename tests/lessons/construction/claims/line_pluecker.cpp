#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct LineAlone {
  explicit LineAlone(Objects objects) : g(objectAs<LineObject>(*objects[0]).value()) {}

  bool isLine() const { return !vanishes(g.direction); }
  /// Then the way to its point is a multiple of its direction.
  bool hasOrigin() const { return isLine() && vanishes(perpendicular(g.direction, g.point)); }

  LineObject g;
};

bool isLine(const LineAlone &at) { return at.isLine(); }
bool hasOrigin(const LineAlone &at) { return at.hasOrigin(); }
bool lacksOrigin(const LineAlone &at) { return at.isLine() && !at.hasOrigin(); }
/// Whether its own point is the one nearest to the origin.
bool isNearest(const LineAlone &at) { return at.isLine() && product(at.g.point, at.g.direction) == 0; }

} // namespace

namespace claims {

Claims line_pluecker() {
  return claimsAbout<LineAlone>({
      {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
       [](const LineAlone &at) { return !at.isLine(); }},
      {"The moment is the zero vector: the line {g} goes through the origin.", hasOrigin},
      {"The six numbers of the line {g} are {direction} and {moment}.", lacksOrigin},
      {"The moment: perpendicular to the line, and to the arrow from the origin to {A}.", lacksOrigin},
      {"The moment: the zero vector, because the line goes through the origin.", hasOrigin},
      {"Twice the direction gives twice the moment: six other numbers for the same line.", isLine},
      {"Always 0: the cross product {A} × {v} is perpendicular to {v}.", lacksOrigin},
      {"Always 0, and here the cross product {A} × {v} is the zero vector.", hasOrigin},
      {"The point of the line that is nearest to the origin.", isLine},
      {"{point} is {A} itself here, so the moment is the same.", isNearest},
      {"{point} is another point of the line, and gives the same moment as {A}.",
       [](const LineAlone &at) { return at.isLine() && !isNearest(at); }},
      {"How far the line is from the origin. |{m}| alone says it only when |{v}| = 1.", lacksOrigin},
      {"A moment of zero: the line goes through the origin.", hasOrigin},
  });
}

} // namespace claims
} // namespace halfspace::test
