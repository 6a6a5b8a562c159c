// The ground grid and the axes.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/camera.h"
#include "widgets/picture/shapes/shape.h"

#include <array>

namespace halfspace {

/// The grid as straight pieces between neighbouring points, in two lists of the same length, with how much of
/// a line's colour is left there: 1 around the middle, 0 at the rim.
struct Grid {
  struct Line {
    std::vector<Place> points;
    std::vector<double> strengths;
    bool isMajor = false;
  };
  std::vector<Line> lines;
};

/// The distance of neighbouring lines of the grid, a power of five: 1 unless the view is very low or very
/// high. Every fifth line is a major one, and the axes have their ticks there.
[[nodiscard]] double gridStep(double viewHeight);

/// The grid on z = 0 around what the camera looks at.
[[nodiscard]] Grid gridAround(const Camera &camera);
/// Its lines, so many pixels wide.
[[nodiscard]] std::vector<Shape> shapesOf(Grid grid, const Theme &theme, double width);

/// How far the axes reach from the origin, to both sides.
struct AxesReach {
  Place low{0};
  Place high{12.2, 16.2, 11.2};
  bool operator==(const AxesReach &) const = default;
};

/// The two ends of an axis or of one of its ticks.
struct AxisEnds {
  Place low{};
  Place high{};
};
/// Of x, y and z.
[[nodiscard]] std::array<AxisEnds, 3> axisEnds(const AxesReach &reach);

/// Long enough for all places, but not without bound: what is far away does not stretch them.
[[nodiscard]] AxesReach axesFor(const std::vector<Place> &places);

/// The axes of a figure: patches, rays and lines may reach beyond them.
[[nodiscard]] AxesReach axesAround(const Figure &figure);

/// The ticks of the axes that the camera may see, each from its axis to its tip.
[[nodiscard]] std::vector<AxisEnds> axisTicks(const AxesReach &reach, const Camera &camera, double scale);

/// A number or a name written at an axis.
struct AxisLabel {
  std::string latex;
  Place at{};
  bool isName = false;
  int axis = 0; ///< 0, 1, 2: beside x, y, z
  int tick = 0; ///< a number's tick, counted from the origin
};

/// A number at its place beside an axis (0, 1, 2 for x, y, z), written in scene units: a unit of the stage is
/// 10^exponent of them. Whichever way the camera looks, it is seen beside the axis, never over it.
[[nodiscard]] AxisLabel axisNumber(int axis, double number, const Camera &camera, int exponent, double scale);

/// The axes with ticks, those that the camera may see.
[[nodiscard]] std::vector<Shape> axesOf(const AxesReach &reach, const Camera &camera, const Theme &theme,
                                        double scale);
[[nodiscard]] std::vector<AxisLabel> axisLabels(const AxesReach &reach, const Camera &camera, int exponent,
                                                double scale);

} // namespace halfspace
