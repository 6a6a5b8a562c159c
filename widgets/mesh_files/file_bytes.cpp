#include "widgets/mesh_files/file_bytes.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace halfspace {

std::optional<double> numberIn(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-"))
    word.remove_prefix(1);
  double number = 0;
  const char *const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, number);
  if (error == std::errc::invalid_argument || end != last)
    return {};
  return error == std::errc{} ? number : std::numeric_limits<double>::quiet_NaN();
}

FileBytes::FileBytes(const std::filesystem::path &file, std::uint64_t from) : m_taken(from) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  m_all = error ? 0 : bytes;
  m_buffer.open(file, std::ios::in | std::ios::binary);
  m_buffer.pubseekpos(static_cast<std::streamoff>(from), std::ios::in);
}

bool FileBytes::take(char *into, std::size_t count) {
  m_taken += count;
  const auto most = static_cast<std::streamsize>(count);
  return m_buffer.sgetn(into, most) == most;
}

double FileBytes::part() const {
  return m_all == 0 ? 1 : std::min(static_cast<double>(m_taken) / static_cast<double>(m_all), 1.0);
}

} // namespace halfspace
