// Makes figures for files: pictures of pixels and drawings of vectors, framed and measured as is asked.
#pragma once

#include "app/figures/figure_choices.h"
#include "app/figures/framing.h"
#include "lessons/result.h"
#include "widgets/carriers/qr/qr_code.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/scene/offscreen.h"

#include <optional>
#include <string>

namespace halfspace {

class Typesetter;

/// What a figure is of.
struct FigureSubject {
  SceneContent content; ///< in space
  /// Another moment of the same: the figure is framed as that would be, and its labels stay where they stand
  /// there.
  std::optional<SceneContent> framedLike{};
  Camera camera{};                   ///< that it is seen by
  std::optional<FlatPicture> flat{}; ///< drawn instead of what is in space
  std::string title{};
  std::string description{}; ///< what is to be seen, in a sentence
  std::string session{};     ///< the text of one with which the figure can be opened again; empty: it cannot
};

/// A figure as the content of its file.
struct FigureFile {
  std::string content;
  bool leavesOutSurfaces = false; ///< as `ShapeList` has it
};

/// The code beside a figure; nothing where there is to be none. A sentence where its session is too long.
[[nodiscard]] Result<std::optional<QrCode>> codeBeside(const FigureSubject &subject,
                                                       const FigureChoices &choices);

/// Makes one figure after the other; what takes time to be opened serves for all of them. No figure depends
/// on those before it.
class FigureMaker {
public:
  /// The typesetter must outlive it.
  explicit FigureMaker(const Typesetter &typesetter);

  /// Fails with a sentence where pictures cannot be drawn here, or not as large.
  [[nodiscard]] Result<FigureFile> file(const FigureSubject &subject, const FigureChoices &choices);

  /// A figure of pixels, whatever the chosen format, without its code.
  [[nodiscard]] Result<DrawnPicture> picture(const FigureSubject &subject, const FigureChoices &choices);
  /// A figure of vectors, likewise; not yet described.
  [[nodiscard]] Drawing drawing(const FigureSubject &subject, const FigureChoices &choices);

  /// The view that a figure is drawn on, and the part of it that is kept: of one of pixels, as large as its
  /// file.
  [[nodiscard]] Framing framingOf(const FigureSubject &subject, const FigureChoices &choices);

  /// The shapes of a subject in space, with labels that stand as in what it is framed like. Valid until it is
  /// called again.
  [[nodiscard]] const ShapeList &shapesOf(const FigureSubject &subject, const FigureChoices &choices,
                                          const View &view);

private:
  // Both may run out of memory.
  [[nodiscard]] Result<FigureFile> madeFile(const FigureSubject &subject, const FigureChoices &choices);
  [[nodiscard]] Result<DrawnPicture> madePicture(const FigureSubject &subject, const FigureChoices &choices);
  /// What is drawn of a subject on a view.
  [[nodiscard]] std::optional<PixelBox> drawnOn(const View &view, const FigureSubject &subject,
                                                const FigureChoices &choices);

  const Typesetter &m_typesetter;
  LabelSetter m_set;
  Composer m_composer;
  OffscreenPainter m_painter;
};

} // namespace halfspace
