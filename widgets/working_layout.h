// Where the formulas and sentences of a working stand.
#pragma once

#include "lessons/working.h"
#include "widgets/typeset/typesetter.h"

#include <QFont>
#include <QRectF>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace halfspace {

/// A worked line with its pieces typeset.
struct TypesetLine {
  WorkingLine source;
  std::array<Typesetter::Picture, 3> pieces; ///< symbols, numbers, result; null where the source is empty
};

/// A formula in its place.
struct PlacedFormula {
  Typesetter::Picture picture;
  QPointF baseline;
  double exPixels = 0;

  /// From the picture's lengths to places in the working.
  [[nodiscard]] QRectF toWorking(const QRectF &inPicture) const;
  [[nodiscard]] QRectF box() const { return toWorking(picture->box()); }
};

/// A line of plain text in its place.
struct PlacedText {
  QString text;
  QPointF baseline;
};

struct PlacedLine {
  QRectF box; ///< with the space around it, across the whole width
  std::vector<PlacedFormula> formulas;
  QRectF blank; ///< stands for the numbers that are hidden; null when none are
  std::vector<PlacedText> sentence;
};

struct PlacedWorking {
  std::vector<PlacedLine> lines;
  QSizeF size; ///< wider than asked for where a formula does not fit
};

/// Lays out the lines from top to bottom in a width, all in logical pixels: pieces flow from left to right
/// and go on in an indented row where they do not fit; a piece wider than that is drawn smaller, but not
/// beyond reading. Lines whose ids are in `blanked` show a blank for their numbers.
[[nodiscard]] PlacedWorking placeWorking(const std::vector<TypesetLine> &lines,
                                         const std::set<std::string> &blanked, const QFont &font,
                                         double width);

} // namespace halfspace
