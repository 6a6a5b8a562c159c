// What a step asks before it shows its numbers.
#pragma once

#include "app/work/learner_progress.h"

#include <QObject>

namespace halfspace {

/// Keeps the learner's answer in what is done.
class StepQuestion : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  StepQuestion(SessionModel &model, LearnerProgress &progress) : m_model(model), m_progress(progress) {}

  /// Whether the step asks one that is not answered yet.
  [[nodiscard]] bool isOpen() const { return m_progress.hasOpenQuestion(); }
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
};

} // namespace halfspace
