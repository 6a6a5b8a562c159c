#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

using Planes = std::array<PlaneObject, 3>;

Planes planesOf(Objects objects) {
  Planes planes;
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes.at(i) = objectAs<PlaneObject>(*objects[i]).value();
  return planes;
}

/// A row n | n·P0 of the equations n·P = n·P0.
using Row = std::array<Rational, 4>;

/// How many rows are left of the equations, and of their left sides alone, by elimination.
struct Ranks {
  std::size_t left = 0;
  std::size_t whole = 0;
};

Ranks ranksOf(const Planes &planes) {
  std::vector<Row> rows;
  for (const PlaneObject &plane : planes)
    rows.push_back({plane.normal.x, plane.normal.y, plane.normal.z, product(plane.normal, plane.point)});
  Ranks ranks;
  for (std::size_t column = 0; column < 4; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(ranks.whole), rows.end(),
                                    [&](const Row &row) { return row.at(column) != 0; });
    if (pivot == rows.end())
      continue;
    std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(ranks.whole), pivot);
    const Row top = rows[ranks.whole];
    for (std::size_t below = ranks.whole + 1; below < rows.size(); ++below) {
      const Rational factor = rows[below].at(column) / top.at(column);
      for (std::size_t i = 0; i < 4; ++i)
        rows[below].at(i) -= factor * top.at(i);
    }
    ++ranks.whole;
    ranks.left += column < 3 ? 1 : 0;
  }
  return ranks;
}

std::string caseOf(const Planes &planes, const std::array<ExactVec3, 3> &along) {
  if (std::any_of(planes.begin(), planes.end(), [](const auto &plane) { return vanishes(plane.normal); }))
    return "zero-normal";
  const auto [left, whole] = ranksOf(planes);
  if (left == 3)
    return "point";
  if (left == whole)
    return left == 2 ? "line" : "coincident";
  return std::none_of(along.begin(), along.end(), vanishes) ? "prism" : "parallel";
}

Recomputed recompute(Objects objects) {
  const Planes planes = planesOf(objects);
  const auto &[E, F, G] = planes;
  const std::array along{perpendicular(F.normal, G.normal), perpendicular(G.normal, E.normal),
                         perpendicular(E.normal, F.normal)};
  const Rational D = determinant(E.normal, F.normal, G.normal);
  const ExactVec3 right{product(E.normal, E.point), product(F.normal, F.point), product(G.normal, G.point)};
  // Each coordinate by Cramer's rule: the rows' columns, one of them by the right sides.
  const auto column = [&](int axis) {
    return ExactVec3{planes[0].normal[axis], planes[1].normal[axis], planes[2].normal[axis]};
  };
  const ExactVec3 weighted{determinant(right, column(1), column(2)), determinant(column(0), right, column(2)),
                           determinant(column(0), column(1), right)};
  Recomputed expected;
  expected.caseName = caseOf(planes, along);
  expected.degenerate = expected.caseName == "zero-normal";
  expected.names = {{"D", quantity(D)}, {"X", quantity(weighted)}};
  const std::array<std::string, 3> names{"E", "F", "G"};
  const std::array<std::string, 3> letters{"a", "b", "c"};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneObject &plane = planes.at(i);
    expected.names["\\vec n_" + names.at(i)] = quantity(plane.normal);
    expected.names["P_{0," + names.at(i) + "}"] = quantity(plane.point);
    expected.names["d_" + names.at(i)] = quantity(Rational(-right[static_cast<int>(i)]));
    expected.names["\\vec " + letters.at(i)] = quantity(along.at(i));
    if (vanishes(plane.normal))
      expected.vanished.insert(names.at(i) + ".n");
    if (vanishes(along.at(i)))
      expected.vanished.insert("it." + letters.at(i));
  }
  if (expected.degenerate)
    return expected;
  expected.values["det"] = number(D);
  SignedSquares homogeneous = numbers(weighted);
  homogeneous.push_back(signedSquare(D));
  expected.values["homogeneous"] = homogeneous;
  if (expected.caseName != "point")
    return expected;
  const ExactVec3 point = weighted * Rational(1 / D);
  expected.values["point"] = numbers(point);
  expected.names["S"] = quantity(point);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Planes planes = planesOf(objects);
  std::vector<WrongAnswer> all;
  if (std::any_of(planes.begin(), planes.end(), [](const auto &plane) { return vanishes(plane.normal); }))
    return all;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto &[point, normal] = planes.at(i);
    const Rational product = times(normal, point);
    Line line("d" + std::to_string(i + 1), Rational(-product), all);
    line.add("the minus forgotten", product);
    for (const auto &[how, value] : dotSlips(normal, point))
      line.add(how, Rational(-value));
  }
  const auto &[E, F, G] = planes;
  addProduct(all, "det", E.normal, perpendicular(F.normal, G.normal));
  return all;
}

} // namespace

namespace expected {

Expected three_planes() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
