// What the command line says of figures.
#pragma once

#include "app/figures/figure_choices.h"
#include "lessons/result.h"

namespace CLI {
class App;
}

namespace halfspace {

/// As they are typed.
struct FigureOptions {
  std::string output;
  std::string size = "1600x1000";
  std::string width = "12cm";
  std::string typeSize = "9pt";
  std::string pixelsPerInch = "300";
  std::string theme = themes().front().name;
  std::string hidden = "dashed";
  std::string text = "shapes";
  bool isCropped = false;
  bool isTransparent = false;
  bool hasCode = false;
};

/// Lets a command take them.
void addFigureOptions(CLI::App &command, FigureOptions &options);

/// What they ask for; `command` says which of them were given. Or a sentence that refuses them.
[[nodiscard]] Result<FigureChoices> choicesOf(const FigureOptions &options, const CLI::App &command);

} // namespace halfspace
