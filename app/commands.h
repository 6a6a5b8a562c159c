// The commands that need no display.
#pragma once

#include "app/command_line.h"

namespace halfspace {

/// Each returns the program's exit status: 0, or exitRefused after one sentence on standard error.
[[nodiscard]] int runLessons(const LessonsCommand &command);
/// A line on standard output for each problem; the exit status is 1 where there are any.
int runCheck(const CheckCommand &command);
[[nodiscard]] int runExplain(const ExplainCommand &command);
[[nodiscard]] int runRender(const RenderCommand &command);

} // namespace halfspace
