#include "app/batch/figure_plan.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

Problem refused(std::string sentence) { return {std::move(sentence), "", 0, "--output"}; }

std::string inBraces(std::string_view place) { return "{" + std::string(place) + "}"; }

bool isKnownPlace(std::string_view place) {
  return place == lessonPlace || place == stepPlace || place == rowPlace || place == framePlace;
}

/// Why nothing fills a place; nothing where something does.
std::optional<Problem> lackFor(const std::string &place, const PlanRequest &request) {
  const auto needs = [&](const char *option) {
    return refused(words("{place} in the name of a file needs {option}.",
                         {{"place", inBraces(place)}, {"option", option}}));
  };
  const auto hasNoStep = [](const PlannedSubject &subject) { return !subject.steps.front(); };
  if (place == lessonPlace || (request.rows && request.rows->columnOf(place)))
    return {};
  if (place == stepPlace)
    return std::any_of(request.subjects.begin(), request.subjects.end(), hasNoStep)
               ? std::optional(needs("--steps"))
               : std::nullopt;
  if (place == rowPlace)
    return request.rows ? std::nullopt : std::optional(needs("--rows"));
  if (place == framePlace)
    return request.frames ? std::nullopt : std::optional(needs("--frames"));
  return refused(
      words("Nothing fills {place} in the name of a file: neither {known} nor a column of --rows.",
            {{"place", inBraces(shortened(place))}, {"known", "{lesson}, {step}, {row}, {frame}"}}));
}

std::optional<Problem> refusePlaces(const PlanRequest &request) {
  for (const OutputName &output : request.outputs)
    for (const std::string &place : output.places())
      if (auto problem = lackFor(place, request))
        return problem;
  if (request.rows)
    for (const std::string &column : request.rows->columns)
      if (isKnownPlace(column) && (column != framePlace || request.frames))
        return Problem{words("A column cannot be called so: the places of names are {known}.",
                             {{"known", "{lesson}, {step}, {row}, {frame}"}}),
                       request.rows->file, 1, column};
  return {};
}

std::size_t framesOf(const PlanRequest &request) {
  return request.frames ? static_cast<std::size_t>(request.frames->second - request.frames->first) + 1 : 1;
}

std::optional<Problem> refuseTooMany(const PlanRequest &request) {
  std::size_t steps = 0;
  for (const PlannedSubject &subject : request.subjects)
    steps += subject.steps.size();
  std::size_t count = 1;
  for (const std::size_t factor :
       {steps, request.rows ? request.rows->rows.size() : 1, framesOf(request), request.outputs.size()})
    count = std::min(count * factor, mostFigures + 1); // none of them is large enough to overflow
  if (count <= mostFigures)
    return {};
  return Problem{words("These are too many figures for one command: at most {count} are made.",
                       {{"count", std::to_string(mostFigures)}}),
                 "", 0, ""};
}

std::string fileOf(const FigureJob &job, const PlanRequest &request) {
  return request.outputs[job.output].filled([&](const std::string &place) -> std::string {
    if (place == lessonPlace)
      return request.subjects[job.subject].label;
    if (place == stepPlace)
      return std::to_string(*job.step);
    if (place == rowPlace)
      return std::to_string(*job.row + 1);
    if (place == framePlace && job.frame)
      return std::to_string(*job.frame);
    return request.rows->valueIn(*job.row, *request.rows->columnOf(place));
  });
}

/// Adds the figures of a subject's step with a row's values.
void addJobs(const PlanRequest &request, FigureJob job, std::vector<FigureJob> &jobs) {
  for (std::size_t i = 0; i < framesOf(request); ++i) {
    if (request.frames)
      job.frame = request.frames->first + static_cast<int>(i);
    for (job.output = 0; job.output < request.outputs.size(); ++job.output) {
      job.file = fileOf(job, request);
      jobs.push_back(job);
    }
  }
}

std::vector<FigureJob> allJobs(const PlanRequest &request) {
  std::vector<FigureJob> jobs;
  for (std::size_t subject = 0; subject < request.subjects.size(); ++subject)
    for (std::size_t row = 0; row < (request.rows ? request.rows->rows.size() : 1); ++row)
      for (const auto &step : request.subjects[subject].steps)
        addJobs(request, {subject, request.rows ? std::optional(row) : std::nullopt, step, {}, 0, {}}, jobs);
  return jobs;
}

/// Two figures that one file cannot hold, and what would part them.
Problem sameFile(const FigureJob &one, const FigureJob &other, const PlanRequest &request) {
  if (one.subject != other.subject)
    return refused(words("“{file}” would be written for {one} and for {other}: put {place} into the name.",
                         {{"file", one.file},
                          {"one", request.subjects[one.subject].name},
                          {"other", request.subjects[other.subject].name},
                          {"place", inBraces(lessonPlace)}}));
  if (one.row != other.row)
    return refused(
        words("“{file}” would be written for row {one} and for row {other}: put {place} into the name.",
              {{"file", one.file},
               {"one", std::to_string(*one.row + 1)},
               {"other", std::to_string(*other.row + 1)},
               {"place", inBraces(rowPlace)}}));
  if (one.step != other.step)
    return refused(
        words("“{file}” would be written for step {one} and for step {other}: put {place} into the name.",
              {{"file", one.file},
               {"one", std::to_string(*one.step)},
               {"other", std::to_string(*other.step)},
               {"place", inBraces(stepPlace)}}));
  if (one.frame != other.frame)
    return refused(
        words("Several frames need a place for their number in the file's name: -o frames/%04d.png."));
  return refused(words("“{file}” is asked for twice.", {{"file", one.file}}));
}

std::optional<Problem> refuseSameFiles(const std::vector<FigureJob> &jobs, const PlanRequest &request) {
  std::unordered_map<std::string, const FigureJob *> written;
  for (const FigureJob &job : jobs) {
    const auto [before, isNew] = written.try_emplace(fs::path(job.file).lexically_normal().string(), &job);
    if (!isNew)
      return sameFile(*before->second, job, request);
  }
  return {};
}

/// One path for all that lead to a file; what is not there has one too.
fs::path realPath(const std::string &file) {
  std::error_code error;
  auto real = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? fs::path(file).lexically_normal() : real;
}

std::optional<Problem> refuseInputs(const std::vector<FigureJob> &jobs, const PlanRequest &request) {
  std::set<fs::path> inputs;
  for (const PlannedSubject &subject : request.subjects)
    if (subject.isFile)
      inputs.insert(realPath(subject.name));
  if (request.rows)
    inputs.insert(realPath(request.rows->file));
  if (inputs.empty())
    return {};
  for (const FigureJob &job : jobs)
    if (inputs.contains(realPath(job.file)))
      return refused(
          words("“{file}” is read for this: a figure cannot be written over it.", {{"file", job.file}}));
  return {};
}

} // namespace

Result<std::vector<FigureJob>> planFigures(const PlanRequest &request) {
  if (auto problem = refusePlaces(request))
    return std::move(*problem);
  if (auto problem = refuseTooMany(request))
    return std::move(*problem);
  auto jobs = allJobs(request);
  if (auto problem = refuseSameFiles(jobs, request))
    return std::move(*problem);
  if (auto problem = refuseInputs(jobs, request))
    return std::move(*problem);
  return jobs;
}

std::vector<FigureJob> shardOf(std::vector<FigureJob> jobs, const Shard &shard) {
  if (shard.count <= 1)
    return jobs;
  std::vector<FigureJob> part;
  for (std::size_t i = shard.index - 1; i < jobs.size(); i += shard.count)
    part.push_back(std::move(jobs[i]));
  return part;
}

} // namespace halfspace
