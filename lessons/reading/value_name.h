// Names of values, as lessons write them.
#pragma once

#include <string_view>

namespace halfspace {

/// Whether the text is shaped like a value's name: letters, digits, `_`, `-`, parts joined by dots.
[[nodiscard]] bool isValueName(std::string_view text);

} // namespace halfspace
