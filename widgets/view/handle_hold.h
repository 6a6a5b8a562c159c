// A handle in the hand, from press to release.
#pragma once

#include "widgets/picture/hand/handle_drag.h"
#include "widgets/session_model.h"

namespace halfspace {

/// Takes where a pointer drags a handle to the model, as one gesture of that; however often the pointer
/// moves, the model follows once for each frame. Pixels are those of the device.
class HandleHold : public QObject {
  Q_OBJECT

public:
  explicit HandleHold(SessionModel &model) : m_model(model) {}

  /// Takes hold of a handle, as it is on the stage, at a pixel. Ends whatever gesture went on before.
  void begin(const Handle &handle, DragMode mode, glm::dvec2 pixel);
  [[nodiscard]] bool isHolding() const { return m_drag.has_value(); }
  /// How what is held moves; nothing where nothing is held.
  [[nodiscard]] std::optional<DragMode> mode() const;
  /// Goes on in another mode, unless the handle says by itself how it moves.
  void setMode(DragMode mode);

  /// The pointer is at a pixel now. While snapping is suspended what is held moves in finest steps.
  void pointTo(glm::dvec2 pixel, bool isSuspended);
  /// Suspends snapping, or goes on with it, where the pointer is.
  void setSuspended(bool suspended);
  /// Moves what is held to where the pointer is in a view, where that is new.
  void follow(const View &view);
  /// The special case that what is held has snapped to, in plain words; empty for none.
  [[nodiscard]] const std::string &caught() const { return m_caught; }

  /// Ends the gesture: what was moved stays, or goes back.
  void end(bool stays);
  /// Forgets what is held, as its gesture has ended.
  void letGo();
  /// How many handles have been dragged so far.
  [[nodiscard]] int dragCount() const { return m_dragCount; }

signals:
  void pointed();     ///< there is something to follow
  void aboutToMove(); ///< the model follows now
  void moved();       ///< it has, and all who look at it know
  void modeChanged();
  void caughtChanged();

private:
  void setCaught(const std::string &caught);

  SessionModel &m_model;
  GestureToken m_token = GestureToken::Nobodys;
  std::optional<HandleDrag> m_drag;
  std::optional<glm::dvec2> m_pointer; ///< the newest place, since it has moved
  bool m_isPending = false;            ///< whether there is something to follow
  bool m_isSuspended = false;
  std::string m_caught;
  int m_dragCount = 0;
};

} // namespace halfspace
