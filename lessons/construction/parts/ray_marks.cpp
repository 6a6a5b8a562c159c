#include "lessons/construction/parts/ray_marks.h"

#include "lessons/object/drawing.h"

namespace halfspace {

void addWayTo(Figure &figure, const Given<RayObject> &ray, const Term &point, bool isAhead) {
  if (isAhead)
    figure.reaches.push_back({ray.id, place(point)});
  else
    figure.add(SegmentMark{
        {point->mark + "/backward", Role::Ghost, Subject::Ray}, place(ray.object.origin), place(point)});
}

void addMeeting(Figure &figure, const Given<RayObject> &ray, const Term &point, bool isAhead, bool isHit) {
  addWayTo(figure, ray, point, isAhead);
  figure.add(pointOf(point, isHit ? Role::Result : Role::Ghost, Subject::Ray));
}

} // namespace halfspace
