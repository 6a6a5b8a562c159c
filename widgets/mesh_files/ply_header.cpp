#include "widgets/mesh_files/ply_header.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

/// No count that fits a file is larger. An element of a header of 64 KiB takes less than 2^20 bytes, so that
/// the product stays far within 64 bits.
constexpr std::uint64_t largestCount = 1ULL << 40U;
constexpr std::uint64_t cornersOfFace = 3;
/// A digit and what parts it from the next.
constexpr std::uint64_t leastOfNumberInText = 2;

constexpr std::array<std::pair<std::string_view, std::uint64_t>, 16> numberSizes{{{"char", 1},
                                                                                  {"uchar", 1},
                                                                                  {"int8", 1},
                                                                                  {"uint8", 1},
                                                                                  {"short", 2},
                                                                                  {"ushort", 2},
                                                                                  {"int16", 2},
                                                                                  {"uint16", 2},
                                                                                  {"int", 4},
                                                                                  {"uint", 4},
                                                                                  {"int32", 4},
                                                                                  {"uint32", 4},
                                                                                  {"float", 4},
                                                                                  {"float32", 4},
                                                                                  {"double", 8},
                                                                                  {"float64", 8}}};

std::optional<std::uint64_t> sizeOfNumber(std::string_view type) {
  const auto *const found = std::find_if(numberSizes.begin(), numberSizes.end(),
                                         [&](const auto &known) { return known.first == type; });
  return found == numberSizes.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  constexpr std::string_view space = " \t\r";
  std::vector<std::string_view> found;
  for (;;) {
    const auto begin = line.find_first_not_of(space);
    if (begin == std::string_view::npos)
      return found;
    line.remove_prefix(begin);
    const auto end = std::min(line.find_first_of(space), line.size());
    found.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// Reads one line of a header after the other.
class HeaderReader {
public:
  /// Whether the line belongs into a header.
  bool take(const std::vector<std::string_view> &line) {
    if (line.front() == "comment" || line.front() == "obj_info")
      return true;
    if (line.front() == "format")
      return takeFormat(line);
    if (line.front() == "element")
      return takeElement(line);
    return line.front() == "property" && takeProperty(line);
  }

  /// What was read; nothing without a format.
  [[nodiscard]] std::optional<PlyHeader> header() {
    endElement();
    return m_hasFormat ? std::optional(m_header) : std::nullopt;
  }

private:
  bool takeFormat(const std::vector<std::string_view> &line) {
    if (line.size() != 3)
      return false;
    m_text = line[1] == "ascii";
    m_hasFormat = m_text || line[1] == "binary_little_endian" || line[1] == "binary_big_endian";
    return m_hasFormat;
  }

  bool takeElement(const std::vector<std::string_view> &line) {
    endElement();
    if (line.size() != 3)
      return false;
    const std::string_view count = line[2];
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), m_count);
    if (error == std::errc::result_out_of_range)
      m_count = largestCount;
    else if (error != std::errc{} || end != count.data() + count.size())
      return false;
    m_count = std::min(m_count, largestCount);
    m_isFace = line[1] == "face";
    if (m_isFace)
      m_header.faces = m_count;
    if (line[1] == "vertex")
      m_header.corners = m_count;
    return true;
  }

  bool takeProperty(const std::vector<std::string_view> &line) {
    const bool isList = line.size() == 5 && line[1] == "list";
    if (!isList && line.size() != 3)
      return false;
    const auto first = sizeOfNumber(line[isList ? 2 : 1]);
    const auto item = sizeOfNumber(line[isList ? 3 : 1]);
    if (!first || !item)
      return false;
    const bool isCorners = isList && m_isFace && line[4].starts_with("vertex_ind");
    const std::uint64_t items = isCorners ? cornersOfFace : 0;
    m_leastOfOne += m_text ? leastOfNumberInText * (1 + items) : *first + items * *item;
    return true;
  }

  void endElement() {
    const std::uint64_t content = m_header.leastContent + m_count * std::exchange(m_leastOfOne, 0);
    m_header.leastContent = std::min(content, mostLeastContent);
    m_count = 0;
  }

  PlyHeader m_header;
  std::uint64_t m_count = 0;      ///< of the element whose properties are being read
  std::uint64_t m_leastOfOne = 0; ///< bytes that one such element takes at least
  bool m_isFace = false;
  bool m_text = false;
  bool m_hasFormat = false;
};

Problem damaged(std::string_view line, int number) {
  return {words("The beginning of this PLY file is damaged: “{line}” does not belong there.",
                {{"line", shortened(line)}}),
          "", number, ""};
}

} // namespace

Result<PlyHeader> readPlyHeader(std::string_view head) {
  HeaderReader reader;
  std::size_t begin = 0;
  for (int number = 1;; ++number) {
    const auto end = head.find('\n', begin);
    if (end == std::string_view::npos)
      return Problem{words("The beginning of this PLY file has no end: “end_header” is missing."), "", 0, ""};
    const std::string_view line = head.substr(begin, end - begin);
    begin = end + 1;
    const auto found = wordsOf(line);
    if (found.empty() || (number == 1 && found.front() == "ply"))
      continue;
    if (found.front() == "end_header")
      break;
    if (!reader.take(found))
      return damaged(line, number);
  }
  auto header = reader.header();
  if (!header)
    return Problem{
        words("The beginning of this PLY file does not say whether numbers or text follow: the line "
              "“format” is missing."),
        "", 0, ""};
  header->bytes = begin;
  return *header;
}

} // namespace halfspace
