// The rows of a table.
#pragma once

#include "widgets/formula/latex_reader.h"

namespace halfspace::math {

/// Reads rows of cells into the table, up to what ends it, which is not taken. Throws ReadError.
void readTableRows(LatexReader &reader, Table &table);

} // namespace halfspace::math
