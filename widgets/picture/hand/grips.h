// What is seen of handles on the screen, and which of them a pixel grabs.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/scene/hand/handles.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/theme.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// A piece of what is seen of a handle, and how far from the eye it is.
struct GripPiece {
  Stroke stroke;
  double fromDepth = 0; ///< along the sight, in units of the stage; of the stroke's middle line
  double toDepth = 0;
  double unitsPerPixel = 0; ///< there
};

/// What is seen of a handle: the ball of a point, the head of an arrow, a knob. Where nothing is drawn, as of
/// an arrow without length, a small disc in front of everything.
struct Grip {
  std::string handle;   ///< its id
  std::string object;   ///< whose it is
  bool isWhole = false; ///< moves all of the object
  bool isSelected = false;
  std::vector<GripPiece> pieces{};
  std::optional<Stroke> ring{}; ///< around a selected handle that moves freely; it is grabbed up to there
};

/// Beside what is seen of a handle it is grabbed within this many design pixels …
inline constexpr double grabMargin = 5;
/// … and within so many where nothing else is: a hand that just misses it means it.
inline constexpr double missMargin = 12;

/// The grips of the handles that can be grabbed from where the camera stands, as the figure shows them. The
/// selected one may be none.
[[nodiscard]] std::vector<Grip> gripsOf(const std::vector<Handle> &handles, const std::string &selected,
                                        const Figure &figure, const Theme &theme, const View &view);

/// The id of the handle that is grabbed at a pixel, or empty. What is seen there wins, the nearest to the eye
/// first; but what moves a whole object, whose cross may reach over a corner, comes behind the object's
/// parts. Beside what is seen, within a margin in pixels, the nearest on the screen wins. Of handles in one
/// place the selected one wins.
[[nodiscard]] std::string handleGrabbedAt(glm::dvec2 pixel, const std::vector<Grip> &grips, double margin);

/// All that is seen of handles.
[[nodiscard]] std::vector<Stroke> strokesOf(const std::vector<Grip> &grips);

} // namespace halfspace
