// What a figure looks like on paper.
#pragma once

namespace halfspace {

/// How those parts of lines are drawn that something stands before.
enum class HiddenLines {
  Dashed,
  Paler, ///< whole, in what a translucent face leaves of their colour
  LeftOut
};

struct PaperLook {
  double width = 226.77; ///< of the page, in points: 8 cm
  HiddenLines hidden = HiddenLines::Dashed;
  bool hasGround = true; ///< the colour of the page, where it is not white
};

/// On a screen lines are tubes, as thick as it takes to be lit. On paper a pen needs this part of that …
inline constexpr double penPerTube = 0.45;
/// … and discs this part of balls,
inline constexpr double discPerBall = 0.62;
/// and dashes this part of their length.
inline constexpr double dashPerTube = 0.6;

} // namespace halfspace
