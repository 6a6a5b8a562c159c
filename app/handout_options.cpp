#include "app/handout_options.h"

#include "app/figure_options.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <charconv>

namespace halfspace {
namespace {

/// No lesson has more steps.
constexpr int highestStep = 9999;

std::optional<int> parseStep(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool isStep =
      error == std::errc{} && end == text.data() + text.size() && value >= 1 && value <= highestStep;
  return isStep ? std::optional(value) : std::nullopt;
}

/// 1,3-5
std::optional<std::vector<StepRange>> parseSteps(const std::string &text) {
  std::vector<StepRange> ranges;
  for (const std::string_view part : partsOf(text, ",")) {
    const auto hyphen = part.find('-');
    const auto first = parseStep(part.substr(0, hyphen));
    const auto last = hyphen == std::string_view::npos ? first : parseStep(part.substr(hyphen + 1));
    if (!first || !last || *last < *first)
      return {};
    ranges.push_back({*first, *last});
  }
  return ranges;
}

} // namespace

void addHandoutOptions(CLI::App &command, HandoutOptions &options) {
  command.add_option("-o,--output", options.command.output, words("The PDF file to write"))
      ->type_name("FILE")
      ->required();
  command.add_option("--steps", options.steps, words("The steps to print, as 1,3-5; without it all"))
      ->type_name("NUMBERS");
  command.add_option("--paper", options.paper, words("Its paper"))
      ->type_name("a4|letter")
      ->check(CLI::IsMember({"a4", "letter"}).description(""))
      ->capture_default_str();
  command.add_option("--columns", options.columns, words("How many columns a page has"))
      ->type_name("1|2")
      ->check(CLI::IsMember({"1", "2"}).description(""))
      ->capture_default_str();
  addHiddenOption(command, options.hidden);
  command.add_flag("--answers", options.command.hasAnswers,
                   words("Print the answers to questions and exercises, too"));
  command.add_flag("--anonymous", options.command.isAnonymous,
                   words("Leave the scene out of the file, which can be opened again with it"));
}

Result<HandoutCommand> handoutCommandOf(const HandoutOptions &options) {
  HandoutCommand command = options.command;
  if (!options.steps.empty()) {
    const auto steps = parseSteps(options.steps);
    if (!steps)
      return Problem{words("--steps takes numbers of steps, counted from 1, and from one to another: 1,3-5, "
                           "not “{steps}”.",
                           {{"steps", options.steps}}),
                     "", 0, ""};
    command.steps = *steps;
  }
  const auto hidden = hiddenLinesOf(options.hidden);
  if (!hidden)
    return hidden.problem();
  command.hidden = *hidden;
  command.paper = options.paper == "letter" ? HandoutPaper::Letter : HandoutPaper::A4;
  command.columns = options.columns == "2" ? 2 : 1;
  return command;
}

} // namespace halfspace
