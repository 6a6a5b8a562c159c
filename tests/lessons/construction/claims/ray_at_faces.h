// What claims about polygons and about solids compute alike: faces are given by their corners in order.
#pragma once

#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <algorithm>
#include <string>
#include <vector>

namespace halfspace::test {

using Corners = std::vector<ExactVec3>;

/// Behind the last corner comes the first.
inline const ExactVec3 &cornerOf(const Corners &face, std::size_t i) { return face[i % face.size()]; }
inline ExactVec3 edgeOf(const Corners &face, std::size_t i) {
  return cornerOf(face, i + 1) - cornerOf(face, i);
}

inline ExactVec3 normalOf(const Corners &face) {
  ExactVec3 normal(0);
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    normal += perpendicular(ExactVec3(face[i] - face[0]), ExactVec3(face[i + 1] - face[0]));
  return normal;
}

/// Whether no four corners span a volume.
inline bool areInOnePlane(const Corners &corners) {
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      for (std::size_t k = j + 1; k < corners.size(); ++k)
        if (determinant(ExactVec3(corners[i] - corners[0]), ExactVec3(corners[j] - corners[0]),
                        ExactVec3(corners[k] - corners[0])) != 0)
          return false;
  return true;
}

/// Of a flat face: whether all other corners lie on the inner side of each edge, none on its line.
inline bool isConvex(const Corners &face) {
  const ExactVec3 normal = normalOf(face);
  for (std::size_t i = 0; i < face.size(); ++i)
    for (std::size_t k = 2; k < face.size(); ++k)
      if (product(normal,
                  perpendicular(edgeOf(face, i), ExactVec3(cornerOf(face, i + k) - cornerOf(face, i)))) <= 0)
        return false;
  return true;
}

inline bool hasDouble(const Corners &corners) {
  return std::any_of(corners.begin(), corners.end(), [&](const ExactVec3 &each) {
    return std::count(corners.begin(), corners.end(), each) > 1;
  });
}

/// Which way round the ray an edge goes.
inline Rational turnAround(const RayObject &ray, const ExactVec3 &from, const ExactVec3 &to) {
  return determinant(ray.direction, ExactVec3(from - ray.origin), ExactVec3(to - from));
}

/// The number in the id of a line, as of the edge that it is about.
inline std::size_t numberIn(const std::string &line) {
  return std::stoul(line.substr(line.find_first_of("0123456789")));
}

} // namespace halfspace::test
