// The outlines of balls as they are seen from where the eye is.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/shapes/arrival.h"
#include "widgets/picture/shapes/shape.h"
#include "widgets/picture/view.h"

#include <optional>
#include <set>

namespace halfspace {

/// The circle in which lines of sight touch a ball.
struct Silhouette {
  Place center{};
  Place axis{}; ///< unit
  double radius = 0;
};

/// Of a ball around a centre; nothing for an eye inside of it, or on it.
[[nodiscard]] std::optional<Silhouette> silhouetteOf(const SphereMark &ball, const Camera &camera);

/// The outlines of the figure's balls.
[[nodiscard]] std::vector<Shape> silhouettesOf(const Figure &figure, const std::set<std::string> &highlighted,
                                               const Arrival &arrival, const Theme &theme, const View &view);

} // namespace halfspace
