// Conditions: what is to hold of the values that a construction comes to.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// One comparison of a named value with a number or a word.
struct Condition {
  enum class Relation { Equal, NotEqual, Less, LessOrEqual, Greater, GreaterOrEqual };
  std::string value; ///< its name
  Relation relation = Relation::Equal;
  std::string against; ///< a word, or a number as parseRational reads it
  bool operator==(const Condition &) const = default;
};

/// All of which are to hold.
using Conditions = std::vector<Condition>;

// As they are written down: is("case", "parallel"), both(is("location", "edge"), is("feature", "0")).
[[nodiscard]] inline Conditions is(std::string value, std::string_view against) {
  return {{std::move(value), Condition::Relation::Equal, std::string(against)}};
}
[[nodiscard]] inline Conditions isNot(std::string value, std::string_view against) {
  return {{std::move(value), Condition::Relation::NotEqual, std::string(against)}};
}
[[nodiscard]] inline Conditions both(Conditions some, const Conditions &others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

} // namespace halfspace
