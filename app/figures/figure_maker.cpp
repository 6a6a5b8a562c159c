#include "app/figures/figure_maker.h"

#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/png_chunks.h"
#include "widgets/exports/draw_flat.h"
#include "widgets/exports/draw_shapes.h"
#include "widgets/exports/qr_beside.h"
#include "widgets/picture/drawn_box.h"
#include "widgets/picture/labels/label_page.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/flat_painter.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>

namespace halfspace {
namespace {

/// The part of a picture in a box of whole pixels within it.
RgbaImage partOf(const RgbaImage &picture, const PixelBox &box) {
  const auto left = static_cast<std::ptrdiff_t>(box.low.x);
  const auto top = static_cast<std::ptrdiff_t>(box.low.y);
  RgbaImage part{static_cast<int>(box.extent().x), static_cast<int>(box.extent().y), {}};
  part.rgba.reserve(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height) * 4);
  for (std::ptrdiff_t row = top; row < top + part.height; ++row) {
    const auto begin = picture.rgba.begin() + (row * picture.width + left) * 4;
    part.rgba.insert(part.rgba.end(), begin, begin + std::ptrdiff_t(part.width) * 4);
  }
  return part;
}

RgbaImage withCode(const RgbaImage &picture, const QrCode &code, const FigureChoices &choices) {
  const auto ground = choices.isTransparent ? std::nullopt : std::optional(choices.theme.backgroundBottom);
  return withQrCode(picture, code, choices.pixelsPerInch(), ground);
}

/// A content with what is chosen of it.
SceneContent chosen(SceneContent content, const FigureChoices &choices) {
  content.shown = choices.shown;
  return content;
}

/// What is made; or a sentence where there is not enough memory for it.
template <class Make> auto madeInMemory(const Make &make) -> decltype(make()) {
  try {
    return make();
  } catch (const std::bad_alloc &) {
    return Problem{words("There is not enough memory for this picture."), "", 0, ""};
  }
}

DrawnPicture flatPicture(const FlatPicture &flat, const View &view, const FigureChoices &choices,
                         const Typesetter &typesetter) {
  return DrawnPicture{
      drawFlat(chosen(flat.seenFrom(view), choices), choices.theme, view, choices.isTransparent, typesetter)};
}

std::optional<PixelBox> flatBox(const FlatPicture &flat, const View &view, const FigureChoices &choices,
                                const LabelSetter &set) {
  const Theme &theme = choices.theme;
  const SceneContent content = chosen(flat.seenFrom(view), choices);
  const auto labels = LabelPage().place(writtenLabels(content, {}, theme, view),
                                        obstaclesOf(content, std::nullopt, theme, view), set, view);
  return drawnBox(flatShapes(content, theme, view),
                  shapesOf(labels, theme.mutedInk, leaderWidth * view.pixelRatio), view.size);
}

} // namespace

Result<std::optional<QrCode>> codeBeside(const FigureSubject &subject, const FigureChoices &choices) {
  if (!choices.hasCode || subject.session.empty())
    return std::optional<QrCode>();
  auto code = qrCodeOf(subject.session);
  return code ? Result(std::optional(std::move(*code))) : code.problem();
}

FigureMaker::FigureMaker(const Typesetter &typesetter)
    : m_typesetter(typesetter), m_set(labelSetter(typesetter.fonts())), m_composer(m_set),
      m_painter(labelSetter(typesetter.fonts()), labelPainter(typesetter)) {}

Result<FigureFile> FigureMaker::file(const FigureSubject &subject, const FigureChoices &choices) {
  return madeInMemory([&] { return madeFile(subject, choices); });
}

Result<DrawnPicture> FigureMaker::picture(const FigureSubject &subject, const FigureChoices &choices) {
  return madeInMemory([&] { return madePicture(subject, choices); });
}

