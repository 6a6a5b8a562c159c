// What the command line says of animations.
#pragma once

#include "app/command_line.h"
#include "lessons/result.h"

namespace CLI {
class App;
}

namespace halfspace {

/// As they are typed.
struct AnimateOptions {
  std::string subject;
  std::vector<std::string> assignments;
  std::string motion;
  std::string output;
  std::string size = "960x600";
  std::string seconds;
  std::string framesPerSecond = "25";
  std::string theme = themes().front().name;
  int step = 0;
  bool isTransparent = false;
};

/// Lets a command take them, but for its subject and that one's values.
void addAnimateOptions(CLI::App &command, AnimateOptions &options);

/// What they ask for; `command` says which of them were given. Or a sentence that
/// refuses them.
[[nodiscard]] Result<AnimateCommand> animateCommandOf(const AnimateOptions &options, const CLI::App &command);

} // namespace halfspace
