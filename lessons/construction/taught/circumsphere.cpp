// The sphere through the corners of a tetrahedron.
#include "lessons/construction/parts/sphere_through.h"
#include "lessons/object/kinds/tetrahedron.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<TetrahedronObject> K;
};

struct Out : Computed<In>, SphereThrough {
  explicit Out(const In &objects) : Computed(objects), SphereThrough(objects, cornerTermsOf(objects.K)) {}
};

std::vector<SpecialCase> nearby(const Out &at) {
  const auto corner = flattenedCorner(at);
  if (!corner)
    return {};
  TetrahedronObject flat = at.in.K.object;
  flat.p3 = *corner;
  return {{is("det", "0"), words("The four corners would lie in one plane."), "K", flat}};
}

} // namespace

Construction circumsphere() {
  return taught<Out, TetrahedronObject>(sphereThroughTeaching<Out>("circumsphere", {"K"}, nearby));
}

} // namespace halfspace
