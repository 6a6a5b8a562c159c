// What somebody chooses in the export window, as it is kept from one time to the next.
#pragma once

#include "app/figures/figure_choices.h"
#include "widgets/picture/shown_parts.h"

#include <QJsonObject>

#include <string>

namespace halfspace {

/// Choices that the chosen format has no use for are kept for those that have.
struct ExportChoices {
  std::string ending = figureFormats().front().ending; ///< of a format of `figureFormats`
  bool isOnPaper = true;                               ///< measured so, where the format leaves the choice
  PaperSize paper{};
  int pixelsAcross = 1600; ///< where it is measured in pixels
  bool isCropped = false;
  std::string theme = themes().front().name; ///< one of `themes`
  bool isTransparent = false;
  HiddenLines hidden = HiddenLines::Dashed;
  TextAs text = TextAs::Shapes;
  ShownParts shown{};
  bool isFlat = false; ///< the flat picture, where the lesson has one
  bool carriesSession = true;
  bool hasCode = false; ///< a QR code with the session beside it
  bool operator==(const ExportChoices &) const = default;

  [[nodiscard]] const FigureFormat &format() const;
  /// Whether the scene may be in the file or beside the figure. Files that carry none give nothing away.
  [[nodiscard]] bool mayTellScene() const;
};

/// For a figure that is framed as on a screen of so many pixels, a design pixel of which has so many of them.
[[nodiscard]] FigureChoices figureChoicesOf(const ExportChoices &choices, PixelSize screen,
                                            double designRatio);

[[nodiscard]] QJsonObject toJson(const ExportChoices &choices);
/// What it does not tell, or tells wrongly, is as usual.
[[nodiscard]] ExportChoices exportChoicesIn(const QJsonObject &json);

} // namespace halfspace
