// What rich text looks like.
#pragma once

#include <QColor>
#include <QFont>

#include <filesystem>

namespace halfspace {

struct RichTextStyle {
  QFont font;
  QColor ink;
  QColor warning{};                 ///< for formulas and pictures that cannot be read; not valid: the ink
  QColor link{};                    ///< not valid: the ink
  std::filesystem::path pictures{}; ///< the folder that pictures are taken from; empty: they are described
};

/// The distance of lines, as part of their height. Qt puts the extra space below each line.
inline constexpr double richLineSpacing = 1.28;

} // namespace halfspace
