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

using Kind = PlyNumber::Kind;
constexpr std::array<PlyNumber, 16> numbers{{{"char", 1, Kind::Signed},
                                             {"uchar", 1, Kind::Unsigned},
                                             {"int8", 1, Kind::Signed},
                                             {"uint8", 1, Kind::Unsigned},
                                             {"short", 2, Kind::Signed},
                                             {"ushort", 2, Kind::Unsigned},
                                             {"int16", 2, Kind::Signed},
                                             {"uint16", 2, Kind::Unsigned},
                                             {"int", 4, Kind::Signed},
                                             {"uint", 4, Kind::Unsigned},
                                             {"int32", 4, Kind::Signed},
                                             {"uint32", 4, Kind::Unsigned},
                                             {"float", 4, Kind::Floating},
                                             {"float32", 4, Kind::Floating},
                                             {"double", 8, Kind::Floating},
                                             {"float64", 8, Kind::Floating}}};

std::optional<PlyNumber> numberOf(std::string_view type) {
  const auto *const found = std::find_if(numbers.begin(), numbers.end(),
                                         [&](const PlyNumber &known) { return known.name == type; });
  return found == numbers.end() ? std::nullopt : std::optional(*found);
}

std::optional<PlyForm> formOf(std::string_view word) {
  if (word == "ascii")
    return PlyForm::Text;
  if (word == "binary_little_endian")
    return PlyForm::LowestByteFirst;
  return word == "binary_big_endian" ? std::optional(PlyForm::HighestByteFirst) : std::nullopt;
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
    if (!m_hasFormat)
      return {};
    for (const PlyElement &element : m_header.elements)
      m_header.leastContent =
          std::min(m_header.leastContent + element.count * leastOfOne(element), mostLeastContent);
    return std::move(m_header);
  }

private:
  bool takeFormat(const std::vector<std::string_view> &line) {
    const auto form = line.size() == 3 ? formOf(line[1]) : std::nullopt;
    m_hasFormat = form.has_value();
    m_header.form = form.value_or(PlyForm::Text);
    return m_hasFormat;
  }

  bool takeElement(const std::vector<std::string_view> &line) {
    if (line.size() != 3 || isKnown(line[1]))
      return false;
    const std::string_view text = line[2];
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error == std::errc::result_out_of_range)
      count = largestCount;
    else if (error != std::errc{} || end != text.data() + text.size())
      return false;
    m_header.elements.push_back({std::string(line[1]), std::min(count, largestCount), {}});
    return true;
  }

  [[nodiscard]] bool isKnown(std::string_view name) const {
    const auto &all = m_header.elements;
    return std::any_of(all.begin(), all.end(), [&](const PlyElement &one) { return one.name == name; });
  }

  bool takeProperty(const std::vector<std::string_view> &line) {
    const bool isList = line.size() == 5 && line[1] == "list";
    if (m_header.elements.empty() || (!isList && line.size() != 3))
      return false;
    const auto count = isList ? numberOf(line[2]) : std::nullopt;
    const auto number = numberOf(line[isList ? 3 : 1]);
    if (!number || (isList && !count))
      return false;
    m_header.elements.back().properties.push_back({std::string(line.back()), *number, count});
    return true;
  }

  /// The bytes that an element takes at least.
  [[nodiscard]] std::uint64_t leastOfOne(const PlyElement &element) const {
    std::uint64_t least = 0;
    for (const PlyProperty &property : element.properties) {
      const bool isCorners = element.name == plyFace && isListOfCorners(property);
      const std::uint64_t items = !property.count ? 1 : isCorners ? cornersOfFace : 0;
      least += m_header.form == PlyForm::Text
                   ? leastOfNumberInText * (items + (property.count ? 1 : 0))
                   : items * property.number.bytes + (property.count ? property.count->bytes : 0);
    }
    return least;
  }

  PlyHeader m_header;
  bool m_hasFormat = false;
};

Problem damaged(std::string_view line, int number) {
  return {words("The beginning of this PLY file is damaged: “{line}” does not belong there.",
                {{"line", shortened(line)}}),
          "", number, ""};
}

} // namespace

std::uint64_t PlyHeader::countOf(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement &element) { return element.name == name; });
  return found == elements.end() ? 0 : found->count;
}

bool isListOfCorners(const PlyProperty &property) {
  return property.count && property.name.starts_with("vertex_ind");
}

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
