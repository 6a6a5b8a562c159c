// Worked lines on a painter.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/working/block_layout.h"

#include <QColor>

#include <functional>
#include <optional>
#include <set>

class QPainter;

namespace halfspace {

/// How all lines of a page look.
struct WorkingLook {
  Theme theme = themes().front();
  /// The colour of marked terms, asked for at every painting; the ink of all terms without it.
  std::function<QColor(const QString &markId)> inkOf{};
  std::set<std::string> highlighted{}; ///< the terms of these marks stand out
};

/// The number whose trace is shown, in whatever block, and the lines that it came from.
struct ShownTrace {
  std::optional<NumberPlace> number{};
  std::set<std::string> lines{};
};

/// What the pointer and the keys have come to in a block.
struct TouchedLines {
  std::optional<NumberPlace> hovered{};
  std::optional<NumberPlace> chosen{};
  std::optional<std::size_t> line{};
  bool hasFocus = false;
};

/// The background of a block, and the bar before its lines.
void paintBlock(QPainter &painter, const QRect &part, int height, const Theme &theme);

/// Those of the lines that reach into a part of the block, in the painter's font.
void paintLines(QPainter &painter, const QRect &part, const BlockLayout &layout, const WorkingLook &look,
                const ShownTrace &trace, const TouchedLines &touched);

} // namespace halfspace
