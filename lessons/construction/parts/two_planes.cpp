#include "lessons/construction/parts/two_planes.h"

#include "geometry/case_names.h"
#include "geometry/intersect_planes.h"
#include "geometry/project_vector.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {

CaseWords zeroNormalsWords(const PlaneTerms &first, const PlaneTerms &second) {
  return {std::string(nameOf(PlanePlaneCase::ZeroNormal)),
          words("The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
                {{"zero", plainText(isZero(vectorOf(first.n)) ? first.n : second.n)}}),
          true};
}

std::optional<TurnedPlane> turnedParallel(const PlaneObject &plane, const PlaneObject &other) {
  const ExactVec3 normal = projectVector(plane.normal, other.normal).projection;
  if (isZero(normal))
    return {};
  return TurnedPlane{{plane.point, normal},
                     evaluate(planeThrough(other.point, other.normal), plane.point) == 0};
}

PlaneObject slidInto(const PlaneObject &plane, const PlaneObject &parallel) {
  return {plane.point - projectVector(ExactVec3(plane.point - parallel.point), plane.normal).projection,
          plane.normal};
}

} // namespace halfspace
