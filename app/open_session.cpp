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
  OpenedSession subject;
  if (namesFile(library, name)) {
    auto file = readSessionFile(name);
    if (!file)
      return file.problem();
    subject.session = std::move(file->session);
    subject.text = std::move(file->text);
    subject.lesson = library.find(subject.session.lesson);
  } else {
    subject.lesson = library.find(name);
    if (!subject.lesson)
      return unknownLesson(library, name);
    subject.session = {subject.lesson->id, 0, subject.lesson->scene};
  }
  for (const std::string &assignment : assignments) {
    auto changed = withValue(std::move(subject.session), assignment);
    if (!changed)
      return changed.problem();
    subject.session = std::move(*changed);
  }
  return subject;
}

} // namespace halfspace
