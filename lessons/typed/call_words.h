// The words that can be called in a typed line.
#pragma once

#include <string>
#include <vector>

namespace halfspace {

/// Those of the kinds of objects, and the ids and words of the constructions, each once.
[[nodiscard]] const std::vector<std::string> &callWords();

} // namespace halfspace
