// What a picture shows: a figure, and the tools of the hand.
#pragma once

#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/arrival.h"
#include "widgets/picture/shown_parts.h"
#include "widgets/picture/stage.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace halfspace {

/// The tool shown on the selected handle, of constant size on the screen.
struct Gizmo {
  enum class Part { AxisX, AxisY, AxisZ, PlaneXY, PlaneYZ, PlaneZX };
  enum class Mode { None, Horizontal, Vertical, AlongX, AlongY, AlongZ, AlongAxis, InPlane };
  Place at{};
  Mode mode = Mode::None;    ///< how the handle moves now: a flat disc, an upright arrow, or one locked axis
  bool axes = true;          ///< whether the three arrows and squares are shown
  std::optional<Place> axis; ///< the one direction of a handle that has no other (a plane's offset)
  Place normal{};            ///< of the plane, or of the surface at the handle, for InPlane
  std::optional<Part> hot;   ///< the part under the pointer
  std::vector<Stroke> clearOf; ///< pixels that its parts keep clear of: what is seen of handles
  std::string note;            ///< LaTeX beside the handle, as `\text{$z = 7$ fixed}`; may be empty
  bool operator==(const Gizmo &) const = default;
};

/// A small knob drawn for a handle that no mark shows (a plane's offset, the whole of a triangle).
struct Knob {
  std::string id;
  Place at{};
  std::optional<Place> axis; ///< drawn as a double arrow along it; else as a small cross of arrows
  Subject subject = Subject::Neutral;
  bool hot = false;
  bool operator==(const Knob &) const = default;
};

/// A line from a point down to the ground, with its foot, and its x and y on the axes where there are any.
struct DropLine {
  Place from{};
  bool operator==(const DropLine &) const = default;
};

/// Everything that a picture shows, in units of its stage.
struct SceneContent {
  Stage stage;
  Figure figure;
  ShownParts shown;                  ///< what is drawn of all that there is
  LabelsByHand labels;               ///< where the figure's labels stand that somebody has moved
  bool hasShadows = true;            ///< on the ground, where there is one
  std::set<std::string> highlighted; ///< mark ids that stand out
  Arrival arrival;                   ///< marks that fade in
  std::optional<Gizmo> gizmo;
  std::vector<Knob> knobs;
  std::optional<DropLine> dropLine;

  [[nodiscard]] bool showsAxes() const { return stage.hasAxes() && shown.axes; }
};

} // namespace halfspace
