// A lesson as a handout.
#include "app/commands.h"
#include "app/handout_file.h"
#include "app/standard_streams.h"
#include "lessons/files/write_file.h"
#include "lessons/words.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The steps to print, each once; or that the lesson does not have one.
Result<std::vector<std::size_t>> stepsOf(const HandoutCommand &command, const Lesson &lesson) {
  if (command.steps.empty())
    return allStepsOf(lesson);
  const auto count = static_cast<int>(lesson.steps.size());
  std::vector<std::size_t> steps;
  for (const auto &[first, last] : command.steps) {
    if (last > count)
      return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(count)}}), "", 0,
                     "--steps"};
    for (int step = first; step <= last; ++step)
      if (const auto index = static_cast<std::size_t>(step) - 1;
          std::find(steps.begin(), steps.end(), index) == steps.end())
        steps.push_back(index);
  }
  return steps;
}

} // namespace

int runHandout(const HandoutCommand &command) {
  LessonLibrary library;
  const auto opened = openSubject(library, command.subject, command.ownLessons, command.assignments);
  if (!opened)
    return fail(opened.problem());
  if (!opened->lesson)
    return fail({words("The lesson “{lesson}” of this file is not here: a handout needs its words.",
                       {{"lesson", opened->session.lesson}}),
                 "", 0, ""});
  auto steps = stepsOf(command, *opened->lesson);
  if (!steps)
    return fail(steps.problem());
  const HandoutChoices choices{std::move(*steps), command.paper,      command.columns,
                               command.hidden,    command.hasAnswers, command.isAnonymous};
  const Typesetter typesetter;
  const auto problem =
      writeFile(command.output, handoutFile(*opened->lesson, opened->session, choices, typesetter));
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
