// A plane that a construction makes, as its tests look at it.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {

/// d of n·P + d = 0.
inline Rational constantOf(const PlaneObject &plane) { return -product(plane.normal, plane.point); }

/// (a, b, c, d)
inline SignedSquares coefficientsOf(const PlaneObject &plane) {
  SignedSquares all = numbers(plane.normal);
  all.push_back(signedSquare(constantOf(plane)));
  return all;
}

/// The names of a plane ≠ 0 with its constant, with an index where others have the same ones, and the points
/// that fulfil its equation.
inline void expectMadePlane(const PlaneObject &plane, const std::string &index, Recomputed &expected) {
  const bool isAlone = index.empty();
  expected.names[isAlone ? "\\vec n" : "\\vec n_" + index] = quantity(plane.normal);
  expected.names[isAlone ? "P_0" : "P_{0," + index + "}"] = quantity(plane.point);
  expected.names["d"] = quantity(constantOf(plane));
  expected.values["coefficients"] = coefficientsOf(plane);
  expected.unknowns = coordinatesAt(somewhere);
  expected.solution = coordinatesAt(footOf(somewhere, plane));
}

/// Wrong answers to the lines of its constant and of its equation.
inline void addPlaneEquation(std::vector<WrongAnswer> &all, const PlaneObject &plane) {
  const Rational right = constantOf(plane);
  Line constant("d", right, all);
  constant.add("the minus forgotten", Rational(-right));
  for (const auto &[how, value] : dotSlips(plane.normal, plane.point))
    constant.add(how, Rational(-value));
  Line equation("equation", right, all, variablePart(plane.normal));
  equation.add("the constant subtracted", Rational(-right));
  equation.add("the constant forgotten", 0);
}

} // namespace halfspace::test
