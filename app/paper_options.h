// What the command line says of figures of vectors.
#pragma once

#include "app/command_line.h"
#include "lessons/result.h"

namespace CLI {
class App;
}

namespace halfspace {

/// As they are typed.
struct PaperOptions {
  std::string width = "12cm";
  std::string typeSize = "9pt";
  std::string hidden = "dashed";
};

/// Lets a command take them.
void addPaperOptions(CLI::App &render, PaperOptions &options);

/// What they ask for; or a sentence that refuses them.
[[nodiscard]] Result<PaperCommand> paperOf(const PaperOptions &options);

} // namespace halfspace
