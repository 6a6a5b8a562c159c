#include "widgets/exports/format.h"
#include "widgets/exports/pdf_writer.h"

namespace halfspace {

ExportFormat pdf() {
  return {"PDF", ".pdf",
          [](const Drawing &drawing, const math::MathFonts &fonts, TextAs) { return pdfOf(drawing, fonts); }};
}

} // namespace halfspace
