// What somebody wants of a figure's file, in the words of the window and of the command line alike.
#pragma once

#include "widgets/exports/format.h"
#include "widgets/exports/paper_look.h"
#include "widgets/picture/shown_parts.h"
#include "widgets/picture/theme.h"
#include "widgets/picture/view.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// A format that figures are written in.
struct FigureFormat {
  std::string name;                      ///< for people
  std::string ending;                    ///< of files, with its dot, in small letters
  const ExportFormat *vectors = nullptr; ///< null: it is one of pixels
};

/// The first is PNG.
[[nodiscard]] const std::vector<FigureFormat> &figureFormats();

/// That of files with an ending, as `FigureFormat` has it; null for none of them.
[[nodiscard]] const FigureFormat *figureFormatWith(const std::string &ending);

/// That of a file, by how its name ends, and PNG for a pipe or a device without an ending; null for none of
/// them.
[[nodiscard]] const FigureFormat *figureFormatOf(const std::string &file);

/// How a figure is measured that is to be printed.
struct PaperSize {
  double width = 12 * pointsPerCentimetre; ///< in points
  double typeSize = 9;                     ///< of the labels of marks, in points
  double pixelsPerInch = 300;              ///< of one that is made of pixels
  bool operator==(const PaperSize &) const = default;

  /// Of a picture of pixels.
  [[nodiscard]] int pixelsAcross() const;
};

struct FigureChoices {
  const FigureFormat *format = &figureFormats().front(); ///< never null
  /// The sides in pixels; of a figure on paper, their proportion.
  PixelSize size{1600, 1000};
  /// Nothing: it is measured in pixels, and its type is as large as its height says. Vectors are always
  /// measured on paper.
  std::optional<PaperSize> paper{};
  /// Of a figure that is measured in pixels, those that a design pixel has; nothing: as its height says.
  std::optional<double> pixelRatio{};
  bool isCropped = false; ///< to what is drawn; the size then says how wide it is
  Theme theme = themes().front();
  bool isTransparent = false; ///< without a background
  ShownParts shown{};
  HiddenLines hidden = HiddenLines::Dashed;
  TextAs text = TextAs::Shapes; ///< where the format leaves the choice
  bool hasCode = false;         ///< a QR code of the session, where there is one, stands beside it

  [[nodiscard]] bool isOnPaper() const { return paper || format->vectors; }
  [[nodiscard]] PaperSize paperSize() const { return paper.value_or(PaperSize()); }
  /// Of a figure of pixels; of one that is not measured on paper, as if it were printed as wide as usual.
  [[nodiscard]] double pixelsPerInch() const;
  /// The view that the figure is composed on, still without its camera.
  [[nodiscard]] View frame() const;
};

} // namespace halfspace
