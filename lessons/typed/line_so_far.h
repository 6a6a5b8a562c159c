// A typed line up to where its cursor stands.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace halfspace {

/// What stands before the cursor. Parts are those of the line, which must outlive it.
struct LineSoFar {
  std::string_view name; ///< that the line begins with; empty for none
  /// Where what the name stands for begins; nothing where no = or : is there yet.
  std::optional<std::size_t> contentAt{};
  /// In front of the innermost bracket that is open at the cursor; empty for none.
  std::string_view called{};
  std::size_t argumentsAt = 0;             ///< behind that bracket
  std::vector<std::string_view> arguments; ///< that are complete within it
  /// Where the word begins that the cursor stands behind; the cursor itself where it is behind none.
  std::size_t wordAt = 0;
  std::size_t cursor = 0;

  /// Whether nothing stands between the name's sign and the word at the cursor.
  [[nodiscard]] bool isAtContent() const { return contentAt == wordAt; }
};

/// The cursor is a byte of the line, or its end. A comma between digits belongs to a number where it is the
/// decimal mark.
[[nodiscard]] LineSoFar lineSoFar(std::string_view line, std::size_t cursor, char decimalMark = '.');

} // namespace halfspace
