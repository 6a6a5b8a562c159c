// What the command line names: a lesson, or a file with a session.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/file/session_file.h"

#include <functional>
#include <optional>
#include <string>

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

/// Puts lessons into a library that has none: the one with an id, or all that there are.
using FetchLessons = std::function<void(const std::string &id, LessonLibrary &library)>;

/// Opens a lesson by its id, a .halfspace file or a lesson's .md file. The lesson of a file stands in the
/// library from then on, also in the place of another with its id. Where the library has no lessons yet,
/// those that are needed are fetched.
[[nodiscard]] Result<OpenedSession> openSession(LessonLibrary &library, const std::string &name,
                                                const FetchLessons &fetch = {});

} // namespace halfspace
