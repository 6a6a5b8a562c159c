// What rich text looks like.
#pragma once

#include <QColor>
#include <QFont>

namespace halfspace {

struct RichTextStyle {
  QFont font;
  QColor ink;
  QColor warning{}; ///< for formulas that cannot be read; not valid: the ink
};

/// The distance of lines, as part of their height. Qt puts the extra space below each line.
inline constexpr double richLineSpacing = 1.28;

} // namespace halfspace
