#include "widgets/carriers/qr/base45.h"

namespace halfspace {
namespace {

constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:";
constexpr std::size_t base = digits.size();
constexpr std::size_t valuesOfByte = 256;

/// Bytes are taken by two, the first of which counts more, digits by three, the last of which does.
constexpr std::size_t bytesOfGroup = 2;
constexpr std::size_t digitsOfGroup = 3;

/// How many digits so many bytes of a group need: one more.
constexpr std::size_t digitsOf(std::size_t bytes) { return bytes + 1; }

void appendGroup(std::string &text, std::string_view bytes) {
  std::size_t value = 0;
  for (const char byte : bytes)
    value = value * valuesOfByte + static_cast<unsigned char>(byte);
  for (std::size_t i = 0; i < digitsOf(bytes.size()); ++i, value /= base)
    text += digits[value % base];
}

/// What the digits of a group come to; nothing where one of them is none.
std::optional<std::size_t> valueOf(std::string_view group) {
  std::size_t value = 0;
  for (; !group.empty(); group.remove_suffix(1)) {
    const auto digit = digits.find(group.back());
    if (digit == std::string_view::npos)
      return {};
    value = value * base + digit;
  }
  return value;
}

/// The bytes of a group of two or three digits; whether they are so many.
bool appendBytes(std::string &bytes, std::string_view group) {
  const auto value = valueOf(group);
  const bool isPair = group.size() == digitsOfGroup;
  if (!value || *value >= (isPair ? valuesOfByte * valuesOfByte : valuesOfByte))
    return false;
  if (isPair)
    bytes += static_cast<char>(*value / valuesOfByte);
  bytes += static_cast<char>(*value % valuesOfByte);
  return true;
}

} // namespace

std::string base45(std::string_view bytes) {
  std::string text;
  for (std::size_t begin = 0; begin < bytes.size(); begin += bytesOfGroup)
    appendGroup(text, bytes.substr(begin, bytesOfGroup));
  return text;
}

std::optional<std::string> fromBase45(std::string_view text) {
  if (text.size() % digitsOfGroup == 1)
    return {};
  std::string bytes;
  for (std::size_t begin = 0; begin < text.size(); begin += digitsOfGroup)
    if (!appendBytes(bytes, text.substr(begin, digitsOfGroup)))
      return {};
  return bytes;
}

} // namespace halfspace
