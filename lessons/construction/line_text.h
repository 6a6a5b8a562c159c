// Worked lines as text for a document.
#pragma once

#include "lessons/construction/working.h"

namespace halfspace {

/// What a document takes formulas as. LaTeX needs the package amsmath; MathML stands among HTML that is XML
/// as well.
enum class DocumentFormat : std::uint8_t { Latex, MathMl, PlainText };

/// A line, and whether all of it may be told; it must outlive this.
struct ToldLine {
  const WorkingLine *line;
  bool isWhole = true; ///< else it keeps its numbers and its sentence back, for a learner is to find them
};

/// The line's formula without its sentence: LaTeX to be put between dollars, a `<math>` element, or plain
/// text.
[[nodiscard]] std::string formulaText(const ToldLine &told, DocumentFormat format);

/// The lines below each other, each with its sentence, ended by an end of a line; empty without lines. In
/// LaTeX they are an align* environment, in MathML paragraphs.
[[nodiscard]] std::string workingText(const std::vector<ToldLine> &lines, DocumentFormat format);

} // namespace halfspace
