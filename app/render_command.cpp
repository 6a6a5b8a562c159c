// Figures in files: one, or as many as lessons, steps, rows of values and frames of a flight make.
#include "app/batch/figure_batch.h"
#include "app/batch/planned_subject.h"
#include "app/commands.h"
#include "app/standard_streams.h"
#include "lessons/files/held_signals.h"
#include "lessons/files/read_file.h"
#include "lessons/words.h"
#include "widgets/picture/shapes/surface_layers.h"

#include <utility>

namespace halfspace {
namespace {

/// Some figures could not be made.
constexpr int exitSomeMissing = 1;

struct RenderPlan {
  std::vector<PlannedSubject> subjects;
  std::vector<FigureJob> jobs;     ///< of this shard
  std::vector<Problem> problems{}; ///< with subjects of which nothing can be drawn
  bool isBatch = false;            ///< more was asked for than one figure
};

/// Nothing where the command has no rows.
Result<std::optional<ValueRows>> rowsOf(const RenderCommand &command) {
  if (!command.rowsFile)
    return std::optional<ValueRows>();
  const auto text = readFile(*command.rowsFile, maxRowsBytes);
  if (!text)
    return text.problem();
  auto rows = readValueRows(*text, *command.rowsFile);
  if (!rows)
    return rows.problem();
  return std::optional(std::move(*rows));
}

std::vector<std::string> subjectsOf(const RenderCommand &command, SubjectOpener &opener) {
  if (!command.allLessons)
    return command.subjects;
  std::vector<std::string> ids;
  for (const Lesson &lesson : opener.all().lessons)
    ids.push_back(lesson.id);
  return ids;
}

/// A problem that says which subject it is of.
Problem named(Problem problem, const std::string &subject) {
  if (problem.file.empty())
    problem.file = subject;
  return problem;
}

/// Adds what is planned of a subject. Of one alone all that is asked for must be there. A subject is opened
/// twice: before anything is drawn, and when its turn comes.
std::optional<Problem> addSubject(const std::string &name, bool isAlone, const RenderCommand &command,
                                  const ValueRows *rows, SubjectOpener &opener, RenderPlan &plan) {
  LessonLibrary library;
  auto opened = opener.open(name, library);
  if (opened)
    opened = withValues(std::move(*opened), command.assignments);
  auto subject = opened ? plannedOf(name, *opened, command, rows) : opened.problem();
  if (!subject)
    return subject.problem();
  auto lack = lackOfSteps(*opened, command);
  if (!lack || !isAlone)
    plan.subjects.push_back(std::move(*subject));
  return lack;
}

Result<RenderPlan> planOf(const RenderCommand &command, const ValueRows *rows, SubjectOpener &opener) {
  RenderPlan plan;
  const auto names = subjectsOf(command, opener);
  if (names.empty())
    return Problem{words("There are no lessons to draw."), "", 0, ""};
  const bool isAlone = names.size() == 1;
  for (const std::string &name : names)
    if (const auto problem = addSubject(name, isAlone, command, rows, opener, plan)) {
      if (isAlone)
        return *problem;
      plan.problems.push_back(named(*problem, name));
    }
  PlanRequest request{plan.subjects, rows, command.frames, {}};
  for (const FigureOutput &output : command.outputs)
    request.outputs.push_back(output.name);
  auto jobs = planFigures(request);
  if (!jobs)
    return jobs.problem();
  plan.isBatch = !isAlone || jobs->size() > 1;
  plan.jobs = shardOf(std::move(*jobs), command.shard);
  return plan;
}

/// Lists what could not be made, and returns the program's exit status.
int told(const BatchReport &report, const RenderPlan &plan) {
  if (report.leavesOutSurfaces)
    printError(overfullWords());
  if (!plan.isBatch && !report.problems.empty())
    return fail(report.problems.front());
  for (const auto *problems : {&plan.problems, &report.problems})
    for (const Problem &problem : *problems)
      printError(problem.text());
  const std::initializer_list<std::pair<std::string_view, std::string>> counts{
      {"done", std::to_string(report.done())}, {"count", std::to_string(plan.jobs.size())}};
  if (report.isInterrupted)
    printError(words("Interrupted: {done} of {count} figures are done, and whole.", counts));
  else if (!plan.problems.empty()) // nobody knows how many figures would have come of them
    printError(words("{done} figures are done. What kept the others is told above.", counts));
  else if (!report.problems.empty())
    printError(words("{done} of {count} figures are done. What kept the others is told above.", counts));
  const bool isWhole = report.problems.empty() && plan.problems.empty() && !report.isInterrupted;
  return isWhole ? 0 : exitSomeMissing;
}

} // namespace

int runRender(const RenderCommand &command) {
  const auto rows = rowsOf(command);
  if (!rows)
    return fail(rows.problem());
  const ValueRows *values = *rows ? &**rows : nullptr;
  SubjectOpener opener(command.ownLessons);
  const auto plan = planOf(command, values, opener);
  if (!plan)
    return fail(plan.problem());
  std::optional<HeldSignals> untilAllIsTold; // then one that came ends the program
  if (plan->isBatch)
    untilAllIsTold.emplace();
  JobScenes scenes(command, plan->subjects, values, opener);
  const BatchReport report = FigureBatch(command, scenes).run(plan->jobs);
  const int status = told(report, *plan);
  if (!command.onlyChanged || status != 0)
    return status;
  return printOut(
      words("Figures drawn: {made}. Unchanged: {unchanged}.",
            {{"made", std::to_string(report.made)}, {"unchanged", std::to_string(report.unchanged)}}) +
      "\n");
}

} // namespace halfspace
