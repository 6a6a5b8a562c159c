// Whatever the bytes: rows of values below known columns, in the order of their lines, or a problem with a
// sentence.
#include "lessons/reading/value_rows.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  using namespace halfspace;
  const auto demand = [](bool holds) {
    if (!holds)
      std::abort();
  };
  const auto rows = readValueRows({reinterpret_cast<const char *>(data), size}, "fuzz");
  if (!rows) {
    demand(!rows.problem().sentence.empty());
    return 0;
  }
  demand(!rows->rows.empty());
  int line = 0;
  for (const ValueRow &row : rows->rows) {
    demand(row.line > line);
    line = row.line;
    for (const ColumnValue &value : row.values)
      demand(value.column < rows->columns.size() && !value.value.empty());
  }
  return 0;
}
