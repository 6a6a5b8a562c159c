#include "app/export/preview_figure.h"

#include "app/figures/paint_drawing.h"
#include "widgets/colors.h"
#include "widgets/exports/lengths.h"
#include "widgets/exports/qr_beside.h"
#include "widgets/typeset/label_painter.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

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

/// A pixel for each module, those of the quiet zone too.
QImage toImage(const QrCode &code) {
  const int side = code.side + 2 * quietModules;
  QImage image(side, side, QImage::Format_RGB32);
  image.fill(Qt::white);
  for (int row = 0; row < code.side; ++row)
    for (int column = 0; column < code.side; ++column)
      if (code.isDark(column, row))
        image.setPixelColor(column + quietModules, row + quietModules, Qt::black);
  return image;
}

QImage emptyImage(glm::dvec2 size, const QColor &ground) {
  QImage image(std::max(1, static_cast<int>(std::lround(size.x))),
               std::max(1, static_cast<int>(std::lround(size.y))), QImage::Format_ARGB32_Premultiplied);
  image.fill(ground);
  return image;
}

/// A page with a figure of pixels, and maybe with the code beside it.
class PixelPage {
public:
  /// `module`: the side of a module of the code.
  PixelPage(glm::dvec2 figure, const std::optional<QrCode> &code, double module)
      : m_figure(figure), m_code(code), m_side(code ? module * (code->side + 2 * quietModules) : 0) {}

  [[nodiscard]] glm::dvec2 size() const { return {m_figure.x + m_side, std::max(m_figure.y, m_side)}; }
  [[nodiscard]] glm::dvec2 perFigure() const { return size() / m_figure; }
  /// All of it, so many times as large, with the figure as it was drawn.
  [[nodiscard]] QImage painted(const QImage &figure, double factor, const QColor &ground) const {
    if (!m_code)
      return figure;
    QImage page = emptyImage(size() * factor, ground);
    QPainter painter(&page); // which paints nothing where there is no memory for it
    painter.drawImage(0, 0, figure);
    const glm::dvec2 corner = glm::dvec2(m_figure.x, size().y - m_side) * factor;
    painter.drawImage(QRectF(corner.x, corner.y, m_side * factor, m_side * factor), toImage(*m_code));
    return page;
  }

private:
  glm::dvec2 m_figure;
  const std::optional<QrCode> &m_code;
  double m_side; ///< of the code with its quiet zone
};

/// The shapes of a figure on a page that is so many times as wide and high.
std::optional<PreviewShapes> shapesOf(FigureMaker &maker, const FigureSubject &subject,
                                      const FigureChoices &choices, glm::dvec2 pagePerFigure) {
  if (subject.flat)
    return {};
  const auto [view, figure] = maker.framingOf(subject, choices);
  return PreviewShapes{maker.shapesOf(subject, choices, view),
                       {figure.low, figure.low + figure.extent() * pagePerFigure}};
}

Result<FigurePreview> pixelPreview(FigureMaker &maker, const FigureSubject &subject,
                                   const FigureChoices &choices, const std::optional<QrCode> &code,
                                   const PreviewRoom &room) {
  const PixelPage page(maker.framingOf(subject, choices).page.extent(), code,
                       modulePixels(choices.pixelsPerInch()));
  const double factor = pixelFactor(page.size(), choices, room);
  const FigureChoices previewed = finer(choices, factor);
  const auto picture = maker.picture(subject, previewed);
  if (!picture)
    return picture.problem();
  const QColor ground =
      choices.isTransparent ? QColor(Qt::transparent) : toQColor(choices.theme.backgroundBottom);
  return FigurePreview{page.painted(toImage(*picture), factor, ground), pixelExtent(page.size(), choices),
                       picture->leavesOutSurfaces, shapesOf(maker, subject, previewed, page.perFigure())};
}

FigurePreview vectorPreview(FigureStudio &studio, const FigureSubject &subject, const FigureChoices &choices,
                            const std::optional<QrCode> &code, const PreviewRoom &room) {
  Drawing page = studio.maker.drawing(subject, choices);
  const glm::dvec2 figure = page.size;
  if (code)
    page = withQrCode(std::move(page), *code);
  const double factor = bounded(
      room.pixelsPerInch ? *room.pixelsPerInch / pointsPerInch : fitOf(page.size, room.size), page.size);
  QImage image = emptyImage(page.size * factor, Qt::transparent);
  QPainter painter(&image);
  painter.scale(factor, factor);
  paintDrawing(painter, page, studio.typesetter.fonts());
  painter.end();
  return {std::move(image),
          {page.size, {}},
          page.leavesOutSurfaces,
          shapesOf(studio.maker, subject, choices, page.size / figure)};
}

} // namespace

Result<FigurePreview> previewOf(FigureStudio &studio, const FigureSubject &subject,
                                const FigureChoices &choices, const PreviewRoom &room) {
  const auto code = codeBeside(subject, choices);
  if (!code)
    return code.problem();
  if (choices.format->vectors)
    return vectorPreview(studio, subject, choices, *code, room);
  return pixelPreview(studio.maker, subject, choices, *code, room);
}

} // namespace halfspace
