// Points, lines and planes of space as one thing, exactly.
#pragma once

#include "lessons/object/object.h"

namespace halfspace {

/// A vector that is perpendicular to one that is not zero.
[[nodiscard]] ExactVec3 anyPerpendicular(const ExactVec3 &vector);

/// A flat of space: a point, a line, a plane, or all of it. Kept as equations normal·x = value whose normals
/// are perpendicular to each other, so that the nearest place is found one equation at a time.
class Flat {
public:
  /// All of space.
  Flat() = default;
  [[nodiscard]] static Flat point(const ExactVec3 &at);
  /// Requires direction ≠ 0.
  [[nodiscard]] static Flat line(const ExactVec3 &through, const ExactVec3 &direction);
  /// Requires normal ≠ 0.
  [[nodiscard]] static Flat plane(const ExactVec3 &through, const ExactVec3 &normal);

  /// 0 for a point, 1 for a line, 2 for a plane, 3 for all of space.
  [[nodiscard]] std::size_t dimension() const { return 3 - m_equations.size(); }
  [[nodiscard]] bool contains(const ExactVec3 &place) const;
  /// The place of the flat that is nearest to this one.
  [[nodiscard]] ExactVec3 nearest(const ExactVec3 &place) const;
  /// Whether this coordinate (0, 1, 2) changes anywhere along the flat.
  [[nodiscard]] bool moves(int axis) const;
  /// The direction of a line. Requires dimension() == 1.
  [[nodiscard]] ExactVec3 direction() const;
  /// What two flats have in common; nothing when they do not meet.
  [[nodiscard]] static std::optional<Flat> intersection(Flat a, const Flat &b);

private:
  struct Equation {
    ExactVec3 normal;
    Rational value;
  };
  /// Adds an equation; false when no place of the flat satisfies it.
  bool require(Equation equation);

  std::vector<Equation> m_equations;
};

} // namespace halfspace
