// The themes: which colour and width a mark's subject and role have.
#pragma once

#include "lessons/figure/mark.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Color &) const = default;
};

/// t = 0 gives a, t = 1 gives b.
[[nodiscard]] Color mix(Color a, Color b, double t);

/// How everything looks. Hues are Okabe and Ito's, told apart with every common colour-vision deficiency, and
/// as dark or bright as it takes to be seen on the background.
struct Theme {
  std::string name;
  Color backgroundBottom;
  Color backgroundTop;
  Color ink; ///< text
  Color mutedInk;
  Color panel;  ///< the panels' background
  Color border; ///< hairlines between panels
  Color accent; ///< selection, links, the current step
  Color warning;
  Color grid;
  Color gridMajor;
  Color axis;
  Color shadow;
  Color halo;      ///< around labels
  Color planeFace; ///< the face of a blue plane's patch; its border and normal are darker
  double planeOpacity = 0.30;
  double polygonOpacity = 0.34;
  double lineScale = 1; ///< widths of everything drawn in 3D
  double textScale = 1;

  /// The colour of a mark's solid parts.
  [[nodiscard]] Color colorOf(Hue hue) const;
  [[nodiscard]] Color colorOf(Subject subject) const { return colorOf(hueOf(subject)); }
  /// The colour of text about it: darker where the solid colour would not read on the background.
  [[nodiscard]] Color inkOf(Hue hue) const;
  [[nodiscard]] Color inkOf(Subject subject) const { return inkOf(hueOf(subject)); }
  /// The face of a plane's patch, drawn with planeOpacity.
  [[nodiscard]] Color patchFaceOf(Hue hue) const { return hue == Hue::Blue ? planeFace : colorOf(hue); }

  std::array<Color, hueCount> solids{}; ///< by Hue
  std::array<Color, hueCount> inks{};   ///< by Hue

  bool operator==(const Theme &) const = default;
};

/// light, dark, print (white, black ink), projector (strong contrast, thick lines, large type).
[[nodiscard]] const std::vector<Theme> &themes();
/// The theme with this name, or null.
[[nodiscard]] const Theme *findTheme(std::string_view name);

} // namespace halfspace
