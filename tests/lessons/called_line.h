// Worked lines with ids, without a construction.
#pragma once

#include "lessons/construction/parts/worked_lines.h"

namespace halfspace::test {

/// The line by an id.
inline WorkingLine called(std::string id, WorkingLine line) {
  line.id = std::move(id);
  return line;
}

} // namespace halfspace::test
