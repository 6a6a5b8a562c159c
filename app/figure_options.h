// What the command line says of figures.
#pragma once

#include "app/figures/figure_choices.h"
#include "app/shown_options.h"
#include "lessons/result.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace halfspace {

/// As they are typed.
struct FigureOptions {
  std::vector<std::string> outputs; ///< a file of each format that is wanted
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
  ShownOptions shown;
};

/// Lets a command take them.
void addFigureOptions(CLI::App &command, FigureOptions &options);

/// Lets a command take the word for how hidden lines are drawn.
void addHiddenOption(CLI::App &command, std::string &hidden);
/// What it stands for; or a sentence that refuses it.
[[nodiscard]] Result<HiddenLines> hiddenLinesOf(const std::string &word);

/// What they ask for of one of the outputs; `command` says which of them were given. Or a sentence that
/// refuses them: those that none of the outputs has a use for as well.
[[nodiscard]] Result<FigureChoices> choicesOf(const std::string &output, const FigureOptions &options,
                                              const CLI::App &command);

// What other pictures are asked for in the same way.

/// Of a picture, as 1600x1000; or a sentence that refuses it.
[[nodiscard]] Result<PixelSize> sizeOf(const std::string &text);
[[nodiscard]] Result<Theme> themeOf(const std::string &name);
[[nodiscard]] std::string themeNames(const std::string &separator);

} // namespace halfspace
