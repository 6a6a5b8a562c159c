#include "lessons/object/kinds/polygon.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/corner_letters.h"
#include "tests/lessons/construction/claims/ray_at_faces.h"

#include <algorithm>

namespace halfspace::test {
namespace {

struct RayAtPolygon {
  explicit RayAtPolygon(Objects objects)
      : corners(objectAs<PolygonObject>(*objects[0])->corners), L(objectAs<RayObject>(*objects[1]).value()),
        normal(normalOf(corners)) {
    for (std::size_t i = 0; i < size(); ++i)
      turns.push_back(turnAround(L, corner(i), corner(i + 1)));
  }

  std::size_t size() const { return corners.size(); }
  const ExactVec3 &corner(std::size_t i) const { return cornerOf(corners, i); }
  ExactVec3 edge(std::size_t i) const { return edgeOf(corners, i); }
  bool isRay() const { return !vanishes(L.direction); }

  /// Whether three corners span no triangle.
  bool areOnOneLine(std::size_t a, std::size_t b, std::size_t c) const {
    return vanishes(perpendicular(ExactVec3(corner(b) - corner(a)), ExactVec3(corner(c) - corner(a))));
  }

  bool isPlanar() const { return areInOnePlane(corners); }
  bool isConvex() const { return isPlanar() && test::isConvex(corners); }
  bool isDouble(std::size_t a, std::size_t b) const { return a != b && corners.at(a) == corners.at(b); }
  bool hasDoubleCorner() const { return hasDouble(corners); }
  bool hasStraightCorner() const {
    for (std::size_t i = 0; i < size(); ++i)
      if (areOnOneLine(i, i + 1, i + 2))
        return true;
    return false;
  }

  Rational slope() const { return product(normal, L.direction); }
  Rational t() const { return product(normal, ExactVec3(corners[0] - L.origin)) / slope(); }
  /// Of a convex polygon.
  bool crosses() const { return isConvex() && slope() != 0; }
  /// Whether the line has nothing in common with the plane, or lies in it.
  bool isBeside() const {
    return isConvex() && isRay() && slope() == 0 && product(normal, ExactVec3(corners[0] - L.origin)) != 0;
  }
  bool isWithin() const {
    return isConvex() && isRay() && slope() == 0 && product(normal, ExactVec3(corners[0] - L.origin)) == 0;
  }

  /// Whether the point in the plane is on the inner side of no edge: that many, and on the lines of so many.
  long outer() const {
    return countHeights([](const Rational &height) { return height < 0; });
  }
  long border() const {
    return countHeights([](const Rational &height) { return height == 0; });
  }
  template <class Condition> long countHeights(Condition condition) const {
    const ExactVec3 point = L.origin + L.direction * t();
    long count = 0;
    for (std::size_t i = 0; i < size(); ++i)
      if (condition(product(normal, perpendicular(edge(i), ExactVec3(point - corner(i))))))
        ++count;
    return count;
  }

  bool passesThrough() const { return crosses() && outer() == 0; }
  bool passesOutside() const { return crosses() && outer() > 0; }

