// The lines that the step shows of the numbers that its lesson begins with.
#pragma once

#include "lessons/lesson/shown.h"
#include "widgets/session_model.h"

#include <QObject>

#include <optional>

namespace halfspace {

/// Evaluates the lesson's own scene when it is asked, once for each lesson.
class StepAtStart : public QObject {
  Q_OBJECT
public:
  /// The model must outlive it.
  explicit StepAtStart(const SessionModel &model);

  [[nodiscard]] const LinesOfStep &lines();
  /// Whether the present case is one without lines that the step has at its start.
  [[nodiscard]] bool lacksLines();
  /// Whether another scene of the lesson would be such a case.
  [[nodiscard]] bool lacksLinesIn(const Scene &scene);

private:
  const SessionModel &m_model;
  std::optional<Evaluation> m_evaluation; ///< of the lesson; nothing: nobody has asked yet
  std::optional<LinesOfStep> m_lines;     ///< of the step, likewise
};

} // namespace halfspace
