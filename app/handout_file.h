// The handout of a lesson as a file.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"
#include "widgets/exports/paper_look.h"
#include "widgets/handout/lesson_handout.h"

namespace halfspace {

class Typesetter;

/// What somebody wants of a handout, in the words of the window and of the command line alike.
struct HandoutChoices {
  std::vector<std::size_t> steps{}; ///< of the lesson, counted from 0
  HandoutPaper paper = HandoutPaper::A4;
  int columns = 1; ///< 1 or 2
  HiddenLines hidden = HiddenLines::Dashed;
  bool hasAnswers = false;
  bool isAnonymous = false; ///< without the session, with which the handout could be opened again
};

/// All steps of a lesson.
[[nodiscard]] std::vector<std::size_t> allStepsOf(const Lesson &lesson);

/// A PDF of the session's lesson, with the session's scene, seen as that says.
[[nodiscard]] std::string handoutFile(const Lesson &lesson, const Session &session,
                                      const HandoutChoices &choices, const Typesetter &typesetter);

} // namespace halfspace
