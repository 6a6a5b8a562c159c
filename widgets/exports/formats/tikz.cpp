#include "widgets/exports/format.h"
#include "widgets/exports/tikz_writer.h"

namespace halfspace {

ExportFormat tikz() {
  return {"TikZ", ".tex",
          [](const Drawing &drawing, const math::MathFonts &, TextAs) { return tikzOf(drawing); }};
}

} // namespace halfspace
