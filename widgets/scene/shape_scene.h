// The 3D picture of a list of shapes. VTK, no Qt.
#pragma once

#include "widgets/picture/shapes/shape_list.h"
#include "widgets/scene/label_overlay.h"
#include "widgets/scene/scene_actors.h"

namespace halfspace {

/// Keeps one VTK renderer in step with lists that follow one another: what a layer was drawn with serves for
/// as long as the layer stays the same. Nothing is drawn until the owner renders the window.
class ShapeScene {
public:
  explicit ShapeScene(LabelPainter labels);

  /// To be added to a render window by the owner.
  [[nodiscard]] vtkRenderer *renderer() const { return m_actors.renderer(); }

  /// To be called right before rendering. Requires a list that was composed.
  void show(const ShapeList &list);

  /// Narrows what the renderer shows to a strip of the view, as wide as the view and so many pixels high from
  /// the pixel row `top` on: for pictures too large to be drawn at once. Holds until the next show().
  void showStrip(int top, int height);

private:
  void showCamera();

  SceneActors m_actors;
  LabelOverlay m_labels;
  ShapeList m_list;
};

} // namespace halfspace
