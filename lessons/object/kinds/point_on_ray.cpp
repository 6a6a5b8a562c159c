// Points that slide on a ray, from its start on.
#include "lessons/object/bound_point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

void settle(Object &bound) { bound[0].x = std::max(bound[0].x, Rational(0)); }

} // namespace

namespace object_kinds {

Kind point_on_ray() {
  return boundPoint(
      "point-on-ray", [] { return words("a point on a ray"); },
      "a point that slides on a ray: Q + λr with λ ≥ 0", {{"lambda", CoordinateRole::Number}}, settle,
      bindingByLambda(RayObject::kind));
}

} // namespace object_kinds
} // namespace halfspace
