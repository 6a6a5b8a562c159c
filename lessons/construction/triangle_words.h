// Places of a triangle by name.
#pragma once

#include "geometry/triangle.h"

#include <string>

namespace halfspace {

/// P₀, P₁ or P₂.
[[nodiscard]] std::string cornerName(int corner);

/// Where in the triangle, for people: inside the triangle, on the edge P₀P₁ …
[[nodiscard]] std::string placeWords(const FacePlace &place);

} // namespace halfspace
