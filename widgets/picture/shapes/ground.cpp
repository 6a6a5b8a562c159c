#include "widgets/picture/shapes/ground.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/labels/number_text.h"
#include "widgets/picture/shapes/mark_outline.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace halfspace {
namespace {

// In scene units at scale 1.
constexpr double axisRadius = 0.055;
constexpr double tickRadius = 0.044;
constexpr double tickLength = 0.35;
constexpr double tickLabelDistance = 0.78;
constexpr double nameDistance = 0.1;
constexpr double originRadius = 0.13;

/// Every so many steps a major line and a tick.
constexpr int stepsPerMajor = 5;

/// The grid's radius in heights of the view, and the part of it in which the lines fade.
constexpr double gridRadius = 0.62;
constexpr double fadingPart = 0.5;
constexpr int piecesPerLine = 48;

/// Ticks farther away than so many heights of the view are too small to be seen.
constexpr double tickReach = 4;

/// The axes reach this far beyond the last place and end here at the latest.
constexpr double axisMargin = 1.2;
constexpr double longestAxis = 60;

constexpr std::array<Place, 3> axisDirections{Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}};
constexpr std::array<const char *, 3> axisNames{"x", "y", "z"};
/// To which side of an axis its ticks and numbers stand, as far as the camera lets them.
constexpr std::array<Place, 3> tickSides{Place{0, -1, 0}, Place{-1, 0, 0}, Place{-0.7071, -0.7071, 0}};

