#include "lessons/construction/parts/two_vectors.h"

#include "geometry/project_vector.h"
#include "lessons/object/drawing.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {

void drawMoved(Figure &figure, const std::string &leader, const Place &from,
               const Given<VectorObject> &moved) {
  if (from != place(moved.object.start))
    figure.add(
        inLook(moved.look, ArrowMark{{leader + "/moved", Role::Ghost}, from, place(moved.object.vector)}));
}

PolygonMark parallelogramOf(std::string id, const Term &area, const Place &from, const Place &first,
                            const Place &second) {
  MarkBase base{std::move(id), Role::Helper, Subject::Plane, latexOf(area)};
  base.numbers = relatedLatex(calculated(area));
  return {std::move(base), {from, from + first, from + first + second, from + second}};
}

void addHeight(Figure &figure, const Term &height, const Place &from, const ExactVec3 &u,
               const ExactVec3 &v) {
  const double along = toDouble(Rational(dot(u, v) / dot(u, u))); // to the foot, in lengths of u
  const Place tip = from + place(v);
  const Place foot = from + along * place(u);
  figure.add(SegmentMark{drawn(height, Role::Derived, Subject::Measure), tip, foot});
  figure.add(
      RightAngleMark{{height->mark + "/angle", Role::Helper, Subject::Measure}, foot, place(u), tip - foot});
  if (along < 0 || along > 1)
    figure.add(SegmentMark{
        {height->mark + "/base", Role::Helper, Subject::Measure}, along < 0 ? from : from + place(u), foot});
}

std::vector<SpecialCase> turnedNearby(const Given<VectorObject> &first, const Given<VectorObject> &second,
                                      const std::string &role, TurnedConditions conditions) {
  const auto parts = projectVector(second.object.vector, first.object.vector);
  if (isZero(parts.projection) || isZero(parts.rejection))
    return {};
  const WordValues both{{"first", plainText(termOf(first))}, {"second", plainText(termOf(second))}};
  const ExactVec3 &start = second.object.start;
  return {{std::move(conditions.perpendicular), words("{first} and {second} would be perpendicular.", both),
           role, VectorObject{start, parts.rejection}},
          {std::move(conditions.onOneLine), words("{first} and {second} would lie along one line.", both),
           role, VectorObject{start, parts.projection}}};
}

} // namespace halfspace
