// The shapes of a figure but for its translucent faces: lines, arrows, points, bodies.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/shapes/arrival.h"
#include "widgets/picture/shapes/shape.h"

#include <set>

namespace halfspace {

/// What the corner of a right angle measures at scale 1, in scene units.
inline constexpr double rightAngleSize = 0.9;
/// The radius of a given point, the thickest thing that stays in its place.
inline constexpr double freePointRadius = 0.32;
/// The radius of what flies by: the arrow and the line along which it flies do not hide it.
inline constexpr double flyingRadius = 0.42;
/// The radius of any other point.
inline constexpr double pointRadius = 0.23;

/// The radius of an arrow's shaft.
inline constexpr double arrowRadius = 0.11;

/// The radius of the lines that a mark is drawn with, at scale 1, in scene units; 0 for a point.
[[nodiscard]] double strokeRadius(const Mark &mark);

/// The radius of a point's ball at scale 1, in scene units, where it has room (see BallSizes).
[[nodiscard]] double ballRadius(const PointMark &point);
/// What the radii of a mark at scale 1 are multiplied by.
[[nodiscard]] double thicknessOf(const MarkBase &mark, const Theme &theme, double scale);

/// The rhythm of a mark's lines, in scene units at a scale: short dashes for helpers and ghosts,
/// and for an object that is not the first of its kind long ones, of its own.
[[nodiscard]] Rhythm rhythmOf(const MarkBase &mark, double scale);

/// The colour of a mark's solid parts, by its subject, its role and whether it stands out.
[[nodiscard]] Color solidColor(const MarkBase &mark, const Theme &theme, bool highlighted);

/// The lines, arrows and points of all marks, in their order. Thicknesses, dashes and corners are multiplied
/// by `scale`, so that they measure the same on the screen however near the camera is. What arrives grows out
/// of thin, pale lines.
[[nodiscard]] std::vector<Shape> solidsOf(const Figure &figure, const std::set<std::string> &highlighted,
                                          const Theme &theme, double scale, const Arrival &arrival = {});

/// The surfaces of very many triangles, all of which are drawn.
[[nodiscard]] std::vector<Shape> bodiesOf(const Figure &figure, const std::set<std::string> &highlighted,
                                          const Theme &theme, const Arrival &arrival = {});

} // namespace halfspace
