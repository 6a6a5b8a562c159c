// Typeset labels for the 3D scene.
#pragma once

#include "widgets/picture/labels/label_picture.h"

class QImage;

namespace halfspace {

class MathPicture;
class Typesetter;

/// Paints labels that were set in the typesetter's fonts, and keeps the latest of them. The typesetter must
/// outlive the painter.
[[nodiscard]] LabelPainter labelPainter(const Typesetter &typesetter);

/// The picture of a formula in the style's ink on its halo.
[[nodiscard]] RgbaImage paintLabel(const MathPicture &formula, const LabelStyle &style);

/// The same pixels.
[[nodiscard]] RgbaImage fromImage(const QImage &image);
[[nodiscard]] QImage toImage(const RgbaImage &image);

} // namespace halfspace
