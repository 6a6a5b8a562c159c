// How large the balls of a figure's points are beside what they stand on.
#pragma once

#include "lessons/figure/figure.h"

#include <vector>

namespace halfspace {

/// The balls of one figure. They grow with the size of type, and the surfaces that they stand on do not: a
/// ball takes no more than a part of its surface, so that the surface is seen. As it leaves the surface it
/// grows with its distance from it.
class BallSizes {
public:
  explicit BallSizes(const Figure &figure);

  /// The radius of a point's ball where all of its kind at scale 1 are multiplied by `thickness`.
  [[nodiscard]] double radiusOf(const PointMark &point, double thickness) const;

private:
  /// One face, or several around a body.
  struct Surface {
    std::vector<Place> face; ///< the corners of the only one; of a body empty
    Place low{};             ///< of the box along the axes around it
    Place high{};
  };
  [[nodiscard]] static double distanceTo(const Surface &surface, const Place &point);

  std::vector<Surface> m_surfaces;
};

} // namespace halfspace
