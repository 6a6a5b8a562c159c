// One drag of a handle in the flat picture: pixels in, exact objects out. Free of Qt.
#pragma once

#include "widgets/picture/flat_page.h"
#include "widgets/picture/hand/handle_drag.h"

namespace halfspace {

/// The handle that is seen at a pixel of a flat picture, within a margin in pixels, and can be moved along
/// its page; null for none. What points upwards on the page, whatever it does, cannot be turned there.
[[nodiscard]] const Handle *handleOnPage(glm::dvec2 pixel, const std::vector<Handle> &handles,
                                         const std::string &upwards, const FlatFrame &frame, const View &view,
                                         double margin);

/// Moves a handle along the page of a flat picture.
class FlatDrag {
public:
  /// `scene` is the scene at the press, seen on the page as it lies then. What its objects offer catches, and
  /// `asked` for besides.
  FlatDrag(PlacedScene scene, Handle handle, FlatFrame frame, glm::dvec2 pressed,
           std::vector<SnapTarget> asked = {});

  [[nodiscard]] const Handle &handle() const { return m_handle; }
  [[nodiscard]] const FlatFrame &frame() const { return m_frame; }
  /// The object with the pointer at a pixel of a view on the page.
  [[nodiscard]] std::optional<DragMove> moveTo(glm::dvec2 pixel, const Rational &step,
                                               const View &view) const;

private:
  PlacedScene m_scene;
  Handle m_handle;
  FlatFrame m_frame;
  glm::dvec2 m_pressed;
  std::vector<SnapTarget> m_targets;
};

} // namespace halfspace
