// What constructions of a ray and a plane share.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/special_case.h"
#include "lessons/object/kinds/plane.h"

#include <string>
#include <vector>

namespace halfspace {

/// Where a ray meets a plane object.
[[nodiscard]] RayPlane<Rational> meetingOf(const RayObject &ray, const PlaneObject &plane);

/// The unit normal towards where the ray comes from; nothing where the ray does not cross the plane.
[[nodiscard]] std::vector<Surd> facingOf(const PlaneObject &plane, const RayObject &ray);

/// The ray and the plane drawn as far as the point H where they meet, with it; and the plane as far as a ray
/// that lies in it.
void addMeeting(Figure &figure, const Given<RayObject> &ray, const Given<PlaneObject> &plane,
                const RayPlane<Rational> &meet, const Term &H);

/// What is said of a ray that would start in the plane, lie in it, or run parallel to it.
struct RayAtPlaneWords {
  std::string starts;
  std::string lies;
  std::string isParallel;
};

/// Adds the ray moved along the normal to start in the plane, and turned to run along it: the role L.
/// Requires a direction and a normal ≠ 0. `group` stands before the names of the values t and case.
void addRaysAtPlane(const RayObject &ray, const PlaneObject &plane, const RayAtPlaneWords &sentences,
                    std::vector<SpecialCase> &all, const std::string &group = {});

} // namespace halfspace