Result<FigureFile> FigureMaker::madeFile(const FigureSubject &subject, const FigureChoices &choices) {
  const auto code = codeBeside(subject, choices);
  if (!code)
    return code.problem();
  FigureFile file;
  if (const ExportFormat *vectors = choices.format->vectors) {
    Drawing drawn = drawing(subject, choices);
    file.leavesOutSurfaces = drawn.leavesOutSurfaces;
    drawn.title = subject.title;
    drawn.description = subject.description;
    if (*code)
      drawn = withQrCode(std::move(drawn), **code);
    file.content = vectors->write(drawn, m_typesetter.fonts(), choices.text);
  } else {
    auto drawn = madePicture(subject, choices);
    if (!drawn)
      return drawn.problem();
    RgbaImage &image = *drawn;
    if (*code)
      image = withCode(image, **code, choices);
    auto png = pngOf(image);
    if (!png)
      return png.problem();
    file.leavesOutSurfaces = drawn->leavesOutSurfaces;
    file.content =
        choices.paper ? withPixelDensity(std::move(*png), choices.paper->pixelsPerInch) : std::move(*png);
  }
  if (!subject.session.empty())
    file.content = withSession(std::move(file.content), subject.session);
  return file;
}

Result<DrawnPicture> FigureMaker::madePicture(const FigureSubject &subject, const FigureChoices &choices) {
  const auto [view, page] = framingOf(subject, choices);
  auto whole = [&, &view = view]() -> Result<DrawnPicture> {
    if (subject.flat)
      return flatPicture(*subject.flat, view, choices, m_typesetter);
    PictureRequest request;
    request.content = chosen(subject.content, choices);
    if (subject.framedLike)
      request.labelledLike = chosen(*subject.framedLike, choices);
    request.camera = view.camera;
    request.theme = choices.theme;
    request.size = view.size;
    request.transparent = choices.isTransparent;
    request.pixelRatio = view.pixelRatio;
    return m_painter.draw(request);
  }();
  if (!whole || page == view.box())
    return whole;
  return DrawnPicture{partOf(*whole, page), whole->leavesOutSurfaces};
}

Drawing FigureMaker::drawing(const FigureSubject &subject, const FigureChoices &choices) {
  const auto [view, page] = framingOf(subject, choices);
  const double pointsPerPixel = choices.paperSize().width / page.extent().x;
  const PaperLook look{view.size.width * pointsPerPixel, choices.hidden, !choices.isTransparent};
  Drawing whole = subject.flat ? flatDrawingOf(chosen(subject.flat->seenFrom(view), choices), choices.theme,
                                               view, look, m_set)
                               : drawingOf(shapesOf(subject, choices, view), look);
  return partOf(std::move(whole), page.low * pointsPerPixel, page.extent() * pointsPerPixel);
}

Framing FigureMaker::framingOf(const FigureSubject &subject, const FigureChoices &choices) {
  View view = choices.frame();
  if (subject.flat)
    view = subject.flat->fitted(std::move(view));
  else
    view.camera = subject.camera;
  if (!choices.isCropped)
    return wholeOf(view);
  const int longestSide = choices.format->vectors ? std::numeric_limits<int>::max() : maxPictureSide;
  return croppedTo(view, longestSide, [&](const View &seen) { return drawnOn(seen, subject, choices); });
}

std::optional<PixelBox> FigureMaker::drawnOn(const View &view, const FigureSubject &subject,
                                             const FigureChoices &choices) {
  if (subject.flat)
    return flatBox(*subject.flat, view, choices, m_set);
  if (!subject.framedLike)
    return drawnBox(shapesOf(subject, choices, view));
  FigureSubject like = subject;
  like.content = *std::exchange(like.framedLike, std::nullopt);
  return drawnBox(shapesOf(like, choices, view));
}

const ShapeList &FigureMaker::shapesOf(const FigureSubject &subject, const FigureChoices &choices,
                                       const View &view) {
  m_composer.forgetLabels();
  m_composer.setTheme(choices.theme);
  m_composer.setBackgroundVisible(!choices.isTransparent);
  m_composer.setView(view);
  if (subject.framedLike) {
    m_composer.setContent(chosen(*subject.framedLike, choices));
    m_composer.compose();
  }
  m_composer.setContent(chosen(subject.content, choices));
  return m_composer.compose();
}

} // namespace halfspace
