#include "lessons/files/numbered_file.h"

#include <algorithm>
#include <charconv>

namespace halfspace {
namespace {

constexpr std::size_t mostDigits = 9;

} // namespace

std::optional<NumberedFile> parseNumberedFile(const std::string &file) {
  const auto percent = file.find('%');
  const auto end = file.find_first_not_of("0123456789", percent + 1);
  if (percent == std::string::npos || end == std::string::npos || file[end] != 'd' ||
      file.find('%', end) != std::string::npos)
    return {};
  std::size_t digits = 1;
  if (end > percent + 1) {
    const auto [rest, error] = std::from_chars(file.data() + percent + 1, file.data() + end, digits);
    if (error != std::errc{} || digits > mostDigits)
      return {};
  }
  return NumberedFile{file.substr(0, percent), digits, file.substr(end + 1)};
}

std::string fileOf(const NumberedFile &file, int number) {
  std::string digits = std::to_string(number);
  digits.insert(0, file.digits - std::min(file.digits, digits.size()), '0');
  return file.before + digits + file.behind;
}

} // namespace halfspace
