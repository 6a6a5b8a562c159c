// Seeded random polygons and solids for the tests of geometry.
#pragma once

#include "geometry/solid.h"
#include "tests/geometry/random_numbers.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace halfspace {

/// A strictly convex polygon of any orientation and first corner: corners of a parabola in a random plane.
inline Polygon<Rational> randomPolygon(RandomNumbers &random) {
  ExactVec3 u = random.nonZeroWholeVector(5);
  ExactVec3 v = random.nonZeroWholeVector(5);
  while (isZero(cross(u, v)))
    v = random.nonZeroWholeVector(5);
  std::set<int> places;
  for (const auto count = static_cast<std::size_t>(random.integer(3, 8)); places.size() < count;)
    places.insert(random.integer(-6, 6));
  const ExactVec3 origin = random.wholeVector(9);
  const Rational shrink(1, random.integer(1, 6));
  Polygon<Rational> corners;
  for (const int x : places)
    corners.push_back(origin + (u * Rational(x) + v * Rational(x * x)) * shrink);
  if (random.integer(0, 1) == 0)
    std::reverse(corners.begin(), corners.end());
  std::rotate(corners.begin(), corners.begin() + random.integer(0, 2), corners.end());
  return corners;
}

using Mesh = SolidMesh<Rational>;

inline Mesh cubeMesh() {
  Mesh mesh;
  for (const int z : {0, 2})
    for (const auto &[x, y] : {std::pair(0, 0), std::pair(2, 0), std::pair(2, 2), std::pair(0, 2)})
      mesh.vertices.emplace_back(x, y, z);
  mesh.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return mesh;
}

/// The cube with two of its faces split into triangles that share a plane.
inline Mesh splitCubeMesh() {
  Mesh mesh = cubeMesh();
  mesh.faces = {{3, 2, 1},    {4, 5, 6}, {0, 1, 5, 4}, {1, 2, 6, 5},
                {2, 3, 7, 6}, {4, 6, 7}, {3, 0, 4, 7}, {3, 1, 0}};
  return mesh;
}

inline Mesh tetrahedronMesh() {
  return {{ExactVec3(0, 0, 0), ExactVec3(3, 0, 0), ExactVec3(0, 3, 0), ExactVec3(0, 0, 3)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

inline Mesh octahedronMesh() {
  return {{ExactVec3(2, 0, 0), ExactVec3(-2, 0, 0), ExactVec3(0, 2, 0), ExactVec3(0, -2, 0),
           ExactVec3(0, 0, 2), ExactVec3(0, 0, -2)},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Over a base of five corners.
inline Mesh pyramidMesh() {
  return {{ExactVec3(-2, 4, 0), ExactVec3(-1, 1, 0), ExactVec3(0, 0, 0), ExactVec3(1, 1, 0),
           ExactVec3(2, 4, 0), ExactVec3(0, 2, 3)},
          {{4, 3, 2, 1, 0}, {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}}};
}

/// Adds the triangle of three vertices where it is a face of the hull of all; false where a fourth one lies
/// in its plane.
inline bool addHullFace(Mesh &mesh, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const auto plane = planeThrough(mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]);
  std::map<int, int> sides;
  for (const ExactVec3 &vertex : mesh.vertices)
    ++sides[evaluate(plane, vertex).sign()];
  if (sides[0] != 3)
    return false;
  if (sides[1] == 0)
    mesh.faces.push_back({i, j, k});
  else if (sides[-1] == 0)
    mesh.faces.push_back({i, k, j});
  return true;
}

/// Adds all faces of the hull; false where four vertices lie in a plane.
inline bool addHull(Mesh &mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = i + 1; j < count; ++j)
      for (std::uint32_t k = j + 1; k < count; ++k)
        if (!addHullFace(mesh, i, j, k))
          return false;
  return true;
}

/// The hull of random points, all of whose faces are triangles; points within are vertices of no face.
inline Mesh randomHull(RandomNumbers &random) {
  for (;;) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
      mesh.vertices.push_back(random.wholeVector(5));
    if (addHull(mesh))
      return mesh;
  }
}

/// The mesh moved, turned, stretched and slanted; the faces stay counterclockwise seen from outside.
inline Mesh transformed(Mesh mesh, RandomNumbers &random) {
  std::array<ExactVec3, 3> axes;
  Rational volume = 0;
  while (volume == 0) {
    for (ExactVec3 &axis : axes)
      axis = random.wholeVector(3);
    volume = dot(axes[0], cross(axes[1], axes[2]));
  }
  const ExactVec3 shift = random.vector(5);
  const Rational scale(1, random.integer(1, 4));
  for (ExactVec3 &vertex : mesh.vertices)
    vertex = shift + (axes[0] * vertex.x + axes[1] * vertex.y + axes[2] * vertex.z) * scale;
  if (volume < 0)
    for (auto &face : mesh.faces)
      std::reverse(face.begin(), face.end());
  return mesh;
}

inline Mesh randomSolid(RandomNumbers &random) {
  switch (random.integer(0, 5)) {
  case 0:
    return transformed(cubeMesh(), random);
  case 1:
    return transformed(splitCubeMesh(), random);
  case 2:
    return transformed(tetrahedronMesh(), random);
  case 3:
    return transformed(octahedronMesh(), random);
  case 4:
    return transformed(pyramidMesh(), random);
  default:
    return randomHull(random);
  }
}

} // namespace halfspace
