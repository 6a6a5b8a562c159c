// Planes, spheres and lines as they are written on paper.
#pragma once

#include "lessons/formula/formula.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/sphere.h"

namespace halfspace {

/// The plane of left = right, with x, y and z and with numbers; its point has whole numbers near the origin
/// where there are such, else it lies on an axis. Or what keeps it from being one.
[[nodiscard]] std::variant<PlaneObject, FormulaFault> planeOf(const Formula &left, const Formula &right);

/// Whether names, as x, y and z, are squared or multiplied by one another in left = right, and nothing beyond
/// that.
[[nodiscard]] bool isQuadratic(const Formula &left, const Formula &right);

/// The sphere of left = right: (x − 1)² + (y − 2)² + z² = 9, in whatever form. Or what keeps it from being
/// one whose radius is a fraction.
[[nodiscard]] std::variant<SphereObject, FormulaFault> sphereOf(const Formula &left, const Formula &right);

/// The equation of a plane, its left and its right side: n·x = n·P0.
struct PlaneEquation {
  Formula left;
  Formula right;
};
/// That from which `planeOf` makes the same plane; nothing for one that is told by another point.
[[nodiscard]] std::optional<PlaneEquation> equationFor(const PlaneObject &plane);

/// A + t v: a point, a vector, and what the parameter is called.
struct ParametricLine {
  Formula start;
  Formula direction;
  std::string parameter;
};

/// A formula as one of a line: a sum or a difference, whose second part is a product with a name that stands
/// for nothing else. Nothing for any other formula.
[[nodiscard]] std::optional<ParametricLine>
parametricOf(const Formula &formula, const std::function<bool(const std::string &)> &isUnknown);

} // namespace halfspace
