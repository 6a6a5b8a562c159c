// Worked lines taken elsewhere.
#pragma once

#include "widgets/working/shown_lines.h"

#include <optional>

class QPoint;
class QWidget;

namespace halfspace {

/// Puts the formula of a line on the clipboard; without one all lines, with their sentences. MathML lies
/// there as HTML too, for word processors, and as plain text, for editors.
void copyLines(const std::vector<ToldLine> &lines, std::optional<std::size_t> line, DocumentFormat format);

/// Lets the user choose from a menu what of the lines is copied, and as what. `line`: the one that was
/// clicked, if it was one.
void showCopyMenu(QWidget &block, const QPoint &globalPlace, const ShownLines &lines,
                  std::optional<std::size_t> line);

} // namespace halfspace
