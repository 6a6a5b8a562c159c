// Drafts of lessons, checked as `halfspace check` does it.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/camera_view.h"
#include "lessons/scene/evaluation.h"

namespace halfspace {

/// A draft as the text of a file, and what is wrong with that.
struct CheckedDraft {
  std::string text; ///< empty where the draft cannot be written
  std::vector<DraftProblem> problems;
};

/// `start` is the scene that the lesson begins with. The first task is not to be done there already.
/// `file` is where the lesson is to be: its pictures are looked for in its folder.
[[nodiscard]] CheckedDraft checked(const LessonDraft &draft, const Evaluation &start,
                                   const CameraView &camera, const std::string &file);

} // namespace halfspace
