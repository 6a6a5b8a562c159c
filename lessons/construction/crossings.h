// What a ray meets of many triangles, for a table of them and an axis of its parameter.
#pragma once

#include "geometry/intersect_ray_triangle.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// One of the triangles.
struct Crossing {
  /// Where the ray's line crosses the triangle's plane.
  struct Parameters {
    Rational t; ///< of the ray
    Rational s; ///< of the triangle, with tTriangle
    Rational tTriangle;
  };
  std::size_t number = 0; ///< among all, counted from 1
  std::string name;       ///< in plain words: barn 3
  RayTriangleCase which = RayTriangleCase::Miss;
  std::optional<Parameters> at;     ///< in the cases Hit, Miss and Behind
  std::vector<std::string> marks{}; ///< of the figure: what it lies in, and where it is hit
};

/// Sorted by t, then by number; those that have no t come last.
struct Crossings {
  /// Where there are very many, only some, among them the nearest and the chosen one.
  std::vector<Crossing> all;
  std::size_t fragments = 0;          ///< how many triangles there are
  std::optional<std::size_t> nearest; ///< the number of the one that is hit first
  std::size_t chosen = 0;             ///< the number of the one that is looked at; 0 for none
  std::string choice;                 ///< the scene's number that chooses it
  /// Of several that are asked one after the other up to the chosen one: the number of the nearest hit so
  /// far.
  std::optional<std::size_t> nearestSoFar;
};

/// The one that is hit first; null where none is.
[[nodiscard]] const Crossing *nearestOf(const Crossings &crossings);

} // namespace halfspace
