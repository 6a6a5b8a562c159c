// A flat picture as shapes on a page, from the lowest to the topmost: for whoever paints them.
#pragma once

#include "widgets/picture/scene_content.h"
#include "widgets/picture/shapes/rhythm.h"
#include "widgets/picture/theme.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// A path on the page, in pixels: filled, or drawn with a pen.
struct FlatShape {
  std::vector<glm::dvec2> path;
  Color color;
  double opacity = 1;
  double width = 0;      ///< of the pen; 0: the path goes around what is filled
  Rhythm rhythm{};       ///< in pixels; empty: the pen does not leave the page
  bool isClosed = false; ///< the pen goes back to where it began
  bool isDisc = false;   ///< a disc around the path's one point, as wide as the pen
};

/// The shapes of a figure that is laid flat, seen by its camera.
[[nodiscard]] std::vector<FlatShape> flatShapes(const SceneContent &content, const Theme &theme,
                                                const View &view);

} // namespace halfspace
