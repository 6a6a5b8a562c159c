// What keys and menus do with the selected handle.
#pragma once

#include "widgets/view/scene_handles.h"

namespace halfspace {

/// Edits of the session, each an undo step.
class HandleEdits : public QObject {
  Q_OBJECT

public:
  HandleEdits(SessionModel &model, const Viewpoint &viewpoint, SceneHandles &handles)
      : m_model(model), m_viewpoint(viewpoint), m_handles(handles) {}

  /// Moves the selected handle as a key says (see steppedPlace); one that moves up and down does so with the
  /// arrow keys too. False for a key that moves nothing.
  bool step(int key, Qt::KeyboardModifiers modifiers);
  /// Whether the selected handle is a corner of an object whose corners come and go: a polygon, a prism.
  [[nodiscard]] bool isCornerSelected() const;
  /// Puts a corner behind the selected one, and selects it, or takes that away; refused where there are as
  /// many or as few as there may be.
  void addCorner();
  void removeCorner();

signals:
  void refused(const QString &sentence); ///< why something was not done

private:
  /// The object of the selected handle where that is one of its coordinates; null elsewhere.
  [[nodiscard]] const Object *objectOfSelected() const;
  /// False where it was refused.
  bool change(const std::string &object, const Object &changed, const QString &description);

  SessionModel &m_model;
  const Viewpoint &m_viewpoint;
  SceneHandles &m_handles;
};

} // namespace halfspace
