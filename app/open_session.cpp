#include "app/open_session.h"

#include "lessons/scene/session_file.h"
#include "lessons/words.h"

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

} // namespace

bool namesFile(const LessonLibrary &library, const std::string &name) {
  std::error_code error;
  return !name.empty() && !library.find(name) &&
         (name.ends_with(".halfspace") || name.find('/') != std::string::npos ||
          std::filesystem::exists(name, error));
}

Result<OpenedSession> openSession(const LessonLibrary &library, const std::string &name,
                                  const std::vector<std::string> &assignments) {
  if (library.lessons.empty())
    return library.problems.empty()
               ? Problem{words("No lessons were found: the program is not installed completely."), "", 0, ""}
               : library.problems.front();
  OpenedSession opened;
  if (namesFile(library, name)) {
    auto file = readSessionFile(name);
    if (!file)
      return file.problem();
    opened.session = std::move(file->session);
    opened.text = std::move(file->text);
    opened.lesson = library.find(opened.session.lesson);
  } else {
    opened.lesson = library.find(name);
    if (!opened.lesson)
      return unknownLesson(library, name);
    opened.session = {opened.lesson->id, 0, opened.lesson->scene};
  }
  for (const std::string &assignment : assignments) {
    auto changed = withValue(std::move(opened.session), assignment);
    if (!changed)
      return changed.problem();
    opened.session = std::move(*changed);
  }
  return opened;
}

} // namespace halfspace
