// What constructions of an angle of at most 90° share: of planes, of lines, of a line with a plane.
#pragma once

#include "lessons/construction/working.h"
#include "lessons/figure/figure.h"
#include "lessons/term/written.h"

#include <string>

namespace halfspace {

/// |a| = √(a·a)
[[nodiscard]] WorkingLine lengthLine(const Term &vector);

/// |a·b|/(|a||b|) of two vectors ≠ 0, which `ratio` is a name of: a cosine or a sine.
[[nodiscard]] WorkingLine acuteLine(const Term &ratio, const Term &a, const Term &b, std::string sentence);

/// A vector ≠ 0 as one side of an angle, in the look of its object.
struct AngleSide {
  Place vector;
  Subject subject;
  Look look;
};

/// An angle by its letter, with the degrees that are written behind that where numbers are.
struct DrawnAngle {
  Term letter;
  WrittenNumber degrees;
  bool isRight = false;
  Role role = Role::Result;
};

/// The angle as the mark that its letter is, at a corner from which both sides are drawn once more: an arc,
/// or the corner of a right angle.
void addAngle(Figure &figure, const DrawnAngle &angle, const Place &corner, const AngleSide &first,
              const AngleSide &second);

} // namespace halfspace
