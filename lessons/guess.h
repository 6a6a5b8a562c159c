// What was perhaps meant by a wrong name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace halfspace {

/// The name that was perhaps meant by a wrong one: it differs in a third of its letters at most, or in one,
/// and in the fewest of all; empty where none is so near.
[[nodiscard]] std::string nearestOf(std::string_view wrong, std::span<const std::string> names);

/// A sentence that complains of a wrong name, and, where one of the names is near, another that guesses it.
[[nodiscard]] std::string withGuess(const std::string &sentence, std::string_view wrong,
                                    std::span<const std::string> names);

} // namespace halfspace
