// Opens what commands name, one lesson or file after the other.
#pragma once

#include "app/open_session.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// Reads of the program's and a teacher's own lessons what is needed, and all of them only once.
class SubjectOpener {
public:
  /// `own`: folders of a teacher's own lessons.
  explicit SubjectOpener(std::vector<std::string> own) : m_own(std::move(own)) {}

  /// Opens a subject with the one lesson that it needs, where there is one. `library` is empty before, and
  /// has the lesson from then on.
  [[nodiscard]] Result<OpenedSession> open(const std::string &subject, LessonLibrary &library);

  /// All lessons. What is wrong with some is told on standard error; the others serve.
  [[nodiscard]] const LessonLibrary &all();

private:
  void fetch(const std::string &id, LessonLibrary &library);

  std::vector<std::string> m_own;
  std::optional<LessonLibrary> m_all;
};

/// Gives coordinates their values: name=value.
[[nodiscard]] Result<OpenedSession> withValues(OpenedSession opened,
                                               const std::vector<std::string> &assignments);

} // namespace halfspace
