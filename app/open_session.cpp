#include "app/open_session.h"

#include "lessons/scene/file/session_file.h"
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

Result<OpenedSession> openSessionFile(const LessonLibrary &library, const std::string &name) {
  auto file = readSessionFile(name);
  if (!file)
    return file.problem();
  const Lesson *lesson = library.find(file->session.lesson);
  return OpenedSession{std::move(file->session), lesson, std::move(file->text)};
}

Result<OpenedSession> open(LessonLibrary &library, const std::string &name) {
  if (name.ends_with(".md")) {
    const auto id = addLessonFile(library, name);
    return id ? openLesson(library, *id) : id.problem();
  }
  return namesFile(library, name) ? openSessionFile(library, name) : openLesson(library, name);
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
  if (library.lessons.empty() && !name.ends_with(".md")) // such a file is its own lesson
    return library.problems.empty()
               ? Problem{words("No lessons were found: the program is not installed completely."), "", 0, ""}
               : library.problems.front();
  auto opened = open(library, name);
  if (!opened)
    return opened;
  for (const std::string &assignment : assignments) {
    auto changed = withValue(std::move(opened->session), assignment);
    if (!changed)
      return changed.problem();
    opened->session = std::move(*changed);
  }
  return opened;
}

} // namespace halfspace