double strengthAt(double distance, double radius) {
  const double t = std::clamp((radius - distance) / (fadingPart * radius), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A line of the grid on one of its two directions, at a whole number of steps.
Grid::Line gridLine(glm::dvec2 middle, double radius, double step, double number, bool alongX) {
  Grid::Line line;
  line.isMajor = std::fmod(std::abs(number), stepsPerMajor) == 0;
  const double at = number * step;
  const double halfLength =
      std::sqrt(std::max(0.0, radius * radius - std::pow(at - (alongX ? middle.y : middle.x), 2)));
  for (int i = 0; i <= piecesPerLine; ++i) {
    const double along = halfLength * (2.0 * i / piecesPerLine - 1);
    const Place point = alongX ? Place(middle.x + along, at, 0) : Place(at, middle.y + along, 0);
    line.points.push_back(point);
    line.strengths.push_back(strengthAt(std::hypot(point.x - middle.x, point.y - middle.y), radius));
  }
  return line;
}

/// The whole numbers n, lowest first, for which n·spacing lies between two bounds. They are few: the bounds
/// are some heights of a view apart, and the spacing follows that height.
std::vector<double> multiplesBetween(double low, double high, double spacing) {
  const double first = std::ceil(low / spacing);
  const double count = std::max(0.0, std::floor(high / spacing) - first + 1);
  std::vector<double> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// A tick of an axis, counted from the origin.
struct Tick {
  int number = 0;
  double at = 0;
};

/// An axis' ticks that the camera may see, without the origin and the tip.
std::vector<Tick> ticksOf(double low, double high, double target, double viewHeight) {
  const double step = gridStep(viewHeight);
  const double spacing = step * stepsPerMajor;
  std::vector<Tick> ticks;
  for (const double number : multiplesBetween(std::max(low, target - tickReach * viewHeight),
                                              std::min(high, target + tickReach * viewHeight), spacing))
    if (number != 0 && number * spacing < high - step)
      ticks.push_back({static_cast<int>(number), number * spacing});
  return ticks;
}

/// The direction in which the ticks of an axis stand: square to it and to the sight, so that they are seen at
/// their full length; along an axis that is seen as a point, any.
Place tickDirection(std::size_t axis, const Camera &camera) {
  const Place across = glm::cross(axisDirections[axis], camera.viewDirection());
  const double length = glm::length(across);
  if (length == 0)
    return tickSides[axis];
  return across / (glm::dot(across, tickSides[axis]) < 0 ? -length : length);
}

/// Whether only part of a mark is drawn, because there is no end to it.
bool runsOn(const Mark &mark) {
  return std::holds_alternative<PlanePatchMark>(mark) || std::holds_alternative<RayMark>(mark) ||
         std::holds_alternative<LineMark>(mark);
}

} // namespace

double gridStep(double viewHeight) {
  return std::pow(5.0, std::round(std::log(viewHeight / designUnits) / std::log(5.0)));
}

Grid gridAround(const Camera &camera) {
  const double step = gridStep(camera.height);
  const double radius = gridRadius * camera.height;
  const glm::dvec2 middle(camera.target);
  Grid grid;
  for (const bool alongX : {true, false}) {
    const double center = alongX ? middle.y : middle.x;
    for (const double number : multiplesBetween(center - radius, center + radius, step))
      grid.lines.push_back(gridLine(middle, radius, step, number, alongX));
  }
  // Major lines last: they lie over the others.
  std::stable_partition(grid.lines.begin(), grid.lines.end(),
                        [](const Grid::Line &line) { return !line.isMajor; });
  return grid;
}

std::vector<Shape> shapesOf(Grid grid, const Theme &theme, double width) {
  std::vector<Shape> shapes;
  shapes.reserve(grid.lines.size());
  for (Grid::Line &line : grid.lines)
    shapes.push_back({{},
                      line.isMajor ? theme.gridMajor : theme.grid,
                      HairlineShape{std::move(line.points), std::move(line.strengths), width}});
  return shapes;
}

std::array<AxisEnds, 3> axisEnds(const AxesReach &reach) {
  std::array<AxisEnds, 3> ends;
  for (std::size_t i = 0; i < ends.size(); ++i)
    ends[i] = {axisDirections[i] * reach.low, axisDirections[i] * reach.high};
  return ends;
}

AxesReach axesFor(const std::vector<Place> &places) {
  AxesReach reach;
  for (const Place &place : places)
    for (int axis = 0; axis < 3; ++axis) {
      reach.high[axis] =
          std::max(reach.high[axis], std::min(std::ceil(place[axis]) + axisMargin, longestAxis));
      if (place[axis] < 0)
        reach.low[axis] =
            std::min(reach.low[axis], std::max(std::floor(place[axis]) - axisMargin, -longestAxis));
    }
  return reach;
}

AxesReach axesAround(const Figure &figure) {
  std::vector<Place> places;
  for (const Mark &mark : figure.marks)
    if (!runsOn(mark)) {
      const MarkOutline outline = outlineOf(mark, 0);
      places.insert(places.end(), outline.path.begin(), outline.path.end());
    }
  return axesFor(places);
}

std::vector<AxisEnds> axisTicks(const AxesReach &reach, const Camera &camera, double scale) {
  std::vector<AxisEnds> ticks;
  for (std::size_t i = 0; i < axisDirections.size(); ++i) {
    const auto axis = static_cast<Place::length_type>(i);
    for (const Tick &tick : ticksOf(reach.low[axis], reach.high[axis], camera.target[axis], camera.height)) {
      const Place at = axisDirections[i] * tick.at;
      ticks.push_back({at, at + tickDirection(i, camera) * (tickLength * scale)});
    }
  }
  return ticks;
}

std::vector<Shape> axesOf(const AxesReach &reach, const Camera &camera, const Theme &theme, double scale) {
  std::vector<Shape> shapes;
  const double width = scale * theme.lineScale;
  for (const auto &[low, high] : axisEnds(reach))
    shapes.push_back({{}, theme.axis, ArrowShape{low, high - low, axisRadius * width}});
  for (const auto &[low, high] : axisTicks(reach, camera, scale))
    shapes.push_back({{}, theme.axis, LineShape{{low, high}, tickRadius * width}});
  shapes.push_back({{}, theme.axis, BallShape{Place(0), originRadius * width}});
  return shapes;
}

AxisLabel axisNumber(int axis, double number, const Camera &camera, int exponent, double scale) {
  const auto i = static_cast<std::size_t>(axis);
  return {numberText(number, exponent),
          axisDirections[i] * number + tickDirection(i, camera) * (tickLabelDistance * scale), false, axis};
}

std::vector<AxisLabel> axisLabels(const AxesReach &reach, const Camera &camera, int exponent, double scale) {
  std::vector<AxisLabel> labels;
  for (std::size_t i = 0; i < axisDirections.size(); ++i) {
    const auto axis = static_cast<Place::length_type>(i);
    for (const Tick &tick : ticksOf(reach.low[axis], reach.high[axis], camera.target[axis], camera.height)) {
      labels.push_back(axisNumber(axis, tick.at, camera, exponent, scale));
      labels.back().tick = tick.number;
    }
    labels.push_back(
        {axisNames[i], axisDirections[i] * (reach.high[axis] + nameDistance * scale), true, axis});
  }
  return labels;
}

} // namespace halfspace
