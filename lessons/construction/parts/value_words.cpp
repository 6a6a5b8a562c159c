#include "lessons/construction/parts/value_words.h"

#include "geometry/case_names.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_plane.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

// A case that is missing here does not compile.

std::string readingOf(PointPlaneCase side) {
  switch (side) {
  case PointPlaneCase::Positive:
    return words("positive");
  case PointPlaneCase::Negative:
    return words("negative");
  case PointPlaneCase::On:
    return words("in the plane");
  case PointPlaneCase::ZeroNormal:
    return words("there is no plane");
  }
  return {};
}

std::string readingOf(RayPlaneCase which) {
  switch (which) {
  case RayPlaneCase::Hit:
    return words("hit");
  case RayPlaneCase::Behind:
    return words("behind the start");
  case RayPlaneCase::Parallel:
    return words("parallel");
  case RayPlaneCase::InPlane:
    return words("in the plane");
  case RayPlaneCase::ZeroNormal:
    return words("there is no plane");
  case RayPlaneCase::ZeroDirection:
    return words("there is no ray");
  }
  return {};
}

std::string readingOf(RayTriangleCase which) {
  switch (which) {
  case RayTriangleCase::Hit:
    return words("hit");
  case RayTriangleCase::Miss:
    return words("missed");
  case RayTriangleCase::Behind:
    return words("behind the start");
  case RayTriangleCase::Parallel:
    return words("parallel");
  case RayTriangleCase::InPlane:
    return words("in the plane");
  case RayTriangleCase::Coincident:
    return words("corners that are one point");
  case RayTriangleCase::Collinear:
    return words("corners on one line");
  case RayTriangleCase::ZeroDirection:
    return words("there is no ray");
  }
  return {};
}

std::string readingOf(FacePart part) {
  switch (part) {
  case FacePart::Interior:
    return words("interior");
  case FacePart::Edge:
    return words("edge");
  case FacePart::Vertex:
    return words("corner");
  case FacePart::Outside:
    return words("outside");
  }
  return {};
}

std::string readingOf(SolidLocation place) {
  switch (place) {
  case SolidLocation::Outside:
    return words("outside");
  case SolidLocation::On:
    return words("on the surface");
  case SolidLocation::Inside:
    return words("inside");
  }
  return {};
}

std::string readingOf(SolidContacts contacts) {
  switch (contacts) {
  case SolidContacts::None:
    return words("none");
  case SolidContacts::One:
    return words("one");
  case SolidContacts::Two:
    return words("two");
  case SolidContacts::Along:
    return words("all along the surface");
  }
  return {};
}

std::string readingOf(SphereContacts contacts) {
  switch (contacts) {
  case SphereContacts::None:
    return words("none");
  case SphereContacts::Tangent:
    return words("one, where it touches");
  case SphereContacts::Two:
    return words("two");
  }
  return {};
}

template <class Case> Word wordFor(Case which) { return {std::string(nameOf(which)), readingOf(which)}; }

} // namespace

Word yesOrNo(bool holds) { return holds ? Word{"yes", words("yes")} : Word{"no", words("no")}; }

Word trueOrFalse(bool holds) { return {holds ? "true" : "false", yesOrNo(holds).read}; }

Word noneOfThem() { return {"none", words("none")}; }

Word severalOfThem() { return {"several", words("several")}; }

Word wordOf(PointPlaneCase side) { return wordFor(side); }
Word wordOf(RayPlaneCase which) { return wordFor(which); }
Word wordOf(RayTriangleCase which) { return wordFor(which); }
Word wordOf(FacePart part) { return wordFor(part); }
Word wordOf(SolidLocation place) { return wordFor(place); }
Word wordOf(SolidContacts contacts) { return wordFor(contacts); }
Word wordOf(SphereContacts contacts) { return wordFor(contacts); }

} // namespace halfspace
