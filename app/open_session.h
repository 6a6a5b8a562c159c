// What the command line names: a lesson, or a file with a session: its own, or a picture.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"

#include <functional>
#include <string>

namespace halfspace {

/// A session with the lesson that it belongs to; a file may name a lesson that is not among ours, then there
/// is none.
struct OpenedSession {
  enum class Origin { Lesson, SessionFile, Picture };

  Session session;
  const Lesson *lesson = nullptr; ///< in the library that was given
  Origin origin = Origin::Lesson;
  std::string text{}; ///< the session as its file holds it; empty for a lesson
};

/// Whether a file's name ends as those that `openSession` opens: .halfspace, .md, or as a picture that can
/// carry a session.
[[nodiscard]] bool namesSession(const std::string &file);

/// Whether the name is a file's rather than a lesson's: it ends as one that can be opened, has a slash, or
/// is there.
[[nodiscard]] bool namesFile(const LessonLibrary &library, const std::string &name);

/// Puts lessons into a library that has none: the one with an id, or all that there are.
using FetchLessons = std::function<void(const std::string &id, LessonLibrary &library)>;

/// Opens a lesson by its id, a .halfspace file, a picture that carries a session, or a lesson's .md file. The
/// lesson of a file stands in the library from then on, also in the place of another with its id. Where the
/// library has no lessons yet, those that are needed are fetched.
[[nodiscard]] Result<OpenedSession> openSession(LessonLibrary &library, const std::string &name,
                                                const FetchLessons &fetch = {});

} // namespace halfspace
