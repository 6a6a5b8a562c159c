#include "app/export/preview_figure.h"

#include "app/figures/paint_drawing.h"
#include "widgets/typeset/label_painter.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr double pointsPerInch = 72;
/// No screen shows more of a preview at a time.
constexpr double mostAcross = 4096;

/// The largest factor by which a page fits into a room.
double fitOf(glm::dvec2 page, const QSize &room) {
  return std::min(room.width() / page.x, room.height() / page.y);
}

/// The factor within what can be drawn: at least a pixel, and not too many.
double bounded(double factor, glm::dvec2 page) {
  return std::clamp(factor, 1 / std::min(page.x, page.y), mostAcross / std::max(page.x, page.y));
}

/// The factor from a file's pixels to a preview's.
double pixelFactor(glm::dvec2 page, const FigureChoices &choices, const PreviewRoom &room) {
  const double wanted = !room.pixelsPerInch ? fitOf(page, room.size)
                        : choices.paper     ? *room.pixelsPerInch / choices.paper->pixelsPerInch
                                            : 1;
  return bounded(std::min(wanted, 1.0), page);
}

/// The same figure on other pixels.
FigureChoices finer(FigureChoices choices, double factor) {
  if (choices.paper) {
    choices.paper->pixelsPerInch *= factor;
    return choices;
  }
  const auto scaled = [factor](int side) {
    return std::max(1, static_cast<int>(std::lround(side * factor)));
  };
  choices.pixelRatio = choices.frame().pixelRatio * factor;
  choices.size = {scaled(choices.size.width), scaled(choices.size.height)};
  return choices;
}

FigureExtent pixelExtent(glm::dvec2 page, const FigureChoices &choices) {
  FigureExtent extent;
  extent.inPixels = PixelSize{static_cast<int>(page.x), static_cast<int>(page.y)};
  if (choices.paper)
    extent.onPaper = page / choices.paper->pixelsPerInch * pointsPerInch;
  return extent;
}

Result<FigurePreview> pixelPreview(FigureMaker &maker, const FigureSubject &subject,
                                   const FigureChoices &choices, const PreviewRoom &room) {
  const glm::dvec2 page = maker.framingOf(subject, choices).page.extent();
  const auto picture = maker.picture(subject, finer(choices, pixelFactor(page, choices, room)));
  if (!picture)
    return picture.problem();
  return FigurePreview{toImage(*picture), pixelExtent(page, choices), picture->leavesOutSurfaces};
}

FigurePreview vectorPreview(FigureStudio &studio, const FigureSubject &subject, const FigureChoices &choices,
                            const PreviewRoom &room) {
  const Drawing drawing = studio.maker.drawing(subject, choices);
  const double factor =
      bounded(room.pixelsPerInch ? *room.pixelsPerInch / pointsPerInch : fitOf(drawing.size, room.size),
              drawing.size);
  QImage image(std::max(1, static_cast<int>(std::lround(drawing.size.x * factor))),
               std::max(1, static_cast<int>(std::lround(drawing.size.y * factor))),
               QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image); // which paints nothing where there is no memory for it
  painter.scale(factor, factor);
  paintDrawing(painter, drawing, studio.typesetter.fonts());
  painter.end();
  return {image, {drawing.size, {}}, drawing.leavesOutSurfaces};
}

} // namespace

Result<FigurePreview> previewOf(FigureStudio &studio, const FigureSubject &subject,
                                const FigureChoices &choices, const PreviewRoom &room) {
  if (choices.format->vectors)
    return vectorPreview(studio, subject, choices, room);
  return pixelPreview(studio.maker, subject, choices, room);
}

} // namespace halfspace
