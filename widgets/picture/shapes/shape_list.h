// A picture as one list of shapes, for whoever draws it: as a 3D picture, as vectors, on a page of the web.
#pragma once

#include "widgets/picture/depth_range.h"
#include "widgets/picture/shapes/shape.h"
#include "widgets/picture/view.h"

#include <array>

namespace halfspace {

/// In the order in which they are drawn.
enum class Layer {
  Ground, ///< the grid, painted on z = 0: whatever else there is lies over it, also from below
  Solids, ///< lines, arrows and points of the figure; these and the next three hide what stands behind them
  Axes,   ///< with their ticks, and the outlines of balls: what turns with the view, and casts no shadow
  Tools,  ///< what is drawn for the hand
  Bodies, ///< surfaces of very many triangles
  Faces,  ///< translucent, from back to front, split where they pass through one another
  Labels, ///< on the page, with leaders before them
};
inline constexpr std::size_t layerCount = 7;

/// The shapes of a layer in their order. Lists that follow one another share the layers that did not change:
/// whoever draws them can tell by their addresses.
using ShapeLayer = std::shared_ptr<const std::vector<Shape>>;

/// A gradient from the lower to the upper side of the page; or nothing.
struct Background {
  Color bottom;
  Color top;
  bool isVisible = true;
  bool operator==(const Background &) const = default;
};

/// Where the light comes from that casts solids, bodies and faces onto the ground, below the grid.
inline constexpr Place shadowLight{0.25, -0.35, 1.0};

/// The colours of the shadows.
struct Shadows {
  Color ofSolids; ///< and of bodies
  Color ofFaces;
  bool operator==(const Shadows &) const = default;
};

struct ShapeList {
  View view; ///< that they are made for
  DepthRange depths;
  Background background;
  std::optional<Shadows> shadows; ///< nothing: there are none
  bool leavesOutSurfaces = false; ///< as too many lie one behind another to be drawn in time
  std::array<ShapeLayer, layerCount> layers{};

  /// Null in a list that was not composed.
  [[nodiscard]] const ShapeLayer &layer(Layer which) const { return layers[static_cast<std::size_t>(which)]; }
  [[nodiscard]] ShapeLayer &layer(Layer which) { return layers[static_cast<std::size_t>(which)]; }
};

} // namespace halfspace
