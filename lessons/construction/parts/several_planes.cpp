#include "lessons/construction/parts/several_planes.h"

#include "geometry/case_names.h"
#include "geometry/point_plane.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {

Plane<Rational> planeOf(const PlaneObject &plane) { return planeThrough(plane.point, plane.normal); }

Term constantOf(const Given<PlaneObject> &plane) {
  const PlaneTerms terms = termsOf(plane);
  return name(besideLettersOf(plane, letter("d")), planeOf(plane.object).offset)
      .standingFor(-dot(terms.n, terms.P0));
}

WorkingLine givenConstantLine(const Given<PlaneObject> &plane) {
  const PlaneTerms terms = termsOf(plane);
  return asked(
      withProducts(constantOf(plane) == -dot(terms.n, terms.P0)),
      words("The constant d of {plane}: its equation is n·P + d = 0.", {{"plane", plainText(plane.symbol)}}));
}

CaseWords zeroNormalAmong(const std::vector<Term> &normals) {
  const auto zero = std::find_if(normals.begin(), normals.end(),
                                 [](const Term &normal) { return isZero(vectorOf(normal)); });
  return {std::string(nameOf(PointPlaneCase::ZeroNormal)),
          words("The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
                {{"zero", plainText(*zero)}}),
          true};
}

} // namespace halfspace
