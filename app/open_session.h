// What the command line names: a lesson, or a file with a session.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/file/session_file.h"

namespace halfspace {

/// A session with the lesson that it belongs to; a file may name a lesson that is not among ours, then there
/// is none.
struct OpenedSession {
  Session session;
  const Lesson *lesson = nullptr;  ///< in the library that was given
  std::optional<std::string> text; ///< of the file that the session stands in, if it is a file's
};

/// Whether the name is a file's rather than a lesson's: it ends in .halfspace or .md, has a slash, or is
/// there.
[[nodiscard]] bool namesFile(const LessonLibrary &library, const std::string &name);

/// Opens a lesson by its id, a .halfspace file or a lesson's .md file, and gives coordinates their values.
/// The lesson of a file stands in the library from then on, also in the place of another with its id.
[[nodiscard]] Result<OpenedSession> openSession(LessonLibrary &library, const std::string &name,
                                                const std::vector<std::string> &assignments = {});

/// The same of a .halfspace file that has been read.
[[nodiscard]] Result<OpenedSession> openSession(const LessonLibrary &library, SessionFile file,
                                                const std::vector<std::string> &assignments);

} // namespace halfspace
