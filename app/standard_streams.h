// What the program says to whoever started it.
#pragma once

#include "lessons/result.h"

#include <string_view>

namespace halfspace {

/// The exit status of a command that could not do what it was asked for.
inline constexpr int exitRefused = 2;

/// To be called first: where a standard stream is closed, no file that is opened later takes its place.
/// Writing to it still fails.
void holdStandardStreams();

/// Writes all of a text to standard output. The exit status: 0, or exitRefused after a sentence on standard
/// error where it cannot be written (a full disk, a closed stream).
[[nodiscard]] int printOut(std::string_view text);

/// Writes `halfspace: sentence` to standard error, with nothing in it that would steer a terminal.
void printError(std::string_view sentence);

/// One sentence on standard error; exitRefused.
int fail(const Problem &problem);

} // namespace halfspace
