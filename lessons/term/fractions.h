// How fractions are set.
#pragma once

#include <cstdint>

namespace halfspace {

/// Stacked, with a line between; or flat, 1/2, as among words, where taller ones would tear the lines apart.
enum class Fractions : std::uint8_t { Stacked, Flat };

} // namespace halfspace
