#include "lessons/scene/hand/quadric_places.h"

#include "geometry/exact_root.h"
#include "lessons/object/drawing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Grid lines this many steps around the nearest one are tried …
constexpr int lineReach = 2;
/// … and this many, once parted by up to so many, for a place of the curve to begin with.
constexpr int searchReach = 24;
constexpr int finestParts = 4;
/// The slopes of lines from there to others have denominators up to this: a long curve is about as fine as a
/// pixel then.
constexpr int finestSlope = 48;

/// The places of a line, from + t·way, where the surface is met at a fraction t.
std::vector<ExactVec3> exactPlacesOnLine(const Quadric &surface, const ExactVec3 &from,
                                         const ExactVec3 &way) {
  const auto [square, linear, constant] = surface.along(from, way);
  if (square == 0)
    return linear == 0 ? std::vector<ExactVec3>() : std::vector{from - way * Rational(constant / linear)};
  const auto root = exactRoot(linear * linear - 4 * square * constant);
  if (!root)
    return {};
  std::vector<ExactVec3> places;
  for (const Rational &end : {*root, Rational(-*root)})
    places.push_back(from + way * Rational((end - linear) / (2 * square)));
  return places;
}

/// Two axes whose coordinates tell a place of a plane; the third follows.
std::pair<int, int> axesOf(const Flat &plane) {
  for (const auto &[first, second] : {std::pair(0, 1), std::pair(1, 2)}) {
    const auto line = withCoordinate(plane, first, 0);
    const auto common = line ? withCoordinate(*line, second, 0) : std::nullopt;
    if (common && common->dimension() == 0)
      return {first, second};
  }
  return {2, 0};
}

/// Finds the places of one curve: of a surface in a plane.
class Curve {
public:
  Curve(const Quadric &surface, const Flat &plane)
      : m_surface(surface), m_plane(plane), m_axes(axesOf(plane)) {}

  [[nodiscard]] std::vector<ExactVec3> placesNear(const ExactVec3 &near, const SnapGrid &grid) const {
    std::vector<ExactVec3> places;
    for (int steps = -lineReach; steps <= lineReach; ++steps)
      for (const int axis : {m_axes.first, m_axes.second})
        add(onGridLine(axis, grid.nearest(near, axis) + grid.step * steps), places);
    if (const auto first = places.empty() ? someplace(near, grid) : places.front())
      addAround(*first, near, places);
    return places;
  }

private:
  static void add(std::vector<ExactVec3> more, std::vector<ExactVec3> &places) {
    places.insert(places.end(), more.begin(), more.end());
  }

  [[nodiscard]] std::vector<ExactVec3> onGridLine(int axis, const Rational &value) const {
    const auto line = withCoordinate(m_plane, axis, value);
    if (!line || line->dimension() != 1)
      return {};
    return exactPlacesOnLine(m_surface, line->nearest(ExactVec3(0)), line->direction());
  }

  /// Any place of the curve, with short numbers if there is one.
  [[nodiscard]] std::optional<ExactVec3> someplace(const ExactVec3 &near, const SnapGrid &grid) const {
    for (int parts = 1; parts <= finestParts; ++parts)
      for (int steps = 0; steps <= searchReach * parts; ++steps)
        for (const int axis : {m_axes.first, m_axes.second})
          for (const int way : {steps, -steps}) {
            const Rational value = grid.nearest(near, axis) + grid.step * Rational(way, parts);
            if (const auto found = onGridLine(axis, value); !found.empty())
              return found.front();
          }
    return {};
  }

  /// The way in the plane along which one of the axes' coordinates grows by 1, and the other stays.
  [[nodiscard]] ExactVec3 wayAlong(int axis, int other) const {
    const ExactVec3 way = withCoordinate(m_plane, other, 0)->direction();
    return way / way[axis];
  }

  /// From a place of the curve with lines of simple slopes that lead near to another one.
  void addAround(const ExactVec3 &first, const ExactVec3 &near, std::vector<ExactVec3> &places) const {
    const ExactVec3 way = near - first;
    auto [most, least] = m_axes;
    if (abs(way[most]) < abs(way[least]))
      std::swap(most, least);
    if (way[most] == 0)
      return;
    const Rational slope = way[least] / way[most];
    const ExactVec3 ahead = wayAlong(most, least);
    const ExactVec3 aside = wayAlong(least, most);
    for (int denominator = 1; denominator <= finestSlope; ++denominator) {
      const Rational rounded = roundToMultiple(slope, Rational(1, denominator));
      const ExactVec3 sight = ahead + aside * rounded;
      const auto [square, linear, constant] = m_surface.along(first, sight);
      if (square != 0 && linear != 0)
        places.push_back(first - sight * Rational(linear / square));
    }
  }

  const Quadric &m_surface;
  const Flat &m_plane;
  std::pair<int, int> m_axes; ///< whose coordinates tell a place of the plane
};

} // namespace

std::optional<Flat> withCoordinate(const Flat &flat, int axis, const Rational &value) {
  ExactVec3 normal(0);
  normal[axis] = 1;
  return Flat::intersection(flat, Flat::plane(normal * value, normal));
}

std::optional<Place> nearestOn(const Quadric &surface, const Flat &flat, const ExactVec3 &to) {
  if (flat.dimension() != 1 && flat.dimension() != 2)
    return {};
  const ExactVec3 from = flat.nearest(to);
  const ExactVec3 way =
      flat.dimension() == 1 ? flat.direction() : flat.nearest(from + surface.gradient(from)) - from;
  const auto [square, linear, constant] = surface.along(from, way);
  const double a = toDouble(square);
  const double b = toDouble(linear);
  const double c = toDouble(constant);
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0))
    return {};
  // The root that is nearer to 0, without subtracting what is nearly the same.
  const double sum = std::abs(b) + std::sqrt(discriminant);
  const double t = sum == 0 ? 0 : (b < 0 ? 2 : -2) * c / sum;
  return place(from) + place(way) * t;
}

std::vector<ExactVec3> exactPlacesOn(const Quadric &surface, const Flat &flat, const ExactVec3 &near,
                                     const SnapGrid &grid) {
  if (flat.dimension() == 1)
    return exactPlacesOnLine(surface, flat.nearest(near), flat.direction());
  return flat.dimension() == 2 ? Curve(surface, flat).placesNear(near, grid) : std::vector<ExactVec3>();
}

} // namespace halfspace
