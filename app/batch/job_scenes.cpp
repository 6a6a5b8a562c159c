#include "app/batch/job_scenes.h"

#include "lessons/scene/file/session_file.h"

#include <utility>

namespace halfspace {

Result<SceneFigures *> JobScenes::sceneOf(const FigureJob &job) {
  if (m_scene && m_subject == job.subject && m_row == job.row)
    return &*m_scene;
  m_scene.reset();
  if (auto problem = openSubject(job.subject))
    return std::move(*problem);
  auto opened = job.row ? withRow(*m_opened, *job.row) : *m_opened;
  if (!opened)
    return opened.problem();
  m_row = job.row;
  m_scene.emplace(m_command, std::move(*opened), m_subjects[job.subject].name);
  return &*m_scene;
}

std::optional<Problem> JobScenes::openSubject(std::size_t subject) {
  if (m_opened && m_subject == subject)
    return {};
  m_opened.reset();
  m_library = {};
  auto opened = m_opener.open(m_subjects[subject].name, m_library);
  if (opened)
    opened = withValues(std::move(*opened), m_command.assignments);
  if (!opened)
    return opened.problem();
  m_subject = subject;
  m_opened = std::move(*opened);
  return {};
}

Result<OpenedSession> JobScenes::withRow(OpenedSession opened, std::size_t row) const {
  for (const auto &[column, value] : m_rows->rows[row].values) {
    const std::string &name = m_rows->columns[column];
    if (!findCoordinate(opened.session.scene, name))
      continue; // it only fills a name
    auto changed = withValue(std::move(opened.session), name + "=" + value);
    if (!changed)
      return Problem{changed.problem().sentence, m_rows->file, m_rows->rows[row].line, name};
    opened.session = std::move(*changed);
  }
  return opened;
}

} // namespace halfspace
