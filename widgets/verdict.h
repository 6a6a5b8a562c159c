// The mark of what is right, wrong, or still open.
#pragma once

#include "widgets/picture/theme.h"

#include <QPointF>

class QPainter;

namespace halfspace {

enum class Verdict { Open, Right, Wrong };

/// Paints a filled circle with a check mark, one with a cross, or an empty one, around a point.
void paintVerdict(QPainter &painter, QPointF center, double radius, Verdict verdict, const Theme &theme);

} // namespace halfspace
