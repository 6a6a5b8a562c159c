#include "app/figure_options.h"

#include "app/figures/figure_words.h"
#include "app/option_text.h"
#include "lessons/words.h"
#include "widgets/scene/offscreen.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

/// 1600x1000
std::optional<PixelSize> parseSize(const std::string &text) {
  const auto x = text.find_first_of("xX");
  if (x == std::string::npos)
    return {};
  const auto width = parseCount(std::string_view(text).substr(0, x), maxPictureSide);
  const auto height = parseCount(std::string_view(text).substr(x + 1), maxPictureSide);
  if (!width || !height)
    return {};
  return PixelSize{static_cast<int>(*width), static_cast<int>(*height)};
}

/// A positive length in points: 8cm, 80mm or 226pt.
std::optional<double> parseLength(std::string_view text) {
  const auto value = takePositive(text);
  for (const auto &[name, points] :
       {std::pair("cm", pointsPerCentimetre), {"mm", pointsPerMillimetre}, {"pt", 1.0}})
    if (value && text == name)
      return *value * points;
  return {};
}

/// PNG, SVG, PDF …, or .png, .svg, .pdf …: what figures can be written as.
std::string formats(std::string FigureFormat::*part) { return joinedNames(figureFormats(), part, ", "); }

Result<PaperSize> paperSizeOf(const FigureOptions &options) {
  const auto width = parseLength(options.width);
  if (!width || *width < leastWidth || *width > mostWidth)
    return refused(words("--width takes a length from 1cm to 100cm, as 8cm, 80mm or 227pt, not “{width}”.",
                         {{"width", options.width}}));
  const auto typeSize = parseLength(options.typeSize);
  if (!typeSize || *typeSize < leastType || *typeSize > mostType)
    return refused(
        words("--text takes a size of type from 3pt to 72pt, not “{size}”.", {{"size", options.typeSize}}));
  if (*typeSize > *width * mostTypePerWidth)
    return refused(words("Type of {size} is too large for a figure {width} wide: at most a tenth of that.",
                         {{"size", options.typeSize}, {"width", options.width}}));
  const auto pixels = parsePositive(options.pixelsPerInch);
  if (!pixels || *pixels < leastPixelsPerInch || *pixels > mostPixelsPerInch)
    return refused(words("--dpi takes the pixels of an inch, from 10 to 2400, not “{number}”.",
                         {{"number", options.pixelsPerInch}}));
  return PaperSize{*width, *typeSize, *pixels};
}

/// A sentence where an option is given that none of the formats has a use for.
std::optional<Problem> uselessOption(const FigureFormat &format, const FigureOptions &options,
                                     const CLI::App &command) {
  const auto isGiven = [&](const char *option) { return command.count(option) > 0; };
  const auto isAny = [&](const auto &isOne) {
    return std::any_of(options.outputs.begin(), options.outputs.end(), [&](const std::string &output) {
      const FigureFormat *each = figureFormatOf(output);
      return each && isOne(*each);
    });
  };
  const auto isOfVectors = [](const FigureFormat &each) { return each.vectors != nullptr; };
  const auto isOfPixels = [](const FigureFormat &each) { return !each.vectors; };
  const auto choosesText = [](const FigureFormat &each) { return each.vectors && each.vectors->choosesText; };
  if (isGiven("--hidden") && !isAny(isOfVectors))
    return refused(words("--hidden is for figures of vectors: in a PNG picture what is hidden is paler."));
  if (isGiven("--dpi") && !isAny(isOfPixels))
    return refused(words("--dpi is for PNG pictures: a figure of vectors has no pixels."));
  if (isGiven("--svg-text") && !isAny(choosesText))
    return refused(
        words("--svg-text is for SVG: {format} has its own way with text.", {{"format", format.name}}));
  return {};
}

} // namespace

Result<PixelSize> sizeOf(const std::string &text) {
  if (const auto size = parseSize(text))
    return *size;
  return refused(words("--size takes WIDTHxHEIGHT with sides from 1 to {largest}, not “{size}”.",
                       {{"largest", std::to_string(maxPictureSide)}, {"size", text}}));
}

std::string themeNames(const std::string &separator) {
  return joinedNames(themes(), &Theme::name, separator);
}

