#include "widgets/carriers/base64.h"

#include <cstdint>

namespace halfspace {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned bitsOfDigit = 6;
constexpr unsigned bitsOfByte = 8;
constexpr std::uint32_t byteMask = 0xFF;
constexpr std::uint32_t digitMask = 0x3F;

/// Filled up with = where the bytes end within four digits.
constexpr std::size_t group = 4;

} // namespace

std::string base64(std::string_view bytes) {
  std::string text;
  std::uint32_t bits = 0;
  unsigned waiting = 0; // how many of the bits are not written yet
  for (const char byte : bytes) {
    bits = bits << bitsOfByte | static_cast<unsigned char>(byte);
    for (waiting += bitsOfByte; waiting >= bitsOfDigit; waiting -= bitsOfDigit)
      text += digits[bits >> (waiting - bitsOfDigit) & digitMask];
  }
  if (waiting > 0)
    text += digits[bits << (bitsOfDigit - waiting) & digitMask];
  text.append((group - text.size() % group) % group, '=');
  return text;
}

std::optional<std::string> fromBase64(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned waiting = 0;
  bool isFilledUp = false;
  for (const char c : text) {
    if (space.find(c) != std::string_view::npos)
      continue;
    isFilledUp = isFilledUp || c == '=';
    if (isFilledUp && c == '=')
      continue;
    const auto digit = digits.find(c);
    if (isFilledUp || digit == std::string_view::npos)
      return {};
    bits = bits << bitsOfDigit | static_cast<std::uint32_t>(digit);
    waiting += bitsOfDigit;
    if (waiting >= bitsOfByte) {
      waiting -= bitsOfByte;
      bytes += static_cast<char>(bits >> waiting & byteMask);
    }
  }
  return bytes;
}

} // namespace halfspace
