// What the Plücker products of a ray with the edges of a face have in common.
#pragma once

#include "lessons/construction/taught.h"

#include <cstdint>
#include <span>

namespace halfspace {

/// Products that are 0 go with both signs.
enum class ProductSigns : std::uint8_t { Same, Mixed, Zero };

[[nodiscard]] ProductSigns signsOf(std::span<const Rational> products);

/// same, mixed, zero
[[nodiscard]] Word wordOf(ProductSigns signs);

/// The value that says it.
template <class Out> [[nodiscard]] ValueRow<Out> signsRow(ProductSigns (*signs)(const Out &)) {
  return {named::word("signs", {"same", "mixed", "zero"}), always,
          [signs](const Out &at) { return ToldValue(words("signs"), wordOf(signs(at))); }};
}

} // namespace halfspace
