// Worked lines of shapes that many constructions have.
#pragma once

#include "lessons/formula.h"
#include "lessons/working.h"

namespace halfspace {

/// A line's name, and its two pieces in words.
struct LineWords {
  std::string id;
  std::string symbols; ///< LaTeX
  std::string sentence;
};

/// A line that subtracts two points: u = P1 − P0 with numbers and result.
[[nodiscard]] WorkingLine differenceLine(LineWords line, const ExactVec3 &to, const ExactVec3 &from,
                                         const ExactVec3 &difference);

/// A line for a dot product of two vectors, multiplied out.
[[nodiscard]] WorkingLine dotLine(LineWords line, const ExactVec3 &a, const ExactVec3 &b,
                                  const Rational &product);

/// A line for a dot product of two vectors, not multiplied out.
[[nodiscard]] WorkingLine shortDotLine(LineWords line, const ExactVec3 &a, const ExactVec3 &b,
                                       const Rational &product);

/// A line for the parameter at which a line meets a plane: a fraction of two dot products.
[[nodiscard]] WorkingLine parameterLine(LineWords line, const Rational &numerator,
                                        const Rational &denominator, const Rational &parameter);

/// A line for the point that a line reaches: Q + t·r.
[[nodiscard]] WorkingLine pointLine(LineWords line, const ExactVec3 &start, const Rational &parameter,
                                    const ExactVec3 &direction, const ExactVec3 &point);

} // namespace halfspace
