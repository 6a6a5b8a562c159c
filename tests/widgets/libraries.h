// Lessons of scenes alone, for a model that a test looks at.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace::test {

/// One lesson for each scene: `lesson0`, `lesson1` …
inline LessonLibrary libraryOf(const std::vector<Scene> &scenes) {
  LessonLibrary library;
  for (const Scene &scene : scenes) {
    Lesson lesson;
    lesson.id = "lesson" + std::to_string(library.lessons.size());
    lesson.scene = scene;
    library.lessons.push_back(std::move(lesson));
  }
  return library;
}

} // namespace halfspace::test
