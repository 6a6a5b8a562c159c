// The sphere through four points, whether they are points or the corners of a tetrahedron: its equations, its
// centre by Cramer's rule, and its figure.
#pragma once

#include "geometry/circumsphere.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/sphere.h"

#include <array>
#include <optional>

namespace halfspace {

/// The letters of the lines, each with what it is. The construction makes M and S.
struct SphereThrough {
  SphereThrough(const Naming &naming, const std::array<Term, 4> &points);

  std::array<Term, 4> corners; ///< in the letters of the scene
  Circumsphere<Rational> found;
  bool hasSphere = found.which == CircumsphereCase::Sphere;
  bool makesSphere = hasSphere && found.radius.isRational(); ///< no object has roots for coordinates

  std::array<Term, 3> sides;   ///< u, v, w
  std::array<Term, 3> normals; ///< n₁ = v×w, n₂ = w×u, n₃ = u×v
  Term V;                      ///< u·(v×w)
  Term M;
  Term R; ///< in the figure it is the sphere
};

[[nodiscard]] CaseWords tellSphereThrough(const SphereThrough &at);

[[nodiscard]] WorkingLine sideLine(const SphereThrough &at, std::size_t index);
[[nodiscard]] WorkingLine equationLine(const SphereThrough &at, std::size_t index);
[[nodiscard]] WorkingLine crossLine(const SphereThrough &at, std::size_t index);
[[nodiscard]] WorkingLine volumeLine(const SphereThrough &at);
[[nodiscard]] WorkingLine centerLine(const SphereThrough &at);
[[nodiscard]] WorkingLine radiusLine(const SphereThrough &at);
[[nodiscard]] WorkingLine checkLine(const SphereThrough &at);

[[nodiscard]] Figure drawSphereThrough(const Naming &naming, const SphereThrough &at);

/// The last point, moved straight into the plane of the others; nothing where they have no sphere.
[[nodiscard]] std::optional<ExactVec3> flattenedCorner(const SphereThrough &at);

/// What both constructions have; each has a name, its roles and its special cases of its own.
template <class Out>
[[nodiscard]] Teaching<Out>
sphereThroughTeaching(std::string_view id, const std::vector<std::string> &roles,
                      std::function<std::vector<SpecialCase>(const Out &)> nearby) {
  const HasPlace<Out> eachSide = [](const Out & /*at*/, std::size_t /*index*/) { return true; };
  const HasPlace<Out> eachEquation = [](const Out &at, std::size_t /*index*/) { return at.hasSphere; };
  return {.id = id,
          .word = "circumsphere",
          .title = [] { return words("circumscribed sphere"); },
          .roles = roles,
          .makes = {{"M", &Out::hasSphere, &Out::M},
                    {"S", SphereObject::kind, &Out::makesSphere,
                     [](const Out &at) {
                       return SphereObject{at.found.center, at.found.radius.rationalPart()};
                     }}},
          .letters = {"u", "v", "w", "n1", "n2", "n3", "V"},
          .cases = {"sphere", "no-sphere", "many-spheres"},
          .values = {{named::number("det"), always, &Out::V},
                     {named::vector("center"), &Out::hasSphere, &Out::M},
                     {named::number("radius"), &Out::hasSphere, &Out::R}},
          .lines = joined<LineRow<Out>>({linesOfEach<Out>(3, eachSide, {{"side", sideLine}}, 1),
                                         linesOfEach<Out>(3, eachEquation, {{"equation", equationLine}}, 1),
                                         linesOfEach<Out>(3, eachSide, {{"cross", crossLine}}, 1),
                                         {{"det", always, volumeLine},
                                          {"center", &Out::hasSphere, centerLine},
                                          {"radius", &Out::hasSphere, radiusLine},
                                          {"check", &Out::hasSphere, checkLine}}}),
          .marks = {"u", "v", "w", "S", "M", "radius"},
          .tell = tellSphereThrough,
          .draw = [](const Out &at) { return drawSphereThrough(at, at); },
          .nearby = std::move(nearby)};
}

} // namespace halfspace
