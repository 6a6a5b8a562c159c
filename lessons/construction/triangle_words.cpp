#include "lessons/construction/triangle_words.h"

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

std::string placeWords(const FacePlace &place) {
  switch (place.location) {
  case FaceLocation::Interior:
    return words("inside the triangle");
  case FaceLocation::Edge:
    return words("on the edge {edge}", {{"edge", edgeNames.at(static_cast<std::size_t>(place.feature))}});
  case FaceLocation::Vertex:
    return words("at the corner {corner}", {{"corner", cornerName(place.feature)}});
  case FaceLocation::Outside:
    break;
  }
  return words("outside the triangle");
}

} // namespace halfspace
