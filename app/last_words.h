// What is said of an exception that nobody expected.
#pragma once

#include <exception>
#include <string>

namespace halfspace {

/// The sentence for an exception that comes out of a whole command, or out of an event of the window.
[[nodiscard]] std::string lastWordsOn(const std::exception &exception);

} // namespace halfspace
