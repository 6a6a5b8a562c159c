// The text of a stranger's file, taken piece by piece, none of them longer than is allowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// The number that a whole word is; nothing for another word, and no number (NaN) for one that is too large
/// or too small to be told from 0. Whatever the country, the sign between whole and parts is the dot.
[[nodiscard]] std::optional<double> numberIn(std::string_view word);

/// A file's bytes, one after the other. Counts them, so that it can be told how far reading is.
class FileBytes {
public:
  explicit FileBytes(const std::filesystem::path &file, std::uint64_t from = 0);

  /// A byte from 0 to 255; nothing at the end.
  [[nodiscard]] std::optional<unsigned char> next() {
    const auto byte = m_buffer.sbumpc();
    if (byte == std::filebuf::traits_type::eof())
      return {};
    ++m_taken;
    return static_cast<unsigned char>(byte);
  }
  /// Whether there were so many.
  [[nodiscard]] bool take(char *into, std::size_t count);

  /// How much of the file has been taken, from 0 to 1.
  [[nodiscard]] double part() const;

private:
  std::filebuf m_buffer;
  std::uint64_t m_taken = 0;
  std::uint64_t m_all = 0;
};

} // namespace halfspace
