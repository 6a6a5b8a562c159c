// Paragraphs set in lines.
#pragma once

#include "widgets/handout/break_paragraph.h"
#include "widgets/handout/set_thing.h"
#include "widgets/handout/set_words.h"

namespace halfspace {

/// A line with its things in their places from the left end of its baseline.
struct SetLine {
  std::vector<SetThing> things;
  double width = 0;
  double ascent = 0; ///< above its baseline
  double depth = 0;
};

struct ParagraphPlan {
  double width = 0; ///< in points
  double size = 0;  ///< of its type
  double leading = 0;
  LineEnds ends = LineEnds::Ragged;
  std::size_t element = 0; ///< that it is, of the document
};

/// A formula as it fits a width: broken into lines where it is wider, and set smaller where these are. Its
/// start is the left end of its baseline, which is at the origin.
[[nodiscard]] FormulaPart fittedFormula(const InlineFormula &formula, double size, double width);

/// The lines of a paragraph. Each formula becomes an element of its own within the paragraph's.
[[nodiscard]] std::vector<SetLine> setParagraph(const InlineText &text, const ParagraphPlan &plan,
                                                const HandoutFonts &fonts, ReadingOrder &order);

/// The entries of a formula's element: what is read in its place.
[[nodiscard]] std::string formulaEntries(const std::string &plain);

} // namespace halfspace
