// The manual page, out of what the command line itself knows.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace halfspace {

/// Listed in no help: it is for the build, which adds what is no option and no command.
inline constexpr const char *manualPageCommand = "manual-page";

/// The page's beginning, up to the commands, in roff. `summary`: what the program is for, in a line that
/// begins with a small letter.
[[nodiscard]] std::string manualPage(const CLI::App &app, const std::string &summary);

} // namespace halfspace
