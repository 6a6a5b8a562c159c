// What the Plücker products of a ray with the edges of a face have in common.
#pragma once

#include "geometry/rational.h"

#include <cstdint>
#include <span>
#include <string>

namespace halfspace {

/// Products that are 0 go with both signs.
enum class ProductSigns : std::uint8_t { Same, Mixed, Zero };

[[nodiscard]] ProductSigns signsOf(std::span<const Rational> products);

/// For programs: same, mixed, zero.
[[nodiscard]] std::string nameOf(ProductSigns signs);

} // namespace halfspace
