// `halfspace eval`: geometry questions as JSON lines.
#pragma once

#include "app/command_line.h"

namespace halfspace {

/// The exit status: 0 every line was answered, 1 some line got an error answer, 2 after one sentence on
/// standard error where the questions could not be read or the answers not be written.
[[nodiscard]] int runEval(const EvalCommand &command);

} // namespace halfspace
