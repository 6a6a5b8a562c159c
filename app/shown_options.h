// What the command line says of the parts of a picture that are drawn.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/shown_parts.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace halfspace {

/// Names of parts, as they are typed.
struct ShownOptions {
  std::vector<std::string> with;
  std::vector<std::string> without;
};

/// Lets a command take them: `--show coordinates`, `--without axes,grid`.
void addShownOptions(CLI::App &command, ShownOptions &options);

/// What they ask for; or a sentence that refuses them: a name of no part, or one that is to be shown and left
/// out.
[[nodiscard]] Result<ShownParts> shownPartsOf(const ShownOptions &options);

} // namespace halfspace
