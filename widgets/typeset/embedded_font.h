// The fonts that the program carries with it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace halfspace {

/// The bytes of a font, which lie in the program itself. `name` is that of math_fonts.qrc.
[[nodiscard]] std::span<const std::byte> embeddedFont(const std::string &name);

} // namespace halfspace
