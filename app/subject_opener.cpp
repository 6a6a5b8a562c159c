#include "app/subject_opener.h"

#include "app/lessons_folder.h"
#include "app/standard_streams.h"
#include "lessons/scene/file/session_file.h"

#include <utility>

namespace halfspace {
namespace {

/// The lesson of this program with an id: its file is named by it. Nothing where there is none, or where it
/// cannot be read.
std::optional<Lesson> lessonOfOurs(const std::string &id) {
  if (id.empty() || id.find('/') != std::string::npos)
    return {};
  auto lesson = readLesson(lessonsFolder() / (id + ".md"));
  return lesson && lesson->id == id ? std::optional(std::move(*lesson)) : std::nullopt;
}

} // namespace

Result<OpenedSession> SubjectOpener::open(const std::string &subject, LessonLibrary &library) {
  return openSession(library, subject,
                     [this](const std::string &id, LessonLibrary &lessons) { fetch(id, lessons); });
}

const LessonLibrary &SubjectOpener::all() {
  if (!m_all) {
    m_all = allLessons(m_own);
    for (const Problem &problem : m_all->problems)
      printError(problem.text());
  }
  return *m_all;
}

void SubjectOpener::fetch(const std::string &id, LessonLibrary &library) {
  if (auto lesson = m_all ? std::nullopt : lessonOfOurs(id))
    library.lessons.push_back(std::move(*lesson));
  else if (const Lesson *known = all().find(id))
    library.lessons.push_back(*known);
  else
    library = all();
}

Result<OpenedSession> withValues(OpenedSession opened, const std::vector<std::string> &assignments) {
  for (const std::string &assignment : assignments) {
    auto changed = withValue(std::move(opened.session), assignment);
    if (!changed)
      return changed.problem();
    opened.session = std::move(*changed);
  }
  return opened;
}

} // namespace halfspace
