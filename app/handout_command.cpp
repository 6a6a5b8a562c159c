// A lesson as a handout.
#include "app/commands.h"
#include "app/handout_file.h"
#include "app/standard_streams.h"
#include "lessons/files/write_file.h"
#include "lessons/words.h"
#include "widgets/typeset/typesetter.h"

#include <filesystem>
#include <system_error>

namespace halfspace {
namespace {

/// The steps to print, each once; or that the lesson does not have one.
Result<std::vector<std::size_t>> stepsOf(const HandoutCommand &command, const Lesson &lesson) {
  if (command.steps.empty())
    return allStepsOf(lesson);
  std::vector<std::size_t> steps;
  for (const int step : command.steps)
    steps.push_back(static_cast<std::size_t>(step) - 1);
  if (steps.back() >= lesson.steps.size())
    return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(lesson.steps.size())}}),
                   "", 0, "--steps"};
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
  if (std::error_code error; std::filesystem::equivalent(command.subject, command.output, error))
    return fail(
        {words("“{file}” is read for this: a handout cannot be written over it.", {{"file", command.output}}),
         "", 0, "--output"});
  const HandoutChoices choices{std::move(*steps), command.paper,      command.columns,
                               command.hidden,    command.hasAnswers, command.isAnonymous};
  const Typesetter typesetter;
  const auto problem =
      writeFile(command.output, handoutFile(*opened->lesson, opened->session, choices, typesetter));
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
