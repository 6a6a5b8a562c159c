// Which mark lies under a pixel.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/camera.h"

#include <string>

namespace halfspace {

/// Marks are found this near to what is drawn of them, in design pixels.
inline constexpr double markPickDistance = 8;

/// The id of the mark drawn at a pixel, or empty. Points come before lines and lines before faces, whatever
/// lies nearer: so what is small can be reached. Among points and lines the nearest on the screen wins, among
/// faces a polygon before the plane that it lies in, then the one nearest to the eye.
[[nodiscard]] std::string markUnder(glm::dvec2 pixel, const Figure &figure, const Camera &camera,
                                    PixelSize size, double pixelRatio);

} // namespace halfspace
