// How a crossing stands among the others: in words, and as a mark in the table and on the axis.
#pragma once

#include "lessons/construction/crossings.h"
#include "widgets/picture/theme.h"

#include <QColor>
#include <QPointF>
#include <QString>

#include <cstdint>

class QPainter;

namespace halfspace {

enum class Standing : std::uint8_t {
  First,
  FirstToo,   ///< at the same λ as the first
  FirstSoFar, ///< of those that have been asked
  Hit,
  Outside,
  Behind,
  Parallel,
  InPlane,
  NoTriangle,
  NoDirection,
  NotAsked ///< those before it are being asked one after the other
};

/// Where the crossings have a nearest so far, the fragments are asked one after the other up to the chosen
/// one; the number 0 as the nearest so far: none of them was hit.
[[nodiscard]] Standing standingOf(const Crossing &crossing, const Crossings &crossings);

/// Of all, or of those that have been asked.
[[nodiscard]] inline bool isNearest(Standing standing) {
  return standing == Standing::First || standing == Standing::FirstSoFar;
}

/// In the triangle and ahead, the nearest or not.
[[nodiscard]] inline bool isHit(Standing standing) {
  return isNearest(standing) || standing == Standing::FirstToo || standing == Standing::Hit;
}

/// Whether it crosses before the ray's start.
[[nodiscard]] bool isBehindStart(const Crossing &crossing);

/// In plain words: hit first, behind the start.
[[nodiscard]] QString wordsOf(Standing standing);
/// The same where there is little room.
[[nodiscard]] QString shortWordsOf(Standing standing);
/// In a sentence: barn 3: λ = 1/2, hit first.
[[nodiscard]] QString sentenceOf(const Crossing &crossing, Standing standing);

[[nodiscard]] Color inkOf(Standing standing, bool isBehindStart, const Theme &theme);

/// How far a mark of the usual radius 1 reaches: the nearest has a ring.
inline constexpr double ringRadius = 1.75;

/// A disc for a hit, with a ring for the nearest; hollow behind the start; a small diamond beside the
/// triangle. Nothing where the plane is not crossed, or not asked yet.
void paintMark(QPainter &painter, QPointF center, double radius, Standing standing, const QColor &ink);

} // namespace halfspace
