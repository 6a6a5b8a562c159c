// What the command line says of many figures at once.
#pragma once

#include "app/command_line.h"
#include "lessons/result.h"

#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace halfspace {

/// As they are typed.
struct BatchOptions {
  bool allLessons = false;
  std::string steps; ///< empty: each
  std::string rowsFile;
  bool onlyChanged = false;
  std::string shard;
};

/// Lets a command take them. The option for several steps, which others exclude.
CLI::Option *addBatchOptions(CLI::App &command, BatchOptions &options);

/// Puts what they ask for into a command whose subjects are known; `app` says which of them were given. Or a
/// sentence that refuses them.
[[nodiscard]] std::optional<Problem> takeBatchOptions(const BatchOptions &options, const CLI::App &app,
                                                      RenderCommand &command);

} // namespace halfspace
