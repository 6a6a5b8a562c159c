// What the command line says of handouts.
#pragma once

#include "app/command_line.h"
#include "lessons/result.h"

namespace CLI {
class App;
}

namespace halfspace {

/// As they are typed.
struct HandoutOptions {
  HandoutCommand command{}; ///< what needs not be understood
  std::string steps;
  std::string paper = "a4";
  std::string columns = "1";
  std::string hidden = "dashed";
};

/// Lets a command take them.
void addHandoutOptions(CLI::App &command, HandoutOptions &options);

/// What they ask for; or a sentence that refuses them.
[[nodiscard]] Result<HandoutCommand> handoutCommandOf(const HandoutOptions &options);

} // namespace halfspace
