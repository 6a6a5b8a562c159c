#include "widgets/exports/format.h"
#include "widgets/exports/pdf_writer.h"

namespace halfspace {

ExportFormat pdf() { return {"PDF", ".pdf", pdfOf}; }

} // namespace halfspace
