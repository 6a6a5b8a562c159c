#include "widgets/exports/format.h"
#include "widgets/exports/svg_writer.h"

namespace halfspace {

ExportFormat svg() {
  return {"SVG", ".svg",
          [](const Drawing &drawing, const math::MathFonts &fonts) { return svgOf(drawing, fonts); }};
}

} // namespace halfspace
