// The lessons of a folder.
#include "lessons/lesson/explore.h"
#include "lessons/lesson/lesson.h"
#include "lessons/words.h"

#include <algorithm>
#include <set>
#include <utility>

namespace halfspace {

const Lesson *LessonLibrary::find(std::string_view id) const {
  for (const Lesson &lesson : lessons)
    if (lesson.id == id)
      return &lesson;
  return id == exploreId ? &exploreLesson() : nullptr;
}

namespace {

/// The lesson files of a folder, by their names; a folder that cannot be read is a problem.
std::set<std::filesystem::path> lessonFilesIn(const std::filesystem::path &folder,
                                              std::vector<Problem> &problems) {
  std::error_code error;
  std::set<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".md")
      files.insert(entry->path());
  if (error)
    problems.push_back({words("The folder of lessons cannot be read."), folder.string(), 0, ""});
  return files;
}

/// Goes on with the lessons of a folder, in their order.
void addLessons(LessonLibrary &library, const std::filesystem::path &folder) {
  const auto first = static_cast<std::ptrdiff_t>(library.lessons.size());
  for (const auto &file : lessonFilesIn(folder, library.problems)) {
    auto lesson = readLesson(file);
    if (!lesson)
      library.problems.push_back(lesson.problem());
    else if (const Lesson *other = library.find(lesson->id); other && other->file == lesson->file)
      continue; // it is there already
    else if (other)
      library.problems.push_back(
          {words("Another lesson has the id “{id}” already. Give this one its own.", {{"id", lesson->id}}),
           file.string(), lesson->idLine, "id"});
    else
      library.lessons.push_back(std::move(*lesson));
  }
  std::stable_sort(library.lessons.begin() + first, library.lessons.end(),
                   [](const Lesson &a, const Lesson &b) { return a.order < b.order; });
}

/// A teacher's own lesson that names no chapter stands in one of such lessons.
void giveChapter(Lesson &lesson) {
  if (lesson.chapter.empty())
    lesson.chapter = words("Own lessons");
}

} // namespace

void LessonLibrary::put(Lesson lesson) {
  for (Lesson &each : lessons)
    if (each.id == lesson.id) {
      lesson.chapter = each.chapter;
      each = std::move(lesson);
      return;
    }
  giveChapter(lesson);
  lessons.push_back(std::move(lesson));
}

LessonLibrary readLessons(const std::filesystem::path &folder) {
  LessonLibrary library;
  addLessons(library, folder);
  return library;
}

void addOwnLessons(LessonLibrary &library, const std::filesystem::path &folder) {
  const auto first = static_cast<std::ptrdiff_t>(library.lessons.size());
  addLessons(library, folder);
  for (auto lesson = library.lessons.begin() + first; lesson != library.lessons.end(); ++lesson)
    giveChapter(*lesson);
}

} // namespace halfspace
