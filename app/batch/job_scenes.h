// The scenes of a batch, opened one after the other.
#pragma once

#include "app/batch/figure_plan.h"
#include "app/batch/scene_figures.h"
#include "app/subject_opener.h"

namespace halfspace {

/// Keeps the subject and the scene of the last figure: those that follow one another mostly share them.
class JobScenes {
public:
  /// All must outlive it; `rows` is null where there are none.
  JobScenes(const RenderCommand &command, const std::vector<PlannedSubject> &subjects, const ValueRows *rows,
            SubjectOpener &opener)
      : m_command(command), m_subjects(subjects), m_rows(rows), m_opener(opener) {}

  /// The scene of a figure, with its row's values, until another's is asked for. A sentence where it cannot
  /// be opened, or does not take the values.
  [[nodiscard]] Result<SceneFigures *> sceneOf(const FigureJob &job);

private:
  [[nodiscard]] std::optional<Problem> openSubject(std::size_t subject);
  [[nodiscard]] Result<OpenedSession> withRow(OpenedSession opened, std::size_t row) const;

  const RenderCommand &m_command;
  const std::vector<PlannedSubject> &m_subjects;
  const ValueRows *m_rows;
  SubjectOpener &m_opener;

  LessonLibrary m_library; ///< with the subject's lesson
  std::optional<std::size_t> m_subject{};
  std::optional<OpenedSession> m_opened{}; ///< that subject
  std::optional<std::size_t> m_row{};
  std::optional<SceneFigures> m_scene{}; ///< that subject with that row's values
};

} // namespace halfspace
