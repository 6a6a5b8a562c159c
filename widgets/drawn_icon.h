// Icons drawn as strokes, sharp at any size.
#pragma once

#include <QIcon>
#include <QPainterPath>

namespace halfspace {

/// Icons are drawn on a square of this side, and scaled.
inline constexpr double iconSquare = 16;

/// The strokes, and what is filled, in one ink.
[[nodiscard]] QIcon drawnIcon(const QPainterPath &strokes, const QColor &ink,
                              const QPainterPath &filled = {});

} // namespace halfspace
