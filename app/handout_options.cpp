#include "app/handout_options.h"

#include "app/figure_options.h"
#include "app/option_text.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace halfspace {
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
  if (const FigureFormat *format = figureFormatOf(command.output); !format || format->ending != ".pdf")
    return refused(words("A handout is a PDF: let the name end in .pdf, not as “{file}” does.",
                         {{"file", shortened(command.output)}}));
  if (!options.steps.empty()) {
    auto steps = parseSteps(options.steps);
    if (!steps)
      return refused(words("--steps takes numbers of steps, counted from 1, and from one to another: 1,3-5, "
                           "not “{steps}”.",
                           {{"steps", shortened(options.steps)}}));
    command.steps = std::move(*steps);
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
