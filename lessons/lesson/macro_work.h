// How much work macros make.
#pragma once

#include "lessons/lesson/macros.h"

namespace halfspace {

/// How many bytes macros bring into a formula, those that other macros replace again included; not counted
/// further than beyond `longestExpansion` and one more macro.
[[nodiscard]] std::size_t bytesFromMacros(const std::string &latex, const Macros &macros);

/// Into all formulas of a lesson together they bring no more: as much as a lesson may be long.
inline constexpr std::size_t mostBytesFromMacros = 1U << 20U;

} // namespace halfspace
