#include "lessons/construction/parts/triangle_shadow.h"

#include "lessons/object/drawing.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

/// The pieces that lead around the points; those without a length are left out.
void drawPieces(Figure &figure, const MarkBase &base, const std::vector<Place> &around) {
  for (std::size_t i = 0; i + 1 < around.size(); ++i)
    if (around[i] != around[i + 1]) {
      MarkBase piece = base;
      piece.id = partOf(base.id, i);
      figure.add(SegmentMark{std::move(piece), around[i], around[i + 1]});
    }
}

} // namespace

bool TriangleShadow::isFlat() const { return isZero(areaOf(corners)); }

TriangleShadow triangleShadow(const std::array<Shadow<Rational>, 3> &ofCorners) {
  TriangleShadow shadow;
  for (const Shadow<Rational> &corner : ofCorners) {
    shadow.corners.push_back(corner.place);
    shadow.falls = shadow.falls && corner.falls();
  }
  return shadow;
}

Word wordOf(const TriangleShadow &shadow) {
  if (!shadow.falls)
    return {"none", words("not whole")};
  return shadow.isFlat() ? Word{"flat", words("flat")} : Word{"triangle", words("a triangle")};
}

void drawTriangle(Figure &figure, const MarkBase &base, const std::vector<ExactVec3> &corners) {
  std::vector<Place> places;
  places.reserve(corners.size() + 1);
  for (const ExactVec3 &corner : corners)
    places.push_back(place(corner));
  if (!isZero(areaOf(corners))) {
    figure.add(PolygonMark{base, std::move(places)});
    return;
  }
  places.push_back(places.front());
  drawPieces(figure, base, places);
}

} // namespace halfspace
