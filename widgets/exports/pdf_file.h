// The bare structure of a PDF file: objects, streams, the table of where they stand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// Collects the objects of a file. The same objects give the same bytes.
class PdfFile {
public:
  /// The number of an object that is told later.
  [[nodiscard]] int reserve();
  void put(int number, std::string content);
  /// Both in one.
  int add(std::string content);
  /// A stream, deflated; `entries` stand in its dictionary besides.
  int addStream(std::string_view content, const std::string &entries = {});

  /// The whole file. `catalog` and `info` are the numbers of its two objects that all else hangs on.
  [[nodiscard]] std::string bytes(int catalog, int info) const;

private:
  std::vector<std::string> m_objects; ///< the first has the number 1
};

/// 7 0 R
[[nodiscard]] std::string pdfReference(int object);

/// A text of UTF-8 as a string for people: as UTF-16, in digits.
[[nodiscard]] std::string pdfText(std::string_view text);
/// The digits of one character in UTF-16: D835DC65.
[[nodiscard]] std::string utf16Digits(char32_t character);
/// A number in as many hexadecimal digits as are asked for.
[[nodiscard]] std::string hexDigits(std::uint64_t number, int digits);

} // namespace halfspace
