#include "lessons/object/flat.h"

#include <algorithm>

namespace halfspace {
namespace {

ExactVec3 axisVector(int axis) {
  ExactVec3 vector(0);
  vector[axis] = 1;
  return vector;
}

} // namespace

ExactVec3 anyPerpendicular(const ExactVec3 &vector) {
  const ExactVec3 first = cross(vector, axisVector(0));
  return isZero(first) ? cross(vector, axisVector(1)) : first;
}

Flat Flat::point(const ExactVec3 &at) {
  Flat flat;
  for (int axis = 0; axis < 3; ++axis)
    flat.require({axisVector(axis), at[axis]});
  return flat;
}

Flat Flat::line(const ExactVec3 &through, const ExactVec3 &direction) {
  const ExactVec3 first = anyPerpendicular(direction);
  const ExactVec3 second = cross(direction, first);
  Flat flat;
  flat.require({first, dot(first, through)});
  flat.require({second, dot(second, through)});
  return flat;
}

Flat Flat::plane(const ExactVec3 &through, const ExactVec3 &normal) {
  Flat flat;
  flat.require({normal, dot(normal, through)});
  return flat;
}

bool Flat::contains(const ExactVec3 &place) const {
  return std::all_of(m_equations.begin(), m_equations.end(),
                     [&](const Equation &equation) { return dot(equation.normal, place) == equation.value; });
}

ExactVec3 Flat::nearest(const ExactVec3 &place) const {
  ExactVec3 foot = place;
  for (const Equation &equation : m_equations)
    foot -= equation.normal *
            Rational((dot(equation.normal, foot) - equation.value) / dot(equation.normal, equation.normal));
  return foot;
}

bool Flat::moves(int axis) const {
  // The axis' part along the normals is all of it exactly when the coordinate is fixed.
  Rational fixedPart = 0;
  for (const Equation &equation : m_equations)
    fixedPart += equation.normal[axis] * equation.normal[axis] / dot(equation.normal, equation.normal);
  return fixedPart != 1;
}

ExactVec3 Flat::direction() const { return cross(m_equations.at(0).normal, m_equations.at(1).normal); }

std::optional<Flat> Flat::intersection(Flat a, const Flat &b) {
  for (const Equation &equation : b.m_equations)
    if (!a.require(equation))
      return {};
  return a;
}

bool Flat::require(Equation equation) {
  for (const Equation &known : m_equations) {
    const Rational part = dot(equation.normal, known.normal) / dot(known.normal, known.normal);
    equation.normal -= known.normal * part;
    equation.value -= known.value * part;
  }
  if (isZero(equation.normal))
    return equation.value == 0;
  m_equations.push_back(std::move(equation));
  return true;
}

} // namespace halfspace
