// What labels look like: their type as vectors, and their pictures. Setting a label in type needs no screen;
// whoever paints its picture is handed to those that show it.
#pragma once

#include "widgets/formula/layout.h"
#include "widgets/picture/rgba_image.h"
#include "widgets/picture/theme.h"

#include <functional>
#include <memory>
#include <string>

namespace halfspace {

/// A label set in type.
using LabelFormula = std::shared_ptr<const math::Layout>;

/// What a label looks like.
struct LabelStyle {
  Color ink;
  Color halo;
  double pixelSize = 22; ///< height of the type in pixels of the output
  bool operator==(const LabelStyle &) const = default;
};

/// The halo reaches this far around the strokes, in em.
inline constexpr double haloWidth = 0.11;

/// The room of a label on the screen, its halo included, in whole pixels.
struct LabelRoom {
  int width = 0;
  int height = 0;
  int left = 0;     ///< from its left side to where the formula begins
  int baseline = 0; ///< from its upper side to the formula's baseline: a whole pixel, so that labels in a row
                    ///< are equally crisp
};

[[nodiscard]] LabelRoom roomOf(const math::Layout &formula, const LabelStyle &style);

/// Paints what was set, as large as its room, one texel for one pixel of the screen; never null. The same
/// request gives the same object again for as long as it is in use from frame to frame.
using LabelPainter =
    std::function<std::shared_ptr<const RgbaImage>(const LabelFormula &formula, const LabelStyle &style)>;

} // namespace halfspace
