// The manual page, out of what the command line itself knows.
#pragma once

#include "app/command_description.h"

namespace halfspace {

/// Listed in no help: it is for the build, which adds what is no option and no command.
inline constexpr const char *manualPageCommand = "manual-page";

/// The page's beginning, up to the commands, in roff. `summary`: what the program is for, in a line that
/// begins with a small letter. `version`: as `--version` says it.
[[nodiscard]] std::string manualPage(const CommandDescription &program, const std::string &summary,
                                     const std::string &version);

} // namespace halfspace
