#include "eval/json_strings.h"

#include <array>

namespace halfspace {
namespace {

bool isDigit(char c) { return '0' <= c && c <= '9'; }

/// The value of a hexadecimal digit, or −1.
int hexDigit(char c) {
  if (isDigit(c))
    return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return 'a' <= lower && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// The first bytes of sequences of one length, and what may follow them first; after that anything from 80 to
/// BF (Unicode, table 3-7).
struct Utf8Form {
  int firstLow;
  int firstHigh;
  int secondLow;
  int secondHigh;
  std::size_t length;
};
constexpr std::array utf8Forms{Utf8Form{0xC2, 0xDF, 0x80, 0xBF, 2}, Utf8Form{0xE0, 0xE0, 0xA0, 0xBF, 3},
                               Utf8Form{0xE1, 0xEC, 0x80, 0xBF, 3}, Utf8Form{0xED, 0xED, 0x80, 0x9F, 3},
                               Utf8Form{0xEE, 0xEF, 0x80, 0xBF, 3}, Utf8Form{0xF0, 0xF0, 0x90, 0xBF, 4},
                               Utf8Form{0xF1, 0xF3, 0x80, 0xBF, 4}, Utf8Form{0xF4, 0xF4, 0x80, 0x8F, 4}};

void appendUtf8(std::string &text, int code) {
  const auto append = [&](int byte) { text += static_cast<char>(byte); };
  const auto appendFollowing = [&](int shift) { append(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    append(code);
  } else if (code < 0x800) {
    append(0xC0 | (code >> 6));
    appendFollowing(0);
  } else if (code < 0x10000) {
    append(0xE0 | (code >> 12));
    appendFollowing(6);
    appendFollowing(0);
  } else {
    append(0xF0 | (code >> 18));
    appendFollowing(12);
    appendFollowing(6);
    appendFollowing(0);
  }
}

} // namespace

int hexWord(std::string_view text) {
  if (text.size() < 4)
    return -1;
  int word = 0;
  for (const char c : text.substr(0, 4)) {
    const int digit = hexDigit(c);
    if (digit < 0)
      return -1;
    word = word * 16 + digit;
  }
  return word;
}

bool isHighSurrogate(int word) { return 0xD800 <= word && word < 0xDC00; }
bool isLowSurrogate(int word) { return 0xDC00 <= word && word < 0xE000; }

std::size_t utf8Length(std::string_view text) {
  const auto within = [&](std::size_t i, int low, int high) {
    const int byte = i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    return low <= byte && byte <= high;
  };
  for (const Utf8Form &form : utf8Forms)
    if (within(0, form.firstLow, form.firstHigh)) {
      bool valid = within(1, form.secondLow, form.secondHigh);
      for (std::size_t i = 2; i < form.length; ++i)
        valid = valid && within(i, 0x80, 0xBF);
      return valid ? form.length : 0;
    }
  return 0;
}

char simpleEscape(char letter) {
  switch (letter) {
  case '"':
  case '\\':
  case '/':
    return letter;
  case 'b':
    return '\b';
  case 'f':
    return '\f';
  case 'n':
    return '\n';
  case 'r':
    return '\r';
  case 't':
    return '\t';
  default:
    return 0;
  }
}

std::string unescaped(std::string_view inside) {
  std::string text;
  for (std::size_t i = 0; i < inside.size();) {
    if (inside[i] != '\\') {
      text += inside[i++];
    } else if (inside[i + 1] != 'u') {
      text += simpleEscape(inside[i + 1]);
      i += 2;
    } else {
      int code = hexWord(inside.substr(i + 2));
      i += 6;
      if (isHighSurrogate(code)) {
        code = 0x10000 + ((code - 0xD800) << 10) + (hexWord(inside.substr(i + 2)) - 0xDC00);
        i += 6;
      }
      appendUtf8(text, code);
    }
  }
  return text;
}

} // namespace halfspace
