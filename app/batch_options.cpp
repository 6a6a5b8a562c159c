#include "app/batch_options.h"

#include "app/option_text.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace halfspace {
namespace {

/// Higher numbers are typing errors.
constexpr std::size_t mostShards = 1'000'000;

/// Options that say which figures are made and where to, not what they look like.
constexpr std::array choosingOptions{"help",   "output", "step",  "steps", "frame",
                                     "frames", "rows",   "shard", "all",   "changed"};

/// 2/8
Result<Shard> parseShard(const std::string &text) {
  const auto slash = text.find('/');
  const auto index = parseCount(std::string_view(text).substr(0, slash), mostShards);
  const auto count = slash == std::string::npos
                         ? std::nullopt
                         : parseCount(std::string_view(text).substr(slash + 1), mostShards);
  if (!index || !count || *index > *count)
    return refused(
        words("--shard takes the number of a part and how many parts there are, from 1/4 to 4/4; not "
              "“{shard}”.",
              {{"shard", shortened(text)}}));
  return Shard{*index, *count};
}

bool choosesFigures(const CLI::Option &option) {
  return option.get_positional() || std::any_of(choosingOptions.begin(), choosingOptions.end(),
                                                [&](const char *name) { return option.check_lname(name); });
}

/// All options on which looks depend, with their values; a new one is among them by itself.
std::string optionsOfLooks(const CLI::App &app) {
  std::string all;
  for (const CLI::Option *option : app.get_options()) {
    if (choosesFigures(*option))
      continue;
    all += option->get_name() + "=";
    for (const std::string &value : option->results())
      all += value + '\0';
    all += option->count() == 0 ? option->get_default_str() + '\n' : "\n";
  }
  return all;
}

std::optional<Problem> refuseSubjects(const RenderCommand &command) {
  if (command.allLessons && !command.subjects.empty())
    return refused(words("--all is for all lessons: “{subject}” cannot stand beside it.",
                         {{"subject", shortened(command.subjects.front())}}));
  if (!command.allLessons && command.subjects.empty())
    return refused(words("Say what to draw: a lesson, a file, or --all for all lessons."));
  return {};
}

} // namespace

CLI::Option *addBatchOptions(CLI::App &command, BatchOptions &options) {
  command.add_flag("--all", options.allLessons, words("All lessons, in the place of some"));
  auto *steps =
      command
          .add_option("--steps", options.steps,
                      words("A figure of each step, or of some: 2,4-6. The name has a place for its number: "
                            "-o {example}",
                            {{"example", "{lesson}-{step}.png"}}))
          ->type_name("A,B-C")
          ->expected(0, 1);
  command
      .add_option(
          "--rows", options.rowsFile,
          words("A figure with the values of each row of a table: CSV, whose first row names coordinates "
                "as --set does, or JSON Lines: -o {example}",
                {{"example", "{row}.png"}}))
      ->type_name("FILE");
  command.add_flag("--changed", options.onlyChanged,
                   words("Make only what has changed: figures carry a mark of what they were made of"));
  command
      .add_option(
          "--shard", options.shard,
          words("Make a part of the figures, where several programs share them: 1/4 is the first of four"))
      ->type_name("I/N");
  return steps;
}

std::optional<Problem> takeBatchOptions(const BatchOptions &options, const CLI::App &app,
                                        RenderCommand &command) {
  command.eachStep = app.count("--steps") > 0 && options.steps.empty();
  if (!options.steps.empty()) {
    auto steps = parseSteps(options.steps);
    if (!steps)
      return refused(
          words("--steps takes numbers of steps, as 2,4-6, or nothing for each of them; not “{steps}”. "
                "Lessons and files stand before it.",
                {{"steps", shortened(options.steps)}}));
    command.steps = std::move(*steps);
  }
  command.allLessons = options.allLessons;
  if (auto problem = refuseSubjects(command)) // after the steps, which may have taken one for their value
    return problem;
  if (app.count("--shard") > 0) {
    const auto shard = parseShard(options.shard);
    if (!shard)
      return shard.problem();
    command.shard = *shard;
  }
  if (app.count("--rows") > 0)
    command.rowsFile = options.rowsFile;
  command.onlyChanged = options.onlyChanged;
  command.options = optionsOfLooks(app);
  return {};
}

} // namespace halfspace
