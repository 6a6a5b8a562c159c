// What a PLY file says about itself at its beginning.
#pragma once

#include "lessons/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// The least content is told up to here.
inline constexpr std::uint64_t mostLeastContent = 1ULL << 62U;

enum class PlyForm { Text, LowestByteFirst, HighestByteFirst };

/// How a number stands in a file.
struct PlyNumber {
  std::string_view name; ///< of the type
  std::size_t bytes = 0; ///< in a binary file
  enum class Kind { Signed, Unsigned, Floating } kind = Kind::Signed;
};

/// A number that each element of a kind has, or a list of such numbers behind their count.
struct PlyProperty {
  std::string name;
  PlyNumber number;
  std::optional<PlyNumber> count; ///< of a list
};

/// So many things of a kind, each with the same properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::uint64_t bytes = 0; ///< of the header itself, its last line included
  PlyForm form = PlyForm::Text;
  std::vector<PlyElement> elements; ///< no two of a name
  /// What the elements that it announces take at least, up to `mostLeastContent`.
  std::uint64_t leastContent = 0;

  /// How many elements of a name there are.
  [[nodiscard]] std::uint64_t countOf(std::string_view name) const;
};

inline constexpr std::string_view plyCorner = "vertex";
inline constexpr std::string_view plyFace = "face";

/// Whether it is a face's list of the numbers of its corners.
[[nodiscard]] bool isListOfCorners(const PlyProperty &property);

/// Reads the header that a file begins with. A face is taken to have three corners at least.
[[nodiscard]] Result<PlyHeader> readPlyHeader(std::string_view head);

} // namespace halfspace
