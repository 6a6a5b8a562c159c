// Worked lines taken elsewhere.
#pragma once

#include "widgets/working/shown_lines.h"

#include <optional>

class QPoint;
class QWidget;

namespace halfspace {

/// Puts a line on the clipboard as LaTeX; without one all lines.
void copyLatex(const ShownLines &lines, std::optional<std::size_t> line);

/// Lets the user choose from a menu what of the lines is copied. `line`: the one that was clicked, if it was
/// one.
void showCopyMenu(QWidget &block, const QPoint &globalPlace, const ShownLines &lines,
                  std::optional<std::size_t> line);

} // namespace halfspace
