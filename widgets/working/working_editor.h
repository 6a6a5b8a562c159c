// The numbers of a working that are coordinates, changed where they stand.
#pragma once

#include "widgets/numbers/coordinate_editor.h"
#include "widgets/working/step_working.h"

namespace halfspace {

/// Changes the scene as its coordinates are typed, stepped and scrubbed in the worked lines.
class WorkingEditor : public QObject {
  Q_OBJECT
public:
  /// Lives as long as the working; the model must outlive both.
  WorkingEditor(SessionModel &model, StepWorking &working);

  /// What entering the number that is being typed would change; nothing where it would change nothing.
  [[nodiscard]] std::optional<ChangeObject> typedChange() const;

private:
  /// The scene's number that a number in the working is.
  [[nodiscard]] std::optional<CoordinateNumber> numberOf(const CoordinateSource &source) const;

  SessionModel &m_model;
  StepWorking &m_working;
  CoordinateEditor m_editor;
};

} // namespace halfspace
