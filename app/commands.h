// The commands that need no display.
#pragma once

#include "app/command_line.h"

namespace halfspace {

/// Each returns the program's exit status: 0, or 2 after one sentence on standard error.
[[nodiscard]] int runLessons(const LessonsCommand &command);
[[nodiscard]] int runExplain(const ExplainCommand &command);
[[nodiscard]] int runRender(const RenderCommand &command);

/// One sentence on standard error, and the exit status of a bad argument.
int fail(const Problem &problem);

} // namespace halfspace
