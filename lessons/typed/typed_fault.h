// What is wrong with a line that somebody has typed.
#pragma once

#include <cstddef>
#include <string>

namespace halfspace {

/// A sentence, and the bytes of the line that it is about.
struct TypedFault {
  std::string sentence;
  std::size_t at = 0;
  std::size_t length = 0; ///< 0: something is missing there
};

} // namespace halfspace
