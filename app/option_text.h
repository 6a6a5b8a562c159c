// What is typed as options, read; and what is said of it where it cannot be.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// A sentence on what was typed, which stands in no file.
[[nodiscard]] Problem refused(std::string sentence);

/// Takes a positive number off the front of a text; nothing where there is none.
[[nodiscard]] std::optional<double> takePositive(std::string_view &text);
/// All of a text is a positive number.
[[nodiscard]] std::optional<double> parsePositive(std::string_view text);
/// All of a text is a whole number from 1 on.
[[nodiscard]] std::optional<std::size_t> parseCount(std::string_view text, std::size_t most);
/// Numbers of steps, and from one to another: 2,4-6. Each once, in their order.
[[nodiscard]] std::optional<std::vector<int>> parseSteps(std::string_view text);

/// The names of what is in a list, one behind the other.
template <class List, class NameOf>
[[nodiscard]] std::string joinedNames(const List &list, const NameOf &nameOf, const std::string &separator) {
  std::string names;
  for (const auto &each : list)
    names += (names.empty() ? "" : separator) + std::string(std::invoke(nameOf, each));
  return names;
}

} // namespace halfspace
