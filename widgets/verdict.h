// The mark of what is right, wrong, or still open.
#pragma once

#include "widgets/picture/theme.h"

#include <QPointF>

class QPainter;

namespace halfspace {

enum class Verdict { Open, Right, Wrong };

/// Paints a filled circle with a check mark, one with a cross, or an empty one, around a point. One that is
/// not of now, but about what has changed since, is grey.
void paintVerdict(QPainter &painter, QPointF center, double radius, Verdict verdict, const Theme &theme,
                  bool isOfNow = true);

} // namespace halfspace
