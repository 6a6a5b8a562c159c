// The sphere through four points, recomputed as the common point of the planes halfway between them.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

#include <array>
#include <optional>

namespace halfspace::test {

using FourPoints = std::array<ExactVec3, 4>;

/// The point with these products with three vectors, by elimination; nothing where there is not just one.
inline std::optional<ExactVec3> commonPoint(std::array<ExactVec3, 3> rows, std::array<Rational, 3> right) {
  for (std::size_t column = 0; column < 3; ++column) {
    const auto axis = static_cast<int>(column);
    std::size_t pivot = column;
    while (pivot < 3 && rows.at(pivot)[axis] == 0)
      ++pivot;
    if (pivot == 3)
      return {};
    std::swap(rows.at(column), rows.at(pivot));
    std::swap(right.at(column), right.at(pivot));
    for (std::size_t row = 0; row < 3; ++row)
      if (row != column) {
        const Rational times = rows.at(row)[axis] / rows.at(column)[axis];
        rows.at(row) -= rows.at(column) * times;
        right.at(row) -= right.at(column) * times;
      }
  }
  return ExactVec3(right[0] / rows[0].x, right[1] / rows[1].y, right[2] / rows[2].z);
}

/// The middle of the sphere: the planes through the middles of three edges, across them.
inline std::optional<ExactVec3> middleOf(const FourPoints &points) {
  std::array<ExactVec3, 3> rows;
  std::array<Rational, 3> right;
  for (std::size_t i = 0; i < 3; ++i) {
    rows.at(i) = points.at(i + 1) - points.at(i);
    right.at(i) = product(rows.at(i), ExactVec3((points.at(i + 1) + points.at(i)) / Rational(2)));
  }
  return commonPoint(rows, right);
}

/// Of points in one plane. Three different ones on a line have no sphere; fewer than four others have many,
/// and so have four on a circle.
inline bool haveManySpheres(const FourPoints &points) {
  std::vector<ExactVec3> different;
  for (const ExactVec3 &point : points)
    if (std::find(different.begin(), different.end(), point) == different.end())
      different.push_back(point);
  for (std::size_t i = 0; i < different.size(); ++i)
    for (std::size_t k = i + 1; k < different.size(); ++k)
      for (std::size_t l = k + 1; l < different.size(); ++l)
        if (vanishes(perpendicular(ExactVec3(different[k] - different[i]),
                                   ExactVec3(different[l] - different[i]))))
          return false;
  if (different.size() < 4)
    return true;
  // Ptolemy: of the products of opposite ways between points of a circle one is the sum of the other two.
  // Their squares a, b, c then fulfil a² + b² + c² = 2(ab + bc + ca).
  const auto square = [&](std::size_t i, std::size_t k) {
    const ExactVec3 way = points.at(i) - points.at(k);
    return product(way, way);
  };
  const Rational a = square(0, 1) * square(2, 3);
  const Rational b = square(0, 2) * square(1, 3);
  const Rational c = square(0, 3) * square(1, 2);
  return a * a + b * b + c * c == 2 * (a * b + b * c + c * a);
}

/// `corners`: the names of the points in formulas.
inline Recomputed recomputeSphereThrough(const FourPoints &points,
                                         const std::array<std::string, 4> &corners) {
  Recomputed expected;
  for (std::size_t i = 0; i < 4; ++i)
    expected.names[corners.at(i)] = quantity(points.at(i));
  const std::array<ExactVec3, 3> sides{points[1] - points[0], points[2] - points[0], points[3] - points[0]};
  const std::array letters{"u", "v", "w"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string letter = letters.at(i);
    expected.names["\\vec " + letter] = quantity(sides.at(i));
    expected.names["\\vec n_" + std::to_string(i + 1)] =
        quantity(perpendicular(sides.at((i + 1) % 3), sides.at((i + 2) % 3)));
    if (vanishes(sides.at(i)))
      expected.vanished.insert("it." + letter);
  }
  const Rational volume = determinant(sides[0], sides[1], sides[2]);
  expected.names["V"] = quantity(volume);
  expected.values["det"] = number(volume);
  const auto middle = middleOf(points);
  expected.degenerate = !middle;
  if (!middle) {
    expected.caseName = haveManySpheres(points) ? "many-spheres" : "no-sphere";
    expected.vanished.insert({"it.S", "it.M"});
    return expected;
  }
  expected.caseName = "sphere";
  const ExactVec3 way = *middle - points[3];
  const Rational square = product(way, way);
  expected.values["center"] = numbers(*middle);
  expected.values["radius"] = SignedSquares{square};
  expected.names["M"] = quantity(*middle);
  expected.names["R"] = quantity(Surd::root(square));
  expected.names["S"] = expected.names["R"];
  expected.vanished.insert({"it.S.c", "it.S.R"}); // its centre is drawn as M, its radius as the sphere
  expected.unknowns = coordinatesAt(somewhere);
  expected.solution = coordinatesAt(*middle);
  return expected;
}

inline std::vector<WrongAnswer> wrongAnswersThrough(const FourPoints &points) {
  std::vector<WrongAnswer> all;
  const auto middle = middleOf(points);
  if (!middle)
    return all;
  const std::array<ExactVec3, 3> sides{points[1] - points[0], points[2] - points[0], points[3] - points[0]};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string id = "side" + std::to_string(i + 1);
    addVector(all, id.c_str(), "backwards", -sides.at(i), sides.at(i));
    const std::string product = "cross" + std::to_string(i + 1);
    addCross(all, product.c_str(), sides.at((i + 1) % 3), sides.at((i + 2) % 3));
  }
  const ExactVec3 across = perpendicular(sides[1], sides[2]);
  addProduct(all, "det", sides[0], across);
  const ExactVec3 way = *middle - points[0];
  addVector(all, "center", "the first point forgotten", way, *middle);
  addVector(all, "center", "divided by V alone", points[0] + way * Rational(2), *middle);
  addVector(all, "center", "subtracted", points[0] - way, *middle);
  addLength(all, "radius", way);
  return all;
}

} // namespace halfspace::test
