// The names of what a construction can come to, in any of its cases: what lessons may ask for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace halfspace {

/// What a value is: a number, a list of numbers, a word, an index counted from 0, a group of values.
enum class ValueShape : std::uint8_t { Number, List, Word, Index, Group };

/// A value that a construction has in at least one of its cases.
struct ValueName {
  std::string name;
  ValueShape shape = ValueShape::Number;
  std::size_t length = 1;           ///< of a list: its most entries
  std::vector<std::string> words{}; ///< all that a word can be
  std::vector<ValueName> members{}; ///< of a group
};

namespace named {
[[nodiscard]] inline ValueName number(std::string name) { return {std::move(name)}; }
[[nodiscard]] inline ValueName list(std::string name, std::size_t length) {
  return {std::move(name), ValueShape::List, length};
}
/// A point or a vector.
[[nodiscard]] inline ValueName vector(std::string name) { return list(std::move(name), 3); }
[[nodiscard]] inline ValueName word(std::string name, std::vector<std::string> words) {
  return {std::move(name), ValueShape::Word, 1, std::move(words)};
}
[[nodiscard]] inline ValueName index(std::string name) { return {std::move(name), ValueShape::Index}; }
[[nodiscard]] inline ValueName group(std::string name, std::vector<ValueName> members) {
  return {std::move(name), ValueShape::Group, 1, {}, std::move(members)};
}
} // namespace named

/// All names of a construction. The contract test holds them against what it comes to.
struct ConstructionNames {
  std::vector<std::string> cases;
  std::vector<ValueName> values; ///< their own names; as in the eval format
  std::vector<std::string> lines;
  std::vector<std::string> marks; ///< its own, without those that accompany another
};

} // namespace halfspace
