// What a session's scene comes to, and how a step shows it.
#pragma once

#include "lessons/lesson/shown.h"
#include "widgets/picture/stage.h"

namespace halfspace {

/// The outcome of one scene after the other, each made from that before it. It is told when which part of it
/// is to follow.
class ShownScene {
public:
  /// What the scene comes to. What a step shows of it is taken next.
  void evaluate(const Scene &scene);
  /// The stage that suits the scene that was evaluated last; true where it is another one now.
  bool takeStage(const Scene &scene);
  void takeStep(const LessonStep &step, Question question);

  [[nodiscard]] const Evaluation &evaluation() const { return m_evaluation; }
  /// All of its marks.
  [[nodiscard]] const Figure &figure() const { return m_figure; }
  [[nodiscard]] const Shown &shown() const { return m_shown; }
  /// Whether that was taken with the question of its step answered.
  [[nodiscard]] Question question() const { return m_question; }
  [[nodiscard]] const Stage &stage() const { return m_stage; }

private:
  Evaluation m_evaluation;
  Figure m_figure;
  Shown m_shown;
  Question m_question = Question::Answered;
  Stage m_stage;
};

} // namespace halfspace
