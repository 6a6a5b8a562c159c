// Marks in figures' files that tell whether they are still what would be made.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// The content of a figure's file with a mark of what it was made of: a few dozen bytes where every reader
/// passes over them. A format that has no place for one stays as it is. `ending` is that of the file.
[[nodiscard]] std::string marked(std::string content, const std::string &ending, std::string_view madeOf);

/// Whether a file is, to the last byte, one that `marked` gave for the same. From a stranger's hands.
[[nodiscard]] bool isMarked(std::string_view file, const std::string &ending, std::string_view madeOf);

/// What tells this program from any other, of another version or built in another way: it may draw otherwise.
/// Empty where it cannot be told.
[[nodiscard]] std::string programFingerprint();

} // namespace halfspace
