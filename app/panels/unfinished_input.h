// What the hand holds and what is typed but not entered, wherever that is.
#pragma once

#include "app/panels/messages.h"
#include "lessons/scene/edit.h"

#include <QObject>

#include <optional>
#include <vector>

namespace halfspace {

class CoordinateRows;
class SceneInput;
class StepWorking;
class WorkingEditor;

/// Speaks for all places where something can be dragged or a number typed.
class UnfinishedInput : public QObject {
  Q_OBJECT
public:
  /// Where numbers are typed: in the working and in these lists. All must outlive it.
  UnfinishedInput(SceneInput &scene, StepWorking &working, const std::vector<CoordinateRows *> &lists,
                  const WorkingEditor &editor, Messages messages);

  /// Ends a drag and enters what is typed, as if the hand and the keys had left. What cannot be entered and
  /// why, else empty.
  [[nodiscard]] QString finish();
  /// The same before the session is left: where something cannot be entered the user is asked to go on
  /// without it. False where the session is to stay.
  [[nodiscard]] bool finishOrAsk();
  /// Takes back what is typed and refused.
  void drop();
  /// What entering the number that is being typed would change; nothing where none is.
  [[nodiscard]] std::optional<ChangeObject> typedChange() const;

signals:
  void typing(); ///< what is typed has changed, and is not entered yet

private:
  SceneInput &m_scene;
  StepWorking &m_working;
  std::vector<CoordinateRows *> m_lists;
  const WorkingEditor &m_editor;
  Messages m_messages;
};

} // namespace halfspace
