// The step begun anew, with the lesson's numbers or with others.
#pragma once

#include <QCoreApplication>

namespace halfspace {

struct Scene;
class LearnerProgress;
class SessionModel;
class StepQuestion;
class UnfinishedInput;

/// Takes back what the learner has done with the numbers that go.
class FreshStart {
  Q_DECLARE_TR_FUNCTIONS(halfspace::FreshStart)
public:
  /// All must outlive it.
  FreshStart(SessionModel &model, UnfinishedInput &input, StepQuestion &question, LearnerProgress &progress)
      : m_model(model), m_input(input), m_question(question), m_progress(progress) {}

  /// Back to the scene that the lesson begins with.
  void startOver();
  /// The same scene with other short numbers.
  void renewNumbers();

private:
  /// With the question that is asked again, in one outcome.
  void replaceScene(Scene scene, const QString &description);

  SessionModel &m_model;
  UnfinishedInput &m_input;
  StepQuestion &m_question;
  LearnerProgress &m_progress;
};

} // namespace halfspace
