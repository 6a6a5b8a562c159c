// The 3D picture of a figure: marks to meshes, labels, ground, shadows. VTK, no Qt.
#pragma once

#include "widgets/scene/arrival.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/label_picture.h"
#include "widgets/scene/stage.h"

#include <memory>

class vtkRenderer;

namespace halfspace {

/// The tool shown on the selected handle, of constant size on the screen.
struct Gizmo {
  enum class Part { AxisX, AxisY, AxisZ, PlaneXY, PlaneYZ, PlaneZX };
  enum class Mode { None, Horizontal, Vertical, AlongX, AlongY, AlongZ, AlongAxis };
  Place at{};
  Mode mode = Mode::None;    ///< how the handle moves now: a flat disc, an upright arrow, or one locked axis
  bool axes = true;          ///< whether the three arrows and squares are shown
  std::optional<Place> axis; ///< the one direction of a handle that has no other (a plane's offset)
  std::optional<Part> hot;   ///< the part under the pointer
  std::string note;          ///< LaTeX beside the handle, as `z = 7` with `\text{ fixed}`; may be empty
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
  std::set<std::string> highlighted; ///< mark ids that stand out
  Arrival arrival;                   ///< marks that fade in
  std::optional<Gizmo> gizmo;
  std::vector<Knob> knobs;
  std::optional<DropLine> dropLine;
};

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
  /// Another gizmo for the same content: nothing of the figure is made anew.
  void setGizmo(std::optional<Gizmo> gizmo);
  /// The view, its size in device pixels, and how many device pixels a design pixel has.
  void setView(const Camera &camera, PixelSize size, double pixelRatio);

  /// Brings meshes, order of translucent faces and labels up to date; to be called right before rendering.
  void prepare();

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
