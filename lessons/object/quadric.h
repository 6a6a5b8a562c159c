// Curved surfaces of second degree, exactly: the places that have a distance, and those that make a line
// touch a ball.
#pragma once

#include "lessons/object/flat.h"

#include <array>
#include <functional>
#include <span>

namespace halfspace {

/// The places where a polynomial of second degree is 0: a sphere, a cylinder, a cone. Never flat.
class Quadric {
public:
  using Function = std::function<Rational(const ExactVec3 &)>;
  /// A polynomial on a line: square·t² + linear·t + constant.
  struct OnLine {
    Rational square;
    Rational linear;
    Rational constant;
  };
  /// So many places tell which polynomial it is, and whether it is one.
  static constexpr std::size_t probeCount = 12;

  /// The zeros of a function; nothing where that is no polynomial of second degree, or one that is 0 on
  /// planes at most.
  [[nodiscard]] static std::optional<Quadric> of(const Function &function);
  /// The same of what a function comes to at the probes around a place.
  [[nodiscard]] static std::array<ExactVec3, probeCount> probes(const ExactVec3 &around);
  [[nodiscard]] static std::optional<Quadric> through(const ExactVec3 &around,
                                                      std::span<const Rational, probeCount> values);

  /// What the polynomial comes to; 0 on the surface.
  [[nodiscard]] Rational at(const ExactVec3 &place) const;
  [[nodiscard]] OnLine along(const ExactVec3 &from, const ExactVec3 &way) const;
  /// In which direction the polynomial grows fastest, at a place.
  [[nodiscard]] ExactVec3 gradient(const ExactVec3 &place) const;

private:
  [[nodiscard]] ExactVec3 &row(int axis) { return m_form.at(static_cast<std::size_t>(axis)); }
  /// Whether it is more than the square of one linear form, whose zeros are planes.
  [[nodiscard]] bool isCurved() const;

  ExactVec3 m_origin{0};             ///< places are counted from here
  std::array<ExactVec3, 3> m_form{}; ///< the rows of a symmetric matrix
  ExactVec3 m_slope{0};
  Rational m_constant = 0;
};

} // namespace halfspace
