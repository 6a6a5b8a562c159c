#include "lessons/construction/parts/spanned_box.h"

#include "lessons/object/drawing.h"

namespace halfspace {

void addParallelogram(Figure &figure, const MarkBase &base, const ExactVec3 &from, const ExactVec3 &first,
                      const ExactVec3 &second) {
  if (!isZero(cross(first, second)))
    figure.add(PolygonMark{base,
                           {place(from), place(ExactVec3(from + first)),
                            place(ExactVec3(from + first + second)), place(ExactVec3(from + second))}});
}

void addSpannedBox(Figure &figure, const MarkBase &base, const ExactVec3 &corner,
                   const std::array<ExactVec3, 3> &sides) {
  const std::size_t before = figure.marks.size();
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const ExactVec3 &from : {corner, ExactVec3(corner + sides.at((i + 2) % 3))}) {
      MarkBase face = base;
      face.id = partOf(base.id, figure.marks.size() - before);
      addParallelogram(figure, face, from, sides.at(i), sides.at((i + 1) % 3));
    }
}

} // namespace halfspace
