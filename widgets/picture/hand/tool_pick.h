// What a tool would take that the hand points with at a picture. Free of Qt and of VTK.
#pragma once

#include "widgets/picture/hand/object_tool.h"
#include "widgets/picture/stage.h"
#include "widgets/picture/view.h"

namespace halfspace {

/// The picture that a tool points at.
struct ToolScene {
  const Evaluation &evaluation; ///< of the scene
  const Figure &figure;         ///< what is seen of it, in units of the stage
  const Stage &stage;
  Rational step; ///< of the grid, in units of the stage
};

/// Where a new point may be: in the horizontal plane through a place, or upright above and below it.
struct ToolRoom {
  ExactVec3 at{}; ///< in units of the stage
  bool isUpright = false;
};

/// Where a new point is that is wanted: on the ground, above or below what it is told from, or at the height
/// of that.
[[nodiscard]] ToolRoom roomFor(const ToolWish &wish, const Stage &stage);

/// Whether a new point can be placed by hand from where the camera stands.
[[nodiscard]] bool canPlace(const ToolRoom &room, const Camera &camera);

/// What the tool takes at a pixel: a point that is seen there, else a new one of the room, on the grid. Of a
/// radius, how far the room's place under the pixel is from the centre, in steps of the grid and one at
/// least; of a point on an object a new one on the grid of that. Nothing where there is none, or where the
/// tool has it already.
[[nodiscard]] std::optional<ToolPick> pickUnder(glm::dvec2 pixel, const ObjectTool &tool,
                                                const ToolScene &scene, const ToolRoom &room,
                                                const View &view);

/// What the tool takes at a place, in units of the stage: a point that is just there, else a new one. Nothing
/// where the tool has it already, or wants a point on an object.
[[nodiscard]] std::optional<ToolPick> pickAt(const ExactVec3 &place, const ObjectTool &tool,
                                             const ToolScene &scene);

/// The tool in a scene that has become another one: with what it has taken where that is now. Nothing where
/// some of it is gone, or a new name is not new any more.
[[nodiscard]] std::optional<ObjectTool> followed(ObjectTool tool, const Evaluation &evaluation);

} // namespace halfspace
