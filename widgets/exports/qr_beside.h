// The QR code of a figure's session beside the figure.
#pragma once

#include "widgets/carriers/qr/qr_code.h"
#include "widgets/exports/drawing.h"
#include "widgets/picture/rgba_image.h"

namespace halfspace {

/// The drawing with a code, whose modules are `moduleMillimetres` wide, and its description with a sentence
/// that tells of it. The page grows by the code with its quiet zone, which stands at the right, at the
/// bottom. The code is black on white, whatever the page is painted with.
[[nodiscard]] Drawing withQrCode(Drawing drawing, const QrCode &code);

/// The side of a module in an image of so many pixels an inch, which are above 0: whole pixels, as many as
/// make it at least `moduleMillimetres`.
[[nodiscard]] int modulePixels(double pixelsPerInch);

/// The image with a code, whose modules are so many whole pixels wide. What the image grows by beside the
/// code has the colour of the ground, or is clear where there is none.
[[nodiscard]] RgbaImage withQrCode(const RgbaImage &image, const QrCode &code, double pixelsPerInch,
                                   std::optional<Color> ground);

} // namespace halfspace
