// What the figures of all constructions are made with.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/object/object.h"
#include "lessons/term/term.h"

namespace halfspace {

/// Where exact coordinates are drawn.
[[nodiscard]] inline Place place(const ExactVec3 &exact) { return toDouble(exact); }

/// The same of a term that comes to a point or a vector.
[[nodiscard]] Place place(const Term &term);

/// The coordinates of a point as a label has them behind its letter, in LaTeX: `{(11,15,8)}`, or
/// `\approx {(…)}` where a number is rounded.
[[nodiscard]] std::string writtenCoordinates(const Term &point);
/// The same of a vector: `= {(1,2,3)}`, or `\approx {(…)}`.
[[nodiscard]] std::string writtenVector(const Term &vector);

/// What the mark has that draws a letter: its id is the mark that the term says it is, its label the letter.
[[nodiscard]] MarkBase drawn(const Term &letter, Role role, Subject subject);
/// A letter that is a point, drawn where it is, with its coordinates; and one that is a vector, drawn from a
/// place.
[[nodiscard]] PointMark pointOf(const Term &letter, Role role, Subject subject);
[[nodiscard]] ArrowMark arrowOf(const Term &letter, const Place &from, Role role, Subject subject);

/// A vector ≠ 0 that is drawn at another length, of which only the direction matters: so long in scene units,
/// and so long in every picture.
[[nodiscard]] ArrowMark arrowOfLength(MarkBase base, const Place &from, const ExactVec3 &direction,
                                      double length);
[[nodiscard]] ArrowMark arrowInPicture(MarkBase base, const Place &from, const Place &unit, double length);
/// The letter of a vector as such an arrow in scene units; nothing of the zero vector.
void addDirection(Figure &figure, const Term &vector, const Place &from, double length, Role role,
                  Subject subject);

/// Normal to the face that the corners go around, twice as long as its area; zero where there is none.
[[nodiscard]] ExactVec3 areaOf(const std::vector<ExactVec3> &corners);

/// Whether the corners lie in one plane and go around a convex face once. Straight corners are allowed.
[[nodiscard]] bool isFlatAndConvex(const std::vector<ExactVec3> &corners);

/// The unit vector of a direction ≠ 0, however short it is.
[[nodiscard]] Place unitOf(const ExactVec3 &direction);

} // namespace halfspace
