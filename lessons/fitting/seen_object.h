// Objects of a scene as others look at them.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// An object that an entry is or makes, and the word of the kind that others look at: a bound object is a
/// point.
struct SeenObject {
  std::string id;
  std::string_view kind;
};

} // namespace halfspace
