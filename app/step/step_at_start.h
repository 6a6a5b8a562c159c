// What the step shows of the numbers that its lesson begins with.
#pragma once

#include "lessons/lesson/shown.h"
#include "widgets/session_model.h"

#include <QObject>

#include <optional>

namespace halfspace {

/// Evaluates the lesson's own scene when it is asked, once for each step.
class StepAtStart : public QObject {
  Q_OBJECT
public:
  /// The model must outlive it.
  explicit StepAtStart(const SessionModel &model);

  /// Once the step's question is answered.
  [[nodiscard]] const Shown &shown();
  /// Whether the present case is one without lines that the step has at its start.
  [[nodiscard]] bool lacksLines();

private:
  const SessionModel &m_model;
  std::optional<Shown> m_shown; ///< nothing: nobody has asked yet
};

} // namespace halfspace
