#include "app/open_session.h"

#include "lessons/guess.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/found_session.h"

#include <utility>

namespace halfspace {
namespace {

Problem unknownLesson(const LessonLibrary &library, const std::string &name) {
  std::vector<std::string> ids;
  for (const Lesson &lesson : library.lessons)
    ids.push_back(lesson.id);
  const std::string sentence = words("There is no lesson “{name}”, and no such file.", {{"name", name}});
  if (!nearestOf(name, ids).empty())
    return {withGuess(sentence, name, ids), "", 0, ""};
  std::string known;
  for (const std::string &id : ids)
    known += (known.empty() ? "" : ", ") + id;
  return {words("There is no lesson “{name}”, and no such file. The lessons are {known}.",
                {{"name", name}, {"known", known}}),
          "", 0, ""};
}

Result<OpenedSession> openLesson(const LessonLibrary &library, const std::string &id) {
  const Lesson *lesson = library.find(id);
  if (!lesson)
    return unknownLesson(library, id);
  return OpenedSession{startOf(*lesson), lesson};
}

/// Its lesson stands in the library from then on.
Result<OpenedSession> openLessonFile(LessonLibrary &library, const std::string &file) {
  auto lesson = readLesson(file);
  if (!lesson)
    return lesson.problem();
  const std::string id = lesson->id;
  library.put(std::move(*lesson));
  return openLesson(library, id);
}

/// Why no session can be opened at all; nothing where there are lessons.
std::optional<Problem> lackOfLessons(const LessonLibrary &library) {
  if (!library.lessons.empty())
    return {};
  return library.problems.empty()
             ? Problem{words("No lessons were found: the program is not installed completely."), "", 0, ""}
             : library.problems.front();
}

/// Fetches what a library without lessons needs for the lesson with an id; why there are none at all.
std::optional<Problem> fetchFor(const std::string &id, LessonLibrary &library, const FetchLessons &fetch) {
  if (library.lessons.empty() && fetch)
    fetch(id, library);
  return lackOfLessons(library);
}

/// Whether a name can be a file's alone.
bool isPath(const std::string &name) { return namesSession(name) || name.find('/') != std::string::npos; }

} // namespace

bool namesSession(const std::string &file) {
  return file.ends_with(".halfspace") || file.ends_with(".md") || namesPicture(file);
}

bool namesFile(const LessonLibrary &library, const std::string &name) {
  std::error_code error;
  return !name.empty() && !library.find(name) && (isPath(name) || std::filesystem::exists(name, error));
}

Result<OpenedSession> openSession(LessonLibrary &library, const std::string &name,
                                  const FetchLessons &fetch) {
  if (name.ends_with(".md")) // it is its own lesson
    return openLessonFile(library, name);
  if (!isPath(name))
    if (const auto lack = fetchFor(name, library, fetch))
      return *lack;
  if (!namesFile(library, name))
    return openLesson(library, name);
  auto file = findSession(name);
  if (!file)
    return file.problem();
  if (const auto lack = fetchFor(file->session.lesson, library, fetch))
    return *lack;
  const Lesson *lesson = library.find(file->session.lesson);
  const auto origin = file->isInPicture ? OpenedSession::Origin::Picture : OpenedSession::Origin::SessionFile;
  return OpenedSession{std::move(file->session), lesson, origin, std::move(file->text)};
}

} // namespace halfspace
