// Abbreviations in the LaTeX of a lesson's words: `\R` for `\mathbb{R}`.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// `#1` … `#9` in the body stand for its arguments.
struct Macro {
  int arguments = 0;
  std::string body;
  bool operator==(const Macro &) const = default;
};

/// By their names, without the backslash. A macro hides a command of the same name.
using Macros = std::map<std::string, Macro, std::less<>>;

/// The number from 1 to 9 behind a `#` at this place of a body; 0 where there is none.
[[nodiscard]] std::size_t parameterAt(std::string_view body, std::size_t at);

/// With as many arguments as the highest number behind a `#` says; nothing where a `#` stands for none.
[[nodiscard]] std::optional<Macro> macroOf(std::string body);

/// A macro that uses itself, directly or through others, not one that only uses such a macro.
[[nodiscard]] std::optional<std::string> findRecursion(const Macros &macros);

/// The formula without macros. As it is where it would become longer than `longestExpansion` bytes.
[[nodiscard]] std::string expanded(const std::string &latex, const Macros &macros);
inline constexpr std::size_t longestExpansion = 65536;

} // namespace halfspace
