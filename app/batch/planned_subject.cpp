#include "app/batch/planned_subject.h"

#include "app/batch/flight_frame.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <filesystem>

namespace halfspace {
namespace {

bool isFile(const std::string &subject, const OpenedSession &opened) {
  return opened.origin != OpenedSession::Origin::Lesson || subject.ends_with(".md");
}

int stepCountOf(const OpenedSession &opened) {
  return opened.lesson ? static_cast<int>(opened.lesson->steps.size()) : 0;
}

Problem tooFewSteps(const OpenedSession &opened) {
  return {words("The lesson has {count} steps.", {{"count", std::to_string(stepCountOf(opened))}}), "", 0,
          "--step"};
}

/// The steps that are asked for and are there.
std::vector<std::optional<int>> stepsOf(const OpenedSession &opened, const RenderCommand &command) {
  if (!command.eachStep && command.steps.empty())
    return {std::nullopt};
  const int count = stepCountOf(opened);
  std::vector<std::optional<int>> steps;
  for (int step = 1; step <= count; ++step)
    if (command.eachStep || std::count(command.steps.begin(), command.steps.end(), step) > 0)
      steps.emplace_back(step);
  return steps;
}

std::optional<Problem> refuseFrames(OpenedSession opened, const RenderCommand &command) {
  if (command.frames)
    for (const int frame : {command.frames->first, command.frames->second})
      if (auto problem = goToFrame(frame, opened))
        return problem;
  return {};
}

bool fillsAName(const std::string &column, const RenderCommand &command) {
  return std::any_of(command.outputs.begin(), command.outputs.end(),
                     [&](const FigureOutput &output) { return output.name.has(column); });
}

std::optional<Problem> refuseColumns(const OpenedSession &opened, const RenderCommand &command,
                                     const ValueRows &rows) {
  for (const std::string &column : rows.columns) {
    const Scene &scene = opened.session.scene;
    if (!findCoordinate(scene, column) && !fillsAName(column, command))
      return Problem{withValue(opened.session, column + "=").problem().sentence, rows.file, 1,
                     shortened(column)};
  }
  return {};
}

} // namespace

Result<PlannedSubject> plannedOf(const std::string &subject, const OpenedSession &opened,
                                 const RenderCommand &command, const ValueRows *rows) {
  auto steps = stepsOf(opened, command);
  if (steps.empty())
    return tooFewSteps(opened);
  if (auto problem = refuseFrames(opened, command))
    return std::move(*problem);
  if (auto problem = rows ? refuseColumns(opened, command, *rows) : std::nullopt)
    return std::move(*problem);
  const bool comesFromFile = isFile(subject, opened);
  return PlannedSubject{subject, comesFromFile ? std::filesystem::path(subject).stem().string() : subject,
                        comesFromFile, std::move(steps)};
}

std::optional<Problem> lackOfSteps(const OpenedSession &opened, const RenderCommand &command) {
  const int count = stepCountOf(opened);
  const bool hasAll =
      std::all_of(command.steps.begin(), command.steps.end(), [count](int step) { return step <= count; });
  return hasAll ? std::nullopt : std::optional(tooFewSteps(opened));
}

} // namespace halfspace
