#include "app/figures/figure_choices.h"

#include "widgets/picture/design_scale.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace halfspace {
namespace {

std::vector<FigureFormat> allFormats() {
  std::vector<FigureFormat> formats{{"PNG", ".png"}};
  for (const ExportFormat &format : exportFormats())
    formats.push_back({format.name, format.ending, &format});
  return formats;
}

} // namespace

const std::vector<FigureFormat> &figureFormats() {
  static const std::vector<FigureFormat> formats = allFormats();
  return formats;
}

const FigureFormat *figureFormatWith(const std::string &ending) {
  const auto found = std::find_if(figureFormats().begin(), figureFormats().end(),
                                  [&](const FigureFormat &format) { return format.ending == ending; });
  return found == figureFormats().end() ? nullptr : &*found;
}

const FigureFormat *figureFormatOf(const std::string &file) {
  const std::string ending = endingOf(file);
  if (!ending.empty())
    return figureFormatWith(ending);
  std::error_code error;
  const auto there = std::filesystem::status(file, error);
  const bool isPipeOrDevice = std::filesystem::exists(there) && !std::filesystem::is_regular_file(there);
  return isPipeOrDevice ? &figureFormats().front() : nullptr;
}

int PaperSize::pixelsAcross() const {
  return std::max(1, static_cast<int>(std::lround(width / pointsPerInch * pixelsPerInch)));
}

double FigureChoices::pixelsPerInch() const {
  return paper ? paper->pixelsPerInch : size.width / PaperSize().width * pointsPerInch;
}

View FigureChoices::frame() const {
  if (!isOnPaper())
    return {{}, size, pixelRatio.value_or(ownPixelRatio(size))};
  const PaperSize measured = paperSize();
  return viewOnPaper(size, measured.width, measured.typeSize, theme,
                     format->vectors ? drawingPixels : measured.pixelsAcross());
}

} // namespace halfspace
