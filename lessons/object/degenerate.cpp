#include "lessons/object/degenerate.h"

#include "geometry/vector.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/segment.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {

std::string whyDegenerate(const Given<Object> &given) {
  const Object &object = given.object;
  const WordValues name{{"name", plainText(given.symbol)}};
  const std::string_view kind = kindOf(object);
  if (kind == PlaneObject::kind && isZero(object[1]))
    return words(
        "The normal of {name} is zero, so {name} is no plane. Through three points of one line there "
        "are many planes.",
        name);
  if ((kind == LineObject::kind || kind == RayObject::kind) && isZero(object[1]))
    return words("The direction of {name} is zero: {name} leads nowhere.", name);
  if (kind == SegmentObject::kind && object[0] == object[1])
    return words("Both ends of {name} are the same point.", name);
  if (kind == TriangleObject::kind && isZero(cross(object[1] - object[0], object[2] - object[0])))
    return words("All corners of {name} lie on one line.", name);
  return {};
}

} // namespace halfspace
