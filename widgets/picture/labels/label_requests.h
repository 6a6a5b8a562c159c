// What is written into the picture, and beside what.
#pragma once

#include "widgets/picture/labels/label_layout.h"
#include "widgets/picture/labels/label_picture.h"
#include "widgets/picture/shapes/ground.h"
#include "widgets/picture/shapes/tool_shapes.h"

namespace halfspace {

/// A label before it has a picture.
struct WrittenLabel {
  std::string id; ///< of the mark, or a name of its own for ticks and notes
  std::string latex;
  LabelStyle style;
  std::vector<LabelAnchor> anchors;
  LabelStand stand = LabelStand::Beside;
  bool isMark = false; ///< whether the id is a mark's
  double opacity = 1;
  LabelOwner owner = nobody;
  LabelRow row{};
  std::optional<LabelAnchor> own{}; ///< of a mark's label: what its place by hand counts from
  std::optional<LabelSpot> spot{};  ///< its place by hand
};

/// The height of type in design pixels.
inline constexpr double markTextSize = 22;
inline constexpr double tickTextSize = 15;

/// More labels of marks than this would hide the figure; the others are left out.
inline constexpr std::size_t mostMarkLabels = 150;

/// The labels of a content: marks (those that stand out first, then in the figure's order, mostMarkLabels at
/// most), the gizmo's note, the drop line's numbers, and those of the axes. Those of marks alone can be
/// switched off (`ShownParts`), or stand where somebody has put them.
[[nodiscard]] std::vector<WrittenLabel> writtenLabels(const SceneContent &content,
                                                      const std::vector<AxisLabel> &axes, const Theme &theme,
                                                      const View &view);

/// The points and lines on the screen that labels keep clear of; not what flies by. The gizmo's stand apart:
/// only what is there in passing keeps clear of them, and no label moves because a handle is selected.
[[nodiscard]] LabelObstacles obstaclesOf(const SceneContent &content, const std::optional<AxesReach> &axes,
                                         const Theme &theme, const View &view);

} // namespace halfspace
