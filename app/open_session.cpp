#include "app/open_session.h"

#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

Problem unknownLesson(const LessonLibrary &library, const std::string &name) {
  std::string known;
  for (const Lesson &lesson : library.lessons)
    known += (known.empty() ? "" : ", ") + lesson.id;
  return {words("There is no lesson “{name}”, and no such file. The lessons are {known}.",
                {{"name", name}, {"known", known}}),
          "", 0, ""};
}

/// Puts a lesson of a file into the library; the id.
Result<std::string> addLessonFile(LessonLibrary &library, const std::string &file) {
  auto lesson = readLesson(file);
  if (!lesson)
    return lesson.problem();
  std::string id = lesson->id;
  library.put(std::move(*lesson));
  return id;
}

Result<OpenedSession> openLesson(const LessonLibrary &library, const std::string &id) {
  const Lesson *lesson = library.find(id);
  if (!lesson)
    return unknownLesson(library, id);
  return OpenedSession{{lesson->id, 0, lesson->scene}, lesson, {}};
}

OpenedSession openedFile(const LessonLibrary &library, SessionFile file) {
  const Lesson *lesson = library.find(file.session.lesson);
  return {std::move(file.session), lesson, std::move(file.text)};
}

Result<OpenedSession> open(LessonLibrary &library, const std::string &name) {
  if (name.ends_with(".md")) {
    const auto id = addLessonFile(library, name);
    return id ? openLesson(library, *id) : id.problem();
  }
  if (!namesFile(library, name))
    return openLesson(library, name);
  auto file = readSessionFile(name);
  return file ? openedFile(library, std::move(*file)) : Result<OpenedSession>(file.problem());
}

/// Why no session can be opened at all; nothing where there are lessons.
std::optional<Problem> lackOfLessons(const LessonLibrary &library) {
  if (!library.lessons.empty())
    return {};
  return library.problems.empty()
             ? Problem{words("No lessons were found: the program is not installed completely."), "", 0, ""}
             : library.problems.front();
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

} // namespace

bool namesFile(const LessonLibrary &library, const std::string &name) {
  std::error_code error;
  return !name.empty() && !library.find(name) &&
         (name.ends_with(".halfspace") || name.ends_with(".md") || name.find('/') != std::string::npos ||
          std::filesystem::exists(name, error));
}

Result<OpenedSession> openSession(LessonLibrary &library, const std::string &name,
                                  const std::vector<std::string> &assignments) {
  const auto lack = lackOfLessons(library);
  if (lack && !name.ends_with(".md")) // such a file is its own lesson
    return *lack;
  auto opened = open(library, name);
  return opened ? withValues(std::move(*opened), assignments) : opened;
}

Result<OpenedSession> openSession(const LessonLibrary &library, SessionFile file,
                                  const std::vector<std::string> &assignments) {
  const auto lack = lackOfLessons(library);
  return lack ? Result<OpenedSession>(*lack) : withValues(openedFile(library, std::move(file)), assignments);
}

} // namespace halfspace
