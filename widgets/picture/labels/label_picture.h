// Pictures of labels, which the scene gets through a function that it is handed.
#pragma once

#include "widgets/picture/theme.h"

#include <functional>
#include <memory>
#include <vector>

namespace halfspace {

/// A typeset label as an image: rows from top to bottom, four bytes a pixel (red, green, blue, straight
/// alpha), one texel for one pixel of the screen.
struct LabelPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// What a label looks like.
struct LabelStyle {
  Color ink;
  Color halo;
  double pixelSize = 22; ///< height of the type in pixels of the output
  bool operator==(const LabelStyle &) const = default;
};

/// Makes the picture of a piece of LaTeX, never null. The same request gives the same picture object again
/// for as long as it is in use from frame to frame.
using LabelPainter =
    std::function<std::shared_ptr<const LabelPicture>(const std::string &latex, const LabelStyle &)>;

} // namespace halfspace
