#include "app/batch/figure_batch.h"

#include "app/batch/figure_mark.h"
#include "app/progress_line.h"
#include "lessons/files/held_signals.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"
#include "lessons/language.h"
#include "lessons/words.h"
#include "widgets/carriers/found_session.h"

#include <filesystem>
#include <utility>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

std::string progressWords(std::size_t number, std::size_t count) {
  return words("Figure {number} of {count}",
               {{"number", std::to_string(number)}, {"count", std::to_string(count)}});
}

/// All besides a scene that a figure depends on; empty where it cannot be told.
std::string drawnBy(const RenderCommand &command) {
  const std::string program = programFingerprint();
  if (program.empty())
    return {};
  // Figures speak: their descriptions tell which language, and this sentence does.
  return program + '\0' + command.options + '\0' + language().decimalMark + progressWords(0, 0);
}

/// Makes the folders that a name gets from its places, where the one that they are in is there.
void makeFolders(const std::string &file, const OutputName &name) {
  const fs::path folder = fs::path(file).parent_path();
  const fs::path fixed = name.fixedFolder();
  std::error_code error; // the writing that follows tells it
  if (folder != fixed && (fixed.empty() || fs::is_directory(fixed, error)))
    fs::create_directories(folder, error);
}

} // namespace

FigureBatch::FigureBatch(const RenderCommand &command, JobScenes &scenes)
    : m_command(command), m_scenes(scenes), m_drawnBy(command.onlyChanged ? drawnBy(command) : "") {}

BatchReport FigureBatch::run(const std::vector<FigureJob> &jobs) {
  BatchReport report;
  ProgressLine progress;
  for (std::size_t i = 0; i < jobs.size() && !report.isInterrupted; ++i) {
    progress.say(progressWords(i + 1, jobs.size()));
    const auto problem = make(jobs[i], report);
    if (problem && (report.problems.empty() || report.problems.back().text() != problem->text()))
      report.problems.push_back(*problem);
    report.isInterrupted = HeldSignals::isOneWaiting() && i + 1 < jobs.size();
  }
  return report;
}

std::optional<Problem> FigureBatch::make(const FigureJob &job, BatchReport &report) {
  const auto scene = m_scenes.sceneOf(job);
  if (!scene)
    return scene.problem();
  const std::string madeOf = m_drawnBy.empty() ? "" : m_drawnBy + (*scene)->madeOf(job.step, job.frame);
  if (isUnchanged(job, madeOf)) {
    ++report.unchanged;
    return {};
  }
  auto figure = drawn(job, **scene);
  if (!figure)
    return Problem{figure.problem().sentence, job.file, 0, figure.problem().field};
  if (!madeOf.empty())
    figure->content = marked(std::move(figure->content), outputOf(job).choices.format->ending, madeOf);
  if (auto problem = write(job, figure->content))
    return problem;
  ++report.made;
  report.leavesOutSurfaces = report.leavesOutSurfaces || figure->leavesOutSurfaces;
  return {};
}

Result<FigureFile> FigureBatch::drawn(const FigureJob &job, SceneFigures &scene) {
  const FigureChoices &choices = outputOf(job).choices;
  const auto subject = scene.subjectOf(job.step, job.frame, choices);
  return subject ? m_maker.file(*subject, choices) : subject.problem();
}

bool FigureBatch::isUnchanged(const FigureJob &job, const std::string &madeOf) const {
  if (madeOf.empty())
    return false;
  const auto file = readFile(job.file, mostPictureBytes);
  return file && isMarked(*file, outputOf(job).choices.format->ending, madeOf);
}

std::optional<Problem> FigureBatch::write(const FigureJob &job, const std::string &content) const {
  makeFolders(job.file, outputOf(job).name);
  return writeFile(job.file, content);
}

} // namespace halfspace
