// What a step asks before it shows its numbers: its question, and the blanks in its lines.
#pragma once

#include "app/work/learner_progress.h"

#include <QObject>

namespace halfspace {

class WorkingPractice;

/// Knows whether the step's question is open, which the model asks it for, and keeps the learner's answer in
/// what is done.
class StepQuestion : public QObject {
  Q_OBJECT
public:
  /// All must outlive it; behind its end the model has no other outcome any more.
  StepQuestion(SessionModel &model, LearnerProgress &progress, const WorkingPractice &practice);

  /// Whether the step asks a question that is not answered yet.
  [[nodiscard]] bool isOpen() const;
  /// Whether numbers are hidden, until the question is answered or blank lines are filled in.
  [[nodiscard]] bool hidesNumbers() const;
  void answer(const QString &choice);
  /// The learner may answer once more. In a step without a question nothing happens.
  void reopen();
  /// The same for who changes the scene next: the model asks then.
  void forgetAnswer();

signals:
  void changed(); ///< it is answered or open again; the model is not told yet

private:
  SessionModel &m_model;
  LearnerProgress &m_progress;
  const WorkingPractice &m_practice;
};

} // namespace halfspace
