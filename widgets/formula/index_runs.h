// Indices of letters in plain text, which has small forms only for digits: v_d, n_G, P₀_F.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfspace::math {

struct IndexRun {
  std::string text;
  bool isIndex = false;  ///< set smaller and lower
  std::string written{}; ///< of an index: as it stands in the plain text
};

/// A plain text in UTF-8 without its `_`, in runs; one, also of an empty text, where it has no index.
[[nodiscard]] std::vector<IndexRun> indexRunsOf(std::string_view plain);

} // namespace halfspace::math