Result<Theme> themeOf(const std::string &name) {
  if (const Theme *theme = findTheme(name))
    return *theme;
  return refused(words("There is no theme “{theme}”. The themes are {themes}.",
                       {{"theme", name}, {"themes", themeNames(", ")}}));
}

void addFigureOptions(CLI::App &command, FigureOptions &options) {
  command
      .add_option("-o,--output", options.outputs,
                  words("The file to write; its ending says how: {endings} (can be repeated)",
                        {{"endings", formats(&FigureFormat::ending)}}))
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all()
      ->required();
  command
      .add_option("--size", options.size,
                  words("Its sides in pixels; of a figure that is measured on paper, its shape"))
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command
      .add_option("--width", options.width,
                  words("How wide it is on paper, in cm, mm or pt; vectors are always measured so"))
      ->type_name("LENGTH")
      ->capture_default_str();
  command.add_option("--text", options.typeSize, words("The size of its type on paper"))
      ->type_name("LENGTH")
      ->capture_default_str();
  command
      .add_option("--dpi", options.pixelsPerInch,
                  words("How many pixels an inch of a PNG picture has that is measured on paper"))
      ->type_name("NUMBER")
      ->capture_default_str();
  command.add_flag("--crop", options.isCropped,
                   words("Only what is drawn, as large as the width allows, in place of the whole view"));
  command.add_flag("--transparent", options.isTransparent, words("No background"));
  command.add_option("--theme", options.theme, words("The picture's colours"))
      ->type_name(themeNames("|"))
      ->capture_default_str();
  addHiddenOption(command, options.hidden);
  command
      .add_option("--svg-text", options.text,
                  words("How SVG has its text: as shapes, which look the same everywhere, or as letters"))
      ->type_name("shapes|letters")
      ->capture_default_str();
  addShownOptions(command, options.shown);
  command.add_flag(
      "--qr", options.hasCode,
      words("A QR code beside it holds its scene: a photograph of the printed figure can be opened again"));
}

void addHiddenOption(CLI::App &command, std::string &hidden) {
  command
      .add_option("--hidden", hidden, words("How lines of vectors are drawn where a face stands before them"))
      ->type_name("dashed|paler|left-out")
      ->capture_default_str();
}

Result<HiddenLines> hiddenLinesOf(const std::string &word) {
  const auto hidden = meant(hiddenWords, word);
  if (!hidden)
    return refused(words("--hidden takes dashed, paler or left-out, not “{hidden}”.", {{"hidden", word}}));
  return *hidden;
}

Result<FigureChoices> choicesOf(const std::string &output, const FigureOptions &options,
                                const CLI::App &command) {
  FigureChoices choices;
  const auto size = sizeOf(options.size);
  if (!size)
    return size.problem();
  choices.size = *size;
  choices.format = figureFormatOf(output);
  if (!choices.format)
    return refused(
        words("Figures are written as {formats}: let the name end in {endings}, not as “{file}” does.",
              {{"formats", formats(&FigureFormat::name)},
               {"endings", formats(&FigureFormat::ending)},
               {"file", output}}));
  if (auto problem = uselessOption(*choices.format, options, command))
    return std::move(*problem);
  const auto paper = paperSizeOf(options);
  if (!paper)
    return paper.problem();
  const bool isMeasuredOnPaper =
      command.count("--width") + command.count("--text") + command.count("--dpi") > 0;
  if (isMeasuredOnPaper || choices.format->vectors)
    choices.paper = *paper;
  const auto theme = themeOf(options.theme);
  if (!theme)
    return theme.problem();
  choices.theme = *theme;
  const auto hidden = hiddenLinesOf(options.hidden);
  if (!hidden)
    return hidden.problem();
  choices.hidden = *hidden;
  const auto text = meant(textWords, options.text);
  if (!text)
    return refused(words("--svg-text takes shapes or letters, not “{text}”.", {{"text", options.text}}));
  choices.text = *text;
  const auto shown = shownPartsOf(options.shown);
  if (!shown)
    return shown.problem();
  choices.shown = *shown;
  choices.isCropped = options.isCropped;
  choices.isTransparent = options.isTransparent;
  choices.hasCode = options.hasCode;
  return choices;
}

} // namespace halfspace
