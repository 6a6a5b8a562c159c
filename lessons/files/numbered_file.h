// Files of one kind that differ in a number.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace halfspace {

/// A file's name with a number in it: frames/%04d.png.
struct NumberedFile {
  std::string before;
  std::size_t digits = 0; ///< at least so many
  std::string behind;
};

/// Of a name with one such place, %04d or %d; nothing where it has none or several.
[[nodiscard]] std::optional<NumberedFile> parseNumberedFile(const std::string &file);

/// frames/0007.png for 7. Requires a number that is not negative.
[[nodiscard]] std::string fileOf(const NumberedFile &file, int number);

} // namespace halfspace
