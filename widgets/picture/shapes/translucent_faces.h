// The order in which translucent faces are drawn: from back to front, split where they pass through one
// another.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/shapes/arrival.h"
#include "widgets/picture/shapes/shape.h"
#include "widgets/picture/theme.h"

#include <glm/vec4.hpp>

#include <memory>

namespace halfspace {

/// A planar convex polygon with its colour and opacity.
struct Face {
  std::vector<Place> corners;
  Color color;
  double opacity = 1;
  std::size_t mark = 0;         ///< that it is of, by its number in the figure
  std::optional<Globe> globe{}; ///< that it is a piece of
};

/// The faces of a figure's plane patches, polygons and balls. Patches come first: they lie under what is
/// drawn on them.
[[nodiscard]] std::vector<Face> facesOf(const Figure &figure, const std::set<std::string> &highlighted,
                                        const Theme &theme, const Arrival &arrival = {});

/// Faces ordered by a binary space partition: split once, ordered for each new eye by a walk through the
/// tree.
class FaceOrder {
public:
  FaceOrder();
  explicit FaceOrder(std::vector<Face> faces);
  ~FaceOrder();
  FaceOrder(FaceOrder &&) noexcept;
  FaceOrder &operator=(FaceOrder &&) noexcept;

  /// From back to front. `eye` is (place, 1), or (direction towards the eye, 0) for an orthographic view.
  /// Faces in the same plane keep the order that they were given in.
  [[nodiscard]] std::vector<const Face *> backToFront(glm::dvec4 eye) const;

private:
  struct Node;
  std::unique_ptr<Node> m_root;
};

} // namespace halfspace
