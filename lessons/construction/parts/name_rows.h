// Rows of names: e0, e1, … of the edges, and several rows behind each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace halfspace {

/// word0, word1 …
[[nodiscard]] inline std::vector<std::string> numbered(const std::string &word, std::size_t count) {
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    names.push_back(word + std::to_string(i));
  return names;
}

template <class Name = std::string>
[[nodiscard]] std::vector<Name> joined(std::vector<std::vector<Name>> rows) {
  std::vector<Name> all;
  for (std::vector<Name> &each : rows)
    std::move(each.begin(), each.end(), std::back_inserter(all));
  return all;
}

} // namespace halfspace
