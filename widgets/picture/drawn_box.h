// How much of a page is drawn on.
#pragma once

#include "widgets/picture/shapes/flat_shapes.h"
#include "widgets/picture/shapes/shape_list.h"

#include <optional>

namespace halfspace {

/// The smallest box, in pixels of the view, around all that a composed picture shows but the grid and the
/// tools of the hand, as far as it lies on the view; nothing where it shows nothing.
[[nodiscard]] std::optional<PixelBox> drawnBox(const ShapeList &shapes);

/// Likewise for a flat picture with its labels.
[[nodiscard]] std::optional<PixelBox> drawnBox(const std::vector<FlatShape> &shapes,
                                               const std::vector<Shape> &labels, PixelSize size);

} // namespace halfspace
