// The command that opens the window.
#pragma once

#include "app/command_line.h"

namespace halfspace {

/// Opens the window and returns the program's exit status; 2 after one sentence where there is no display, no
/// OpenGL 3.2, or no such lesson or file.
[[nodiscard]] int runWindow(const WindowCommand &command, int argc, char **argv);

} // namespace halfspace
