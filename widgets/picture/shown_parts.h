// What of a picture is drawn.
#pragma once

#include <array>
#include <string_view>

namespace halfspace {

/// Each part on or off, in every kind of picture that has it.
struct ShownParts {
  bool labels = true;       ///< of marks
  bool coordinates = false; ///< behind the letters of points and vectors in space, as Q(11, 15, 8)
  bool dropLines = false;   ///< from points with letters down to the ground
  bool axes = true;         ///< with their ticks, numbers and names
  bool grid = true;         ///< on the ground
  bool shadows = true;      ///< on the ground, in lessons that have them
  bool operator==(const ShownParts &) const = default;
};

/// A part by the word that people have for it.
struct ShownPartName {
  std::string_view name;
  bool ShownParts::*part;
};
inline constexpr std::array shownPartNames{ShownPartName{"labels", &ShownParts::labels},
                                           ShownPartName{"coordinates", &ShownParts::coordinates},
                                           ShownPartName{"drop-lines", &ShownParts::dropLines},
                                           ShownPartName{"axes", &ShownParts::axes},
                                           ShownPartName{"grid", &ShownParts::grid},
                                           ShownPartName{"shadows", &ShownParts::shadows}};

} // namespace halfspace
