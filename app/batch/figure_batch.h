// Makes the figures of a plan, one after the other.
#pragma once

#include "app/batch/job_scenes.h"
#include "app/figures/figure_maker.h"
#include "widgets/typeset/typesetter.h"

namespace halfspace {

/// What became of a batch.
struct BatchReport {
  std::size_t made = 0;
  std::size_t unchanged = 0;       ///< they are there as they would be made
  std::vector<Problem> problems{}; ///< that kept others from being made, each told once
  bool isInterrupted = false;
  bool leavesOutSurfaces = false; ///< one of those made does, as `ShapeList` has it

  [[nodiscard]] std::size_t done() const { return made + unchanged; }
};

/// What drawing needs is opened once for all figures.
class FigureBatch {
public:
  /// Both must outlive it.
  FigureBatch(const RenderCommand &command, JobScenes &scenes);

  /// Makes one after the other, and goes on after one that cannot be made; stops before the next where a
  /// signal waits (`HeldSignals`). Each file is whole, or as it was. How far it is is told at a terminal.
  [[nodiscard]] BatchReport run(const std::vector<FigureJob> &jobs);

private:
  /// Counts what comes of it, or says why it cannot be made.
  [[nodiscard]] std::optional<Problem> make(const FigureJob &job, BatchReport &report);
  [[nodiscard]] Result<FigureFile> drawn(const FigureJob &job, SceneFigures &scene);
  /// Whether the file is there as it would be made of this.
  [[nodiscard]] bool isUnchanged(const FigureJob &job, const std::string &madeOf) const;
  [[nodiscard]] std::optional<Problem> write(const FigureJob &job, const std::string &content) const;
  [[nodiscard]] const FigureOutput &outputOf(const FigureJob &job) const {
    return m_command.outputs[job.output];
  }

  const RenderCommand &m_command;
  JobScenes &m_scenes;
  std::string m_drawnBy; ///< what tells the program and the options; empty where nobody asks
  Typesetter m_typesetter;
  FigureMaker m_maker{m_typesetter};
};

} // namespace halfspace
