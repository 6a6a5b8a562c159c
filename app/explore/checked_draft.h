// Drafts of lessons, checked as `halfspace check` does it.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/camera_view.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// A draft as the text of a file, and what is wrong with that.
struct CheckedDraft {
  std::string text; ///< empty where the draft cannot be written
  std::vector<DraftProblem> problems;
};

/// `file` is where the lesson is to be: its pictures are looked for in its folder.
[[nodiscard]] CheckedDraft checked(const LessonDraft &draft, const Scene &scene, const CameraView &camera,
                                   const std::string &file);

} // namespace halfspace
