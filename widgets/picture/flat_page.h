// The flat picture of a figure: the same marks, seen at a right angle to a page that two directions span, so
// that planes square to the page are lines, and what lies along the page has its true shape.
#pragma once

#include "lessons/lesson/lesson.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// How the page lies in space: by three unit vectors, square to each other.
struct FlatFrame {
  Place toEye{};
  Place right{};
  Place up{};
  ExactVec3 normal{}; ///< along `toEye`, of any length, exactly
};

/// A place of space in the page's own coordinates: towards the eye, to the right and upwards.
[[nodiscard]] Place onPage(const Place &place, const FlatFrame &frame);

/// The page on which `up` points upwards and `right` to the right, both in their true length. Where those lie
/// along one line (or the second is zero) any page along them will do. Nothing for a zero `up`.
[[nodiscard]] std::optional<FlatFrame> flatFrame(const ExactVec3 &up, const ExactVec3 &right);

/// That of a lesson's scene; nothing where the lesson has none, or the scene not both directions any more.
[[nodiscard]] std::optional<FlatFrame> flatFrame(const std::optional<FlatPage> &page, const Scene &scene);

/// Whatever is seen lower than this part of its width is seen as a line: far above rounding, far below a
/// pixel.
inline constexpr double edgeOnTolerance = 1e-9;

/// The figure turned so that the page is seen from the front, against the x axis: y is to the right, z is up.
/// A patch that is seen edge-on is the piece of a line that it looks like. Labels are without numbers.
[[nodiscard]] Figure laidFlat(const Figure &figure, const FlatFrame &frame);

/// The width and height that a flat picture takes of the room of a scene that it lies over, in pixels, where
/// the usual size of type is so many times as large. Nothing where half of the room is too little for it.
[[nodiscard]] std::optional<glm::dvec2> flatSizeIn(glm::dvec2 room, double sizeScale);

/// The camera that looks at such a figure, with all of it in view, beside what covers that, but what runs on
/// without end.
[[nodiscard]] Camera flatCamera(const Figure &flat, View view);

/// Whether such a camera still shows what it would be put up for.
[[nodiscard]] bool showsAll(const Figure &flat, const View &view);

/// The figure with planes that are seen edge-on ending at the sides of the view.
[[nodiscard]] Figure clippedTo(const View &view, Figure flat);

} // namespace halfspace
