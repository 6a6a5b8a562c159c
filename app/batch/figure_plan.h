// Which figures a command makes, of what, and into which files: known before any of them is drawn.
#pragma once

#include "app/batch/output_name.h"
#include "lessons/reading/value_rows.h"

#include <optional>
#include <utility>

namespace halfspace {

/// One figure that is to be made.
struct FigureJob {
  std::size_t subject = 0;          ///< its place among the plan's
  std::optional<std::size_t> row{}; ///< of the values, counted from 0; nothing: there are none
  std::optional<int> step{};        ///< counted from 1; nothing: what is shown where no step is asked for
  std::optional<int> frame{};       ///< of the lesson's flight
  std::size_t output = 0;           ///< which of the names, with its format, it is made for
  std::string file;
};

/// A lesson or a file that figures are made of.
struct PlannedSubject {
  std::string name;    ///< as it is asked for
  std::string label;   ///< for {lesson}: the lesson's id, or the file without its folder and ending
  bool isFile = false; ///< which must stay as it is
  std::vector<std::optional<int>> steps{std::nullopt}; ///< to show, as in FigureJob; at least one
};

struct PlanRequest {
  std::vector<PlannedSubject> subjects;
  const ValueRows *rows = nullptr;             ///< null: the scenes are drawn as they are
  std::optional<std::pair<int, int>> frames{}; ///< the first and the last
  std::vector<OutputName> outputs;
};

/// The figures, subject by subject, row by row, step by step. A sentence where a name has a place that
/// nothing fills, where two figures would be written to one file or one over a file that is read, and for
/// more than `mostFigures`.
[[nodiscard]] Result<std::vector<FigureJob>> planFigures(const PlanRequest &request);
inline constexpr std::size_t mostFigures = 200'000;

/// A part of the figures, for one of several programs that share them.
struct Shard {
  std::size_t index = 1; ///< counted from 1
  std::size_t count = 1; ///< at least as many
};

/// Every count-th figure: together the shards have each once.
[[nodiscard]] std::vector<FigureJob> shardOf(std::vector<FigureJob> jobs, const Shard &shard);

} // namespace halfspace
