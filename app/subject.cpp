#include "app/subject.h"

#include "lessons/session_file.h"
#include "lessons/words.h"

#include <fstream>

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

Result<Session> readSessionFile(const std::filesystem::path &file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return Problem{words("There is no such file."), file.string(), 0, ""};
  if (std::filesystem::file_size(file, error) > maxSessionBytes)
    return Problem{words("The file is larger than {limit} MiB: it is no session of this program.",
                         {{"limit", std::to_string(maxSessionBytes >> 20)}}),
                   file.string(), 0, ""};
  std::ifstream stream(file, std::ios::binary);
  // One byte more than allowed, in case the file grows while it is read.
  std::string text(maxSessionBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || !stream.eof())
    return Problem{words("The file cannot be read."), file.string(), 0, ""};
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return readSession(text, file.string());
}

bool namesFile(const LessonLibrary &library, const std::string &name) {
  std::error_code error;
  return !library.find(name) && (name.ends_with(".halfspace") || name.find('/') != std::string::npos ||
                                 std::filesystem::exists(name, error));
}

Result<OpenedSubject> openSubject(const LessonLibrary &library, const std::string &name,
                                  const std::vector<std::string> &assignments) {
  if (library.lessons.empty())
    return library.problems.empty()
               ? Problem{words("No lessons were found: the program is not installed completely."), "", 0, ""}
               : library.problems.front();
  OpenedSubject subject;
  if (namesFile(library, name)) {
    auto session = readSessionFile(name);
    if (!session)
      return session.problem();
    subject.session = std::move(*session);
    subject.lesson = library.find(subject.session.lesson);
  } else {
    subject.lesson = name.empty() ? &library.lessons.front() : library.find(name);
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
