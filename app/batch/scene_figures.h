// Figures of one scene: of its steps, or of the frames of its flight.
#pragma once

#include "app/command_line.h"
#include "app/figures/figure_maker.h"
#include "app/open_session.h"
#include "lessons/scene/evaluation.h"

#include <optional>

namespace halfspace {

/// The scene is evaluated when the first figure is asked for. All figures are seen from one place, and frames
/// are framed and labelled as the flight's first is.
class SceneFigures {
public:
  /// The command must outlive it, and so must the lesson of what is opened. `name` is what it is called where
  /// it has none.
  SceneFigures(const RenderCommand &command, OpenedSession opened, std::string name);

  /// What is to be drawn of a step, counted from 1, and of a frame.
  [[nodiscard]] Result<FigureSubject> subjectOf(std::optional<int> step, std::optional<int> frame,
                                                const FigureChoices &choices);

  /// All of the scene and its lesson that a figure depends on, as text: the same for the same figure. For
  /// commands that make only what has changed.
  [[nodiscard]] std::string madeOf(std::optional<int> step, std::optional<int> frame) const;

private:
  void evaluateOnce();
  /// Puts the scene there and evaluates it.
  [[nodiscard]] std::optional<Problem> showFrame(int frame);
  [[nodiscard]] SceneContent contentAt(const LessonStep *step, const Evaluation &evaluation) const;
  /// Flat pictures are each laid on their page by themselves.
  [[nodiscard]] Result<FlatPicture> flatAt(const LessonStep *step) const;
  /// What is to be seen when a figure is opened again: its scene, at its step.
  [[nodiscard]] Session sessionAt(const LessonStep *step) const;

  const RenderCommand &m_command;
  OpenedSession m_opened; ///< with the scene of the last frame
  std::string m_name;
  std::string m_openedAs; ///< the text of its session; empty where nobody asks what figures are made of
  std::optional<Evaluation> m_beginning{};  ///< as it was opened; nothing: not yet evaluated
  std::optional<Evaluation> m_firstFrame{}; ///< of the flight; nothing: no frame has been asked for
  Evaluation m_now;
  Stage m_stage{};
};

} // namespace halfspace
