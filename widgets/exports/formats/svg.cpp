#include "widgets/exports/format.h"
#include "widgets/exports/svg_writer.h"

namespace halfspace {

ExportFormat svg() { return {"SVG", ".svg", svgOf, true}; }

} // namespace halfspace
