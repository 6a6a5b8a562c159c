// Text compared whatever the size of its letters.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace halfspace {

[[nodiscard]] inline std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

} // namespace halfspace
