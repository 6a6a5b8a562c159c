// Lessons as files, made of drafts.
#pragma once

#include "lessons/lesson/lesson_draft.h"
#include "lessons/scene/camera_view.h"
#include "lessons/scene/scene.h"

namespace halfspace {

/// The text of a lesson's file.
struct WrittenLesson {
  std::string text;
  std::vector<int> stepLines; ///< the line of each step's heading, counted from 1

  /// The step that a line of the file is of; nothing for one above the first.
  [[nodiscard]] std::optional<std::size_t> stepAt(int line) const;
};

/// The lesson that a draft is, tidied, with its scene, as parseLesson reads it back. What lessons have no
/// place for is left out: labels by hand, and meshes that are too large to be written. Numbers of the camera
/// are rounded to a millionth. Requires a draft in which problemsOf finds nothing.
[[nodiscard]] WrittenLesson writeLesson(const LessonDraft &draft, const Scene &scene,
                                        const CameraView &camera);

} // namespace halfspace
