// Where the camera goes on request.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/view.h"

#include <optional>

namespace halfspace {

// Figures, scenes and cameras are those of a stage.

/// A chosen view as a camera, and back.
[[nodiscard]] Camera cameraOf(const ChosenView &chosen);
[[nodiscard]] ChosenView chosenViewOf(const Camera &camera);

/// The camera of a view, turned as it is, that shows all places as large as they fit beside what covers the
/// view, with room for labels around them; the same camera for no places.
[[nodiscard]] Camera fitted(const View &view, const std::vector<Place> &places);

/// The figure without what was worked out far from all that is given, as where a ray crosses a plane that it
/// is nearly parallel to: beside that the rest would be a dot.
[[nodiscard]] Figure nearGiven(Figure figure);

/// How a lesson begins: from its direction, with the figure near what is given and the ends of the axes in
/// view, if there are any, and room for their labels. A design pixel has `pixelRatio` pixels.
[[nodiscard]] Camera homeView(const CameraView &from, const Figure &figure, bool axes, PixelSize size,
                              double pixelRatio);

/// The places that a picture of the figure should have in view; what runs on without end does not count, nor
/// does what lies farther away than all objects.
[[nodiscard]] std::vector<Place> placesOf(const Figure &figure);

/// The ends of the axes that stand in the figure.
[[nodiscard]] std::vector<Place> axisTips(const Figure &figure);

/// The places of a whole figure near what is given, and with `axes` the ends of those.
[[nodiscard]] std::vector<Place> placesNearGiven(const Figure &figure, bool axes);

/// Views along an axis: from the front (against x), from the right (against y), from the top (against z).
enum class AxisView { Front, Right, Top };

[[nodiscard]] Camera seenAlong(AxisView view, Camera camera);

/// Whether a figure has a plane or a triangle to be seen from its side or its front.
[[nodiscard]] bool showsPlane(const Figure &figure);

/// From the side of the first plane or triangle of a figure, so that it is seen as a line; unchanged without
/// one.
[[nodiscard]] Camera seenAlongPlane(const Figure &figure, Camera camera);

/// From straight in front of the same plane or triangle, from the side that the eye is on, so that its shapes
/// are true; unchanged without one.
[[nodiscard]] Camera seenFacingPlane(const Figure &figure, Camera camera);

/// The middle of all that a view shows of these places: what it is turned about. The camera's target where it
/// shows none.
[[nodiscard]] Place middleInView(const View &view, const std::vector<Place> &places);

/// A ray, or a line that is drawn with its direction.
struct Course {
  Place start{};
  Place direction{};
};

/// The first ray or line of a figure; one without a direction is not drawn.
[[nodiscard]] std::optional<Course> firstCourse(const Figure &figure);

enum class AlongCourse {
  Down,    ///< it leads away from the eye, which looks at its start
  Against, ///< it points at the eye
};

/// Along a figure's first ray or line; unchanged without one.
[[nodiscard]] Camera seenAlongCourse(AlongCourse way, const Figure &figure, Camera camera);

/// A camera between two: t = 0 is the first, t = 1 the second. It turns the short way round.
[[nodiscard]] Camera between(const Camera &from, const Camera &to, double t);

} // namespace halfspace
