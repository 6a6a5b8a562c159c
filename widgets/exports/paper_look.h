// What a figure looks like on paper.
#pragma once

#include "widgets/exports/lengths.h"
#include "widgets/picture/theme.h"
#include "widgets/picture/view.h"

#include <optional>

namespace halfspace {

/// How those parts of lines are drawn that something stands before.
enum class HiddenLines {
  Dashed,
  Paler, ///< whole, in what a translucent face leaves of their colour
  LeftOut
};

struct PaperLook {
  double width = 8 * pointsPerCentimetre; ///< of the page, in points
  HiddenLines hidden = HiddenLines::Dashed;
  bool hasGround = true; ///< the colour of the page, where it is not white
};

/// What the page is painted with before all else: nothing where it is white, as paper is, or is to stay
/// clear.
[[nodiscard]] std::optional<Color> groundOf(const PaperLook &look, Color background);

/// A drawing on paper is composed on a view of so many pixels across: labels stand on whole ones, which are
/// finer than what is printed.
inline constexpr int drawingPixels = 4800;

/// A view of a shape, still without its camera, on so many pixels across that are `width` points, with the
/// labels of marks in type of a size in points.
[[nodiscard]] View viewOnPaper(PixelSize shape, double width, double typeSize, const Theme &theme,
                               int pixelsAcross = drawingPixels);

/// On a screen lines are tubes, as thick as it takes to be lit. On paper a pen needs this part of that …
inline constexpr double penPerTube = 0.45;
/// … and discs this part of balls,
inline constexpr double discPerBall = 0.62;
/// and dashes this part of their length.
inline constexpr double dashPerTube = 0.6;

} // namespace halfspace
