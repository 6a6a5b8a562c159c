#include "lessons/triangle_words.h"

#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

/// By the opposite corner.
constexpr std::array<const char *, 3> edgeNames{"P₁P₂", "P₀P₂", "P₀P₁"};

} // namespace

std::string cornerName(int corner) {
  constexpr std::array<const char *, 3> names{"P₀", "P₁", "P₂"};
  return names.at(static_cast<std::size_t>(corner));
}

std::string placeWords(const TrianglePlace &place) {
  switch (place.location) {
  case TriangleLocation::Interior:
    return words("inside the triangle");
  case TriangleLocation::Edge:
    return words("on the edge {edge}", {{"edge", edgeNames.at(static_cast<std::size_t>(place.feature))}});
  case TriangleLocation::Vertex:
    return words("at the corner {corner}", {{"corner", cornerName(place.feature)}});
  case TriangleLocation::Outside:
    break;
  }
  return words("outside the triangle");
}

std::string locationName(TriangleLocation location) {
  switch (location) {
  case TriangleLocation::Interior:
    return "interior";
  case TriangleLocation::Edge:
    return "edge";
  case TriangleLocation::Vertex:
    return "vertex";
  case TriangleLocation::Outside:
    break;
  }
  return "outside";
}

} // namespace halfspace
