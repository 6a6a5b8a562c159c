#include "lessons/construction/parts/ray_at_plane.h"

#include "geometry/project_vector.h"
#include "lessons/object/drawing.h"

namespace halfspace {

RayPlane<Rational> meetingOf(const RayObject &ray, const PlaneObject &plane) {
  return intersectRayPlane(Ray<Rational>{ray.origin, ray.direction}, planeThrough(plane.point, plane.normal));
}

std::vector<Surd> facingOf(const PlaneObject &plane, const RayObject &ray) {
  if (!meetingOf(ray, plane).crosses())
    return {};
  const auto facing = facingNormal(plane.normal, ray.direction);
  return {facing.begin(), facing.end()};
}

void addMeeting(Figure &figure, const Given<RayObject> &ray, const Given<PlaneObject> &plane,
                const RayPlane<Rational> &meet, const Term &H) {
  if (meet.which == RayPlaneCase::InPlane)
    figure.reachWithin(plane.id, ray.id, place(ray.object.origin), unitOf(ray.object.direction));
  if (!meet.crosses())
    return;
  figure.reaches.push_back({plane.id, place(H)});
  addMeeting(figure, ray, H, meet.which == RayPlaneCase::Hit);
}

void addRaysAtPlane(const RayObject &ray, const PlaneObject &plane, const RayAtPlaneWords &sentences,
                    std::vector<SpecialCase> &all, const std::string &group) {
  const auto &[origin, direction] = ray;
  const ExactVec3 offPlane = projectVector(ExactVec3(origin - plane.point), plane.normal).projection;
  const bool startsInPlane = isZero(offPlane);
  const bool crosses = dot(direction, plane.normal) != 0;
  if (!startsInPlane)
    all.push_back({crosses ? is(group + "t", "0") : is(group + "case", "in-plane"),
                   crosses ? sentences.starts : sentences.lies, "L",
                   RayObject{origin - offPlane, direction}});
  if (const ExactVec3 turned = projectVector(direction, plane.normal).rejection; crosses && !isZero(turned))
    all.push_back({is(group + "case", startsInPlane ? "in-plane" : "parallel"),
                   startsInPlane ? sentences.lies : sentences.isParallel, "L", RayObject{origin, turned}});
}

} // namespace halfspace
