// Where the formulas and sentences of a working stand.
#pragma once

#include "lessons/construction/working.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/working/sentence_breaker.h"

#include <QFont>
#include <QRectF>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace halfspace {

/// A worked line with its pieces typeset.
struct TypesetLine {
  WorkingLine source;
  std::array<Typesetter::Picture, 3> pieces{}; ///< symbols, numbers, result; null where the source is empty
  Typesetter::Picture told{}; ///< what is told to fill its blank in; null where there is nothing
  std::array<std::vector<Term>, 3> numbers{}; ///< of each piece, by the indices of its picture
  bool isPartial = false;                     ///< something of the line is not shown, nor its sentence
};

/// What is said about a line to the learner who filled it in.
struct LineRemark {
  QString text;
  bool right = false;
  bool isOfNow = true; ///< the numbers are still those that were asked for
  bool operator==(const LineRemark &) const = default;
};

/// A formula in its place.
struct PlacedFormula {
  Typesetter::Picture picture;
  QPointF baseline;
  double emPixels = 0;
  std::optional<LinePiece> piece{}; ///< which of its line it is; nothing for what is told
  bool beginsRow = false;

  /// From the picture's lengths to places in the working.
  [[nodiscard]] QRectF toWorking(const QRectF &inPicture) const;
  [[nodiscard]] QRectF box() const { return toWorking(picture->box()); }
};

/// A line of plain text in its place.
struct PlacedText {
  QString text;
  std::vector<SentenceBreaker::Run> runs;
  QPointF baseline;
};

struct PlacedLine {
  QRectF box;                      ///< with the space around it, across the width of its column
  std::vector<PlacedText> heading; ///< the construction's name, above its first line where there are several
  std::vector<PlacedFormula> formulas;
  double formulasBottom = 0; ///< below the top of the box
  QRectF blank;              ///< the room of what is left out; null when nothing is
  std::vector<PlacedText> remark;
  std::vector<PlacedText> sentence;
};

struct PlacedWorking {
  std::vector<PlacedLine> lines;
  QSizeF size; ///< wider than asked for where a formula does not fit
};

/// The size of formulas beside a font, in pixels.
[[nodiscard]] double emPixelsOf(const QFont &font);

/// The width below which no formula can be broken or drawn smaller.
[[nodiscard]] double narrowestWidth(const std::vector<TypesetLine> &lines, const QFont &font);

/// What stands there already, by the ids of lines.
using HeldLines = std::map<std::string, PlacedLine>;

/// Lays out the lines from top to bottom in a width, all in logical pixels: pieces flow from left to right
/// and go on in an indented row where they do not fit; a piece wider than that is broken, and what cannot be
/// broken is drawn smaller, but not beyond reading. The lines of several constructions have its name above
/// them. `remarks` are by the lines' ids.
///
/// While lines are held their rows stay as they are, and nothing below them moves: a longer number gets its
/// room from the margin, and then from the size of the line's type. Only what would become too small to be
/// read is laid out anew, and no line becomes less high.
[[nodiscard]] PlacedWorking placeWorking(const std::vector<TypesetLine> &lines,
                                         const std::map<std::string, QString> &remarks,
                                         SentenceBreaker &sentences, const QFont &font, double width,
                                         const HeldLines &held = {});

} // namespace halfspace
