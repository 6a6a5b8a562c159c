// The 3D picture of a figure: marks to meshes, labels, ground, shadows. VTK, no Qt.
#pragma once

#include "widgets/picture/labels/label_picture.h"
#include "widgets/picture/scene_content.h"
#include "widgets/picture/view.h"

#include <memory>

class vtkRenderer;

namespace halfspace {

/// Keeps one VTK renderer in step with what it is told to show. Setters only take note, and what they change
/// is made anew by prepare(); nothing is drawn until the owner renders the window.
class FigureScene {
public:
  explicit FigureScene(LabelPainter labels);
  ~FigureScene();
  FigureScene(const FigureScene &) = delete;
  FigureScene &operator=(const FigureScene &) = delete;

  /// To be added to a render window by the owner.
  [[nodiscard]] vtkRenderer *renderer() const;

  void setTheme(const Theme &theme);
  /// False: no gradient and no ground colour, for pictures with a transparent background.
  void setBackgroundVisible(bool visible);
  /// Takes a content as new, whatever was shown before: all its meshes are made anew.
  void setContent(SceneContent content);
  /// Where it is looked at from, and on how many pixels.
  void setView(View view);
  /// Other tools for the same content: nothing of the figure is made anew.
  void setTools(std::optional<Gizmo> gizmo, std::vector<Knob> knobs);

  /// Brings meshes, order of translucent faces and labels up to date; to be called right before rendering.
  void prepare();

  /// Whether what was prepared leaves out surfaces, as too many lie one behind another to be drawn in time.
  [[nodiscard]] bool leavesOutSurfaces() const;

  /// Narrows what the renderer shows to a strip of the view, as wide as the view and so many pixels high from
  /// the pixel row `top` on: for pictures too large to be drawn at once. Holds until the next prepare().
  void showStrip(int top, int height);

  /// The id of the mark whose label or whose drawn shape lies under a pixel (nearest first), or empty.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace halfspace
