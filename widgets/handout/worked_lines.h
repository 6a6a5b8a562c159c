// Worked lines as blocks of a handout.
#pragma once

#include "lessons/lesson/practice.h"
#include "widgets/handout/markdown_blocks.h"

namespace halfspace {

/// Some lines of a working: [begin, end).
struct LinesInWorking {
  const Working &working;
  std::size_t begin;
  std::size_t end;
};

/// Each line with its sentence, as `explain` prints both; where something of it is left out, room to write
/// stands for that, and its sentence is not said. The lines of several constructions have its name before
/// them.
[[nodiscard]] HandoutBlocks workedLines(const LinesInWorking &lines, const Fade &fade,
                                        const FormulaSetting &setting);

} // namespace halfspace
