// The sphere through four points.
#include "lessons/construction/parts/sphere_through.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PointObject> A;
  Given<PointObject> B;
  Given<PointObject> C;
  Given<PointObject> D;
};

struct Out : Computed<In>, SphereThrough {
  explicit Out(const In &objects)
      : Computed(objects),
        SphereThrough(objects, {termOf(objects.A), termOf(objects.B), termOf(objects.C), termOf(objects.D)}) {
  }
};

std::vector<SpecialCase> nearby(const Out &at) {
  const auto corner = flattenedCorner(at);
  if (!corner)
    return {};
  return {{is("det", "0"), words("The four points would lie in one plane."), "D", PointObject{*corner}}};
}

} // namespace

Construction circumsphere_points() {
  return taught<Out, PointObject, PointObject, PointObject, PointObject>(
      sphereThroughTeaching<Out>("circumsphere-points", {"A", "B", "C", "D"}, nearby));
}

} // namespace halfspace
