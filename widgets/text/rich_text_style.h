// What rich text looks like.
#pragma once

#include "widgets/text/lesson_pictures.h"

#include <QColor>
#include <QFont>

namespace halfspace {

struct RichTextStyle {
  QFont font;
  QColor ink;
  QColor warning{}; ///< for formulas and pictures that cannot be read; not valid: the ink
  QColor link{};    ///< not valid: the ink
  LessonPictures pictures{};
};

/// The distance of lines, as part of their height. Qt puts the extra space below each line.
inline constexpr double richLineSpacing = 1.28;

} // namespace halfspace
