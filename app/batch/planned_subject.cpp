#include "app/batch/planned_subject.h"

#include "app/batch/flight_frame.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace halfspace {
namespace {

/// The file without its folder and ending; a lesson's id stays as it is.
std::string labelOf(const std::string &subject, const OpenedSession &opened) {
  const bool isFile = opened.origin != OpenedSession::Origin::Lesson || subject.ends_with(".md");
  return isFile ? std::filesystem::path(subject).stem().string() : subject;
}

Result<std::vector<std::optional<int>>> stepsOf(const OpenedSession &opened, const RenderCommand &command) {
  const int count = opened.lesson ? static_cast<int>(opened.lesson->steps.size()) : 0;
  std::vector<int> steps = command.steps;
  if (command.eachStep) {
    steps.resize(static_cast<std::size_t>(count));
    std::iota(steps.begin(), steps.end(), 1);
  }
  const bool asksForNone = steps.empty() && !command.eachStep;
  const bool hasAll = std::all_of(steps.begin(), steps.end(), [count](int step) { return step <= count; });
  if (!hasAll || (command.eachStep && count == 0))
    return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(count)}}), "", 0,
                   "--step"};
  if (asksForNone)
    return std::vector<std::optional<int>>{std::nullopt};
  return std::vector<std::optional<int>>(steps.begin(), steps.end());
}

std::optional<Problem> refuseFrames(const OpenedSession &opened, const RenderCommand &command) {
  if (command.frames)
    for (const int frame : {command.frames->first, command.frames->second})
      if (auto problem = refuseFrame(frame, opened))
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
  if (!steps)
    return steps.problem();
  if (auto problem = refuseFrames(opened, command))
    return std::move(*problem);
  if (auto problem = rows ? refuseColumns(opened, command, *rows) : std::nullopt)
    return std::move(*problem);
  return PlannedSubject{subject, labelOf(subject, opened), std::move(*steps)};
}

} // namespace halfspace
