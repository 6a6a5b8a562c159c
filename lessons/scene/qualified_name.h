// Names of what the entries of a scene have: `distance.f`, or f alone.
#pragma once

#include <string_view>

namespace halfspace {

/// A name with the entry apart that it says whose it is. Both are parts of the name that was taken apart.
struct QualifiedName {
  std::string_view entry; ///< empty where the name leaves it out
  std::string_view own;   ///< within the entry: f; it may have parts itself, as perp.uu
};

/// The first dot parts the two: entries have none in their names.
[[nodiscard]] constexpr QualifiedName qualified(std::string_view name) {
  const auto dot = name.find('.');
  return dot == std::string_view::npos ? QualifiedName{{}, name}
                                       : QualifiedName{name.substr(0, dot), name.substr(dot + 1)};
}

} // namespace halfspace
