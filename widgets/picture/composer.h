// What is on a picture: from a figure with its tools to one list of shapes.
#pragma once

#include "widgets/picture/labels/label_page.h"
#include "widgets/picture/shapes/shape_list.h"
#include "widgets/picture/shapes/translucent_faces.h"

#include <map>

namespace halfspace {

/// Composes pictures that follow one another, as the frames of a drag do: only what can have changed is made
/// anew. Setters take note.
class Composer {
public:
  explicit Composer(LabelSetter set);

  void setTheme(const Theme &theme);
  /// False: no gradient, and no shadows, which are patches where there is no ground.
  void setBackgroundVisible(bool visible);
  /// Takes a content as new, whatever was shown before.
  void setContent(SceneContent content);
  /// Other tools for the same content: nothing of the figure is made anew.
  void setTools(std::optional<Gizmo> gizmo, std::vector<Knob> knobs);
  /// Where it is looked at from, and on how many pixels; at least one each way. Whether that is another view.
  bool setView(View view);
  /// The next labels are placed as in a first picture: not where others stood before them.
  void forgetLabels();

  /// The picture of all that was set. Valid until it is called again.
  const ShapeList &compose();

  /// The id of the mark whose label or whose shape lies under a pixel of what was composed (nearest first),
  /// or empty.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const;

private:
  /// What changed since the last picture.
  struct Changes {
    bool theme = true;
    bool content = true;
    bool tools = true;
    bool view = true;
  };
  /// What takes time to be worked out of a figure, and does not depend on where it is looked at from.
  struct Worked {
    std::optional<Figure> thinned; ///< drawn instead of a figure with too many faces
    std::optional<AxesReach> axes; ///< where there are any
    double scale = 0;              ///< that the rest is for
    std::vector<Place> places;     ///< all corners and ends of marks
    FaceOrder faces;
  };
  /// What the grid depends on, besides the theme.
  struct GridKey {
    Place target{};
    double height = 0;
    double lineWidth = 0;
    bool operator==(const GridKey &) const = default;
  };
  using SharedMesh = std::shared_ptr<const TriangleMesh>;

  void workOutContent();
  void composeFigure();
  void composeBodies();
  void composeFaces();
  void composeGround();
  void composeAxes();
  void composeLabels();
  /// Puts shapes into a layer, which stays the one that it was where they are the same.
  void put(Layer layer, std::vector<Shape> shapes);
  [[nodiscard]] double scale() const;
  [[nodiscard]] const Figure &drawn() const {
    return m_worked.thinned ? *m_worked.thinned : m_content.figure;
  }
  [[nodiscard]] std::optional<Shadows> shadows() const;

  LabelSetter m_set;
  LabelPage m_page;
  Theme m_theme;
  bool m_isBackgroundVisible = true;
  SceneContent m_content;
  View m_view;
  Changes m_changes;
  Worked m_worked;
  std::optional<GridKey> m_grid;               ///< what the grid was made for; nothing: there is none
  std::map<SharedMesh, std::size_t> m_strides; ///< of the bodies that are shown
  ShapeList m_list;
};

} // namespace halfspace