  Corners corners;
  RayObject L;
  ExactVec3 normal;
  std::vector<Rational> turns; ///< which way round the ray each edge goes
};

bool isEdgeNamed(const RayAtPolygon &at, std::size_t edge, const std::string &name) {
  return name == cornerLetter(edge) + cornerLetter((edge + 1) % at.size());
}

std::size_t saidCorner(const RayAtPolygon &at, const Said &said, const char *place) {
  return cornerWithLetter(said.at(place), at.size());
}

bool crosses(const RayAtPolygon &at) { return at.crosses(); }
bool hasNoDirection(const RayAtPolygon &at) { return !at.isRay(); }
bool isWithin(const RayAtPolygon &at) { return at.isWithin(); }
bool passesThrough(const RayAtPolygon &at) { return at.passesThrough(); }
bool isHit(const RayAtPolygon &at) { return at.passesThrough() && at.t() >= 0; }
bool isBehind(const RayAtPolygon &at) { return at.passesThrough() && at.t() < 0; }
bool passesOutside(const RayAtPolygon &at) { return at.passesOutside(); }

Claims shapeClaims() {
  return claimsAbout<RayAtPolygon>({
      {"The corners do not lie in one plane: no flat polygon is there to go through.",
       [](const RayAtPolygon &at) { return !at.isPlanar(); }},
      {"{first} and {second} are the same point: the polygon has a corner too many.",
       [](const RayAtPolygon &at, const Said &said) {
         return at.isDouble(saidCorner(at, said, "first"), saidCorner(at, said, "second"));
       }},
      {"{first}, {second} and {third} lie on one line: this is no triangle.",
       [](const RayAtPolygon &at) {
         return at.size() == 3 && !at.hasDoubleCorner() && at.areOnOneLine(0, 1, 2);
       }},
      {"{first}, {corner} and {last} lie on one line, so {corner} is no corner of a convex polygon.",
       [](const RayAtPolygon &at, const Said &said) {
         const std::size_t corner = saidCorner(at, said, "corner");
         return saidCorner(at, said, "last") == (corner + 1) % at.size() &&
                saidCorner(at, said, "first") == (corner + at.size() - 1) % at.size() &&
                at.areOnOneLine(corner, corner + 1, corner + at.size() - 1);
       }},
      {"The polygon bends inwards or crosses itself: it is not convex, and the signs alone do not tell what "
       "is inside.",
       [](const RayAtPolygon &at) {
         return at.isPlanar() && !at.hasDoubleCorner() && !at.hasStraightCorner() && !at.isConvex();
       }},
  });
}

Claims caseClaims() {
  return claimsAbout<RayAtPolygon>({
      {"The direction {r} is the zero vector: the ray goes nowhere.", hasNoDirection},
      {"Two products differ in sign: the line of the ray passes outside the polygon.", passesOutside},
      {"The products add up to 0: the ray runs parallel to the polygon's plane and never meets it.",
       [](const RayAtPolygon &at) { return at.isBeside(); }},
      {"All products are 0: the ray runs inside the polygon's plane, and no single point is the hit.",
       isWithin},
  });
}

/// Sentences about the part of the polygon that the line passes through. Each says too that the condition
/// holds.
Claims partClaims(bool (*holds)(const RayAtPolygon &), const char *inside, const char *onEdge,
                  const char *atCorner) {
  return claimsAbout<RayAtPolygon>({
      {inside, [holds](const RayAtPolygon &at) { return holds(at) && at.border() == 0; }},
      {onEdge,
       [holds](const RayAtPolygon &at, const Said &said) {
         const auto zero = std::find(at.turns.begin(), at.turns.end(), Rational(0)) - at.turns.begin();
         return holds(at) && at.border() == 1 &&
                isEdgeNamed(at, static_cast<std::size_t>(zero), said.at("edge"));
       }},
      {atCorner,
       [holds](const RayAtPolygon &at, const Said &said) {
         return holds(at) &&
                at.corner(saidCorner(at, said, "corner")) == ExactVec3(at.L.origin + at.L.direction * at.t());
       }},
  });
}

Claims throughClaims() {
  return together(
      {partClaims(isHit,
                  "No two products differ in sign: the ray goes through the inside of the polygon, at {t}.",
                  "No two products differ in sign: the ray goes through the edge {edge}, at {t}.",
                  "No two products differ in sign: the ray goes through the corner {corner}, at {t}."),
       partClaims(isBehind,
                  "No two products differ in sign, so the line of the ray goes through the inside of the "
                  "polygon. But {t} is negative: that is behind the ray's start.",
                  "No two products differ in sign, so the line of the ray goes through the edge {edge}. But "
                  "{t} is negative: that is behind the ray's start.",
                  "No two products differ in sign, so the line of the ray goes through the corner {corner}. "
                  "But {t} is negative: that is behind the ray's start."),
       partClaims(passesThrough,
                  "No two differ in sign: the line of the ray goes through the inside of the polygon.",
                  "No two differ in sign: the line of the ray goes through the edge {edge}.",
                  "No two differ in sign: the line of the ray goes through the corner {corner}.")});
}

Claims edgeClaims() {
  return claimsAbout<RayAtPolygon>({
      {"The moment of the ray's line.", always},
      {"The moment of its line.", always},
      {"The edge {edge}, from one corner to the next.",
       [](const RayAtPolygon &at, const Said &said) {
         return isEdgeNamed(at, numberIn(said.line), said.at("edge"));
       }},
      {"Positive: seen with {r} pointing at you, the edge {edge} goes counterclockwise around the ray.",
       [](const RayAtPolygon &at, const Said &said) {
         return at.turns.at(numberIn(said.line)) > 0 && isEdgeNamed(at, numberIn(said.line), said.at("edge"));
       }},
      {"Negative: seen with {r} pointing at you, the edge {edge} goes clockwise around the ray.",
       [](const RayAtPolygon &at, const Said &said) {
         return at.turns.at(numberIn(said.line)) < 0 && isEdgeNamed(at, numberIn(said.line), said.at("edge"));
       }},
      {"Zero, because {r} is the zero vector: there is no ray.", hasNoDirection},
      {"Zero, because {e} is the zero vector: there is no edge.",
       [](const RayAtPolygon &at, const Said &said) { return vanishes(at.edge(numberIn(said.line))); }},
      {"Zero: the ray and the edge {edge} lie in one plane.",
       [](const RayAtPolygon &at, const Said &said) {
         return at.isRay() && !vanishes(at.edge(numberIn(said.line))) &&
                at.turns.at(numberIn(said.line)) == 0;
       }},
  });
}

Claims sumClaims() {
  return claimsAbout<RayAtPolygon>({
      {"All are 0, because {r} is the zero vector: there is no line.", hasNoDirection},
      {"The signs say which way the ray passes each edge. They decide for a flat, convex polygon only.",
       [](const RayAtPolygon &at) { return at.isRay() && !at.isConvex(); }},
      {"All are 0: the ray and all edges lie in one plane.", isWithin},
      {"Both signs are there: the line of the ray passes outside the polygon.",
       [](const RayAtPolygon &at) { return at.passesOutside() || at.isBeside(); }},
      {"All products together.", [](const RayAtPolygon &at) { return at.slope() != 0; }},
      {"Zero: the ray crosses the polygon's plane nowhere, or runs inside it.",
       [](const RayAtPolygon &at) { return at.isBeside() || at.isWithin(); }},
      {"Zero: the products alone do not tell why.",
       [](const RayAtPolygon &at) { return at.isRay() && !at.isConvex() && at.slope() == 0; }},
      {"Two edges of the polygon give a normal of its plane.",
       [](const RayAtPolygon &at) { return at.isConvex(); }},
      {"Negative: the line crosses the plane before the ray's start {Q}.",
       [](const RayAtPolygon &at) { return at.crosses() && at.t() < 0; }},
      {"Not negative: the ray itself gets to the plane.",
       [](const RayAtPolygon &at) { return at.crosses() && at.t() >= 0; }},
      {"Here the line of the ray crosses the polygon's plane.", crosses},
      {"The weight of {corner}: the product of the edge opposite to it, as a share of S.",
       [](const RayAtPolygon &at, const Said &said) {
         static const std::map<std::string, std::size_t> corners{{"rho", 0}, {"sigma", 1}, {"tau", 2}};
         return at.size() == 3 && at.crosses() && saidCorner(at, said, "corner") == corners.at(said.line);
       }},
      {"The corners mixed with these weights give the point {I}.",
       [](const RayAtPolygon &at) { return at.size() == 3 && at.crosses(); }},
  });
}

} // namespace

namespace claims {

Claims ray_polygon_pluecker() {
  return together({shapeClaims(), caseClaims(), throughClaims(), edgeClaims(), sumClaims()});
}

} // namespace claims
} // namespace halfspace::test
