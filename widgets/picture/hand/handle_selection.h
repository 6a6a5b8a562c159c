// Which of a scene's handles is selected, and which lies under the pointer.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/scene/hand/handles.h"
#include "widgets/picture/hand/handle_drag.h"

namespace halfspace {

/// The handles of a scene in their order, with the one that is selected and the one that the pointer is over.
class HandleSelection {
public:
  /// The handles that there are now. One that is gone is neither selected any more nor hovered.
  void take(std::vector<Handle> handles);
  [[nodiscard]] const std::vector<Handle> &handles() const { return m_handles; }
  /// Null where there is none with this id.
  [[nodiscard]] const Handle *find(const std::string &id) const;

  /// Selects a handle by its id, none with an empty one. Another one than before moves in x and y at first.
  void select(const std::string &id);
  /// The id of the selected handle; empty for none.
  [[nodiscard]] const std::string &selectedId() const { return m_selected; }
  /// Null for none.
  [[nodiscard]] const Handle *selected() const { return find(m_selected); }
  /// The id of the handle that comes behind the selected one, or before it; the first, or the last, where
  /// none is selected. Empty behind the last.
  [[nodiscard]] std::string next(bool forward) const;

  void hover(const std::string &id) { m_hovered = id; }
  [[nodiscard]] const std::string &hoveredId() const { return m_hovered; }
  /// Whether this is the selected or the hovered handle.
  [[nodiscard]] bool isHot(const Handle &handle) const {
    return handle.id == m_selected || handle.id == m_hovered;
  }
  /// The handle that the hand is about: the selected one, else the hovered one; null for none.
  [[nodiscard]] const Handle *regarded() const { return find(m_selected.empty() ? m_hovered : m_selected); }

  /// Whether the selected handle moves up and down when it is grabbed, instead of in x and y.
  [[nodiscard]] bool isVertical() const { return m_isVertical; }
  void switchDirection() { m_isVertical = !m_isVertical; }
  /// How the selected handle moves when it is grabbed from where the camera stands; nothing where none is
  /// selected, or where it cannot be grabbed.
  [[nodiscard]] std::optional<DragMode> mode(const Camera &camera) const;

private:
  std::vector<Handle> m_handles;
  std::string m_selected; ///< an id
  std::string m_hovered;  ///< an id
  bool m_isVertical = false;
};

/// The handle that moves the surface of very many triangles with this mark; null for other marks. Its own
/// place may lie hidden inside.
[[nodiscard]] const Handle *handleOfBody(const std::string &mark, const Figure &figure,
                                         const std::vector<Handle> &handles);

/// Where those positions are now, free ones and such on something, that are elsewhere than before.
[[nodiscard]] std::vector<Place> movedPositions(const std::vector<Handle> &before,
                                                const std::vector<Handle> &now);

} // namespace halfspace
