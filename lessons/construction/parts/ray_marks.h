// A ray and what its line meets, as all figures draw it.
#pragma once

#include "lessons/figure/figure.h"
#include "lessons/object/kinds/ray.h"

namespace halfspace {

/// The ray drawn up to a point of its line; where the point lies behind the start, a ghost of the way there.
void addWayTo(Figure &figure, const Given<RayObject> &ray, const Term &point, bool isAhead);

/// The same with the point, which is the result where the ray hits.
void addMeeting(Figure &figure, const Given<RayObject> &ray, const Term &point, bool isAhead, bool isHit);
inline void addMeeting(Figure &figure, const Given<RayObject> &ray, const Term &point, bool isHit) {
  addMeeting(figure, ray, point, isHit, isHit);
}

} // namespace halfspace
