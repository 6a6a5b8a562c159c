// Typeset labels for the 3D scene.
#pragma once

#include "widgets/scene/label_picture.h"

namespace halfspace {

class MathPicture;
class Typesetter;

/// Never waits: gives null until the formula is typeset, which the typesetter's `ready` tells. The typesetter
/// must outlive the painter.
[[nodiscard]] LabelPainter labelPainter(Typesetter &typesetter);

/// Waits for every formula: for pictures drawn without a window. Needs a QGuiApplication.
[[nodiscard]] LabelPainter blockingLabelPainter(Typesetter &typesetter);

/// The picture of a formula in the style's ink on its halo.
[[nodiscard]] LabelPicture paintLabel(const MathPicture &formula, const LabelStyle &style);

} // namespace halfspace
