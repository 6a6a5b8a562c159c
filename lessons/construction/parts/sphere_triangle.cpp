#include "lessons/construction/parts/sphere_triangle.h"

#include "lessons/object/drawing.h"
#include "lessons/term/latex.h"

namespace halfspace {
namespace {

bool hasLength(const Term &side) { return sign(*numberOf(side)) != 0; }

} // namespace

void drawSphereTriangle(Figure &figure, const SphereTriangle &triangle, const std::optional<Place> &common) {
  const auto &[center, nearest, height, base, radius, radiusMark] = triangle;
  const Place from = place(center);
  const Place middle = place(nearest);
  if (hasLength(height))
    figure.add(SegmentMark{drawn(height, Role::Derived, Subject::Measure), from, middle});
  if (!common)
    return;
  figure.add(SegmentMark{{radiusMark, Role::Derived, Subject::Triangle, latexOf(radius)}, from, *common});
  if (!hasLength(base))
    return;
  figure.add(SegmentMark{drawn(base, Role::Result, Subject::Measure), middle, *common});
  if (hasLength(height))
    figure.add(RightAngleMark{
        {base->mark + "/angle", Role::Helper, Subject::Measure}, middle, from - middle, *common - middle});
}

} // namespace halfspace
