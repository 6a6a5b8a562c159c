// A figure as its file will show it, on the pixels of a screen.
#pragma once

#include "app/export/figure_workshop.h"

#include <QImage>

#include <optional>

namespace halfspace {

/// How large a figure is; at least one of both is told.
struct FigureExtent {
  std::optional<glm::dvec2> onPaper{}; ///< in points
  std::optional<PixelSize> inPixels{}; ///< of one that is made of them
};

/// What a preview is drawn from.
struct PreviewShapes {
  ShapeList list;
  PixelBox page; ///< the part of their view that it shows
};

struct FigurePreview {
  QImage image; ///< null where there is no memory for it
  FigureExtent extent;
  bool leavesOutSurfaces = false;        ///< as `ShapeList` has it
  std::optional<PreviewShapes> shapes{}; ///< nothing of a flat picture
};

/// What a preview is drawn on, in pixels of the screen.
struct PreviewRoom {
  QSize size;                            ///< that it is fitted into
  std::optional<double> pixelsPerInch{}; ///< not fitted: as large as it will be on paper; in pixels, as it is
};

/// The picture of pixels is drawn anew at the preview's resolution, and never finer than its file; vectors
/// are painted. Fails with a sentence as `FigureMaker` does.
[[nodiscard]] Result<FigurePreview> previewOf(FigureStudio &studio, const FigureSubject &subject,
                                              const FigureChoices &choices, const PreviewRoom &room);

} // namespace halfspace
