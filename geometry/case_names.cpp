#include "geometry/case_names.h"

#include "geometry/bisect_planes.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/intersect_plane_sphere.h"
#include "geometry/intersect_planes.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/intersect_ray_polygon.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/intersect_segment_plane.h"
#include "geometry/intersect_three_planes.h"
#include "geometry/location.h"
#include "geometry/point_line.h"
#include "geometry/point_plane.h"
#include "geometry/relate_lines.h"

namespace halfspace {

// A case that is missing here does not compile.

std::string_view nameOf(BisectPlanesCase which) {
  switch (which) {
  case BisectPlanesCase::Crossing:
    return "crossing";
  case BisectPlanesCase::Irrational:
    return "irrational";
  case BisectPlanesCase::Parallel:
    return "parallel";
  case BisectPlanesCase::Coincident:
    return "coincident";
  case BisectPlanesCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(FacePart which) {
  switch (which) {
  case FacePart::Interior:
    return "interior";
  case FacePart::Edge:
    return "edge";
  case FacePart::Vertex:
    return "vertex";
  case FacePart::Outside:
    return "outside";
  }
  return {};
}

std::string_view nameOf(LineLineCase which) {
  switch (which) {
  case LineLineCase::Same:
    return "same";
  case LineLineCase::Opposite:
    return "opposite";
  case LineLineCase::Parallel:
    return "parallel";
  case LineLineCase::Intersecting:
    return "intersecting";
  case LineLineCase::Skew:
    return "skew";
  case LineLineCase::NotALine:
    return "not-a-line";
  }
  return {};
}

std::string_view nameOf(LinePlaneCase which) {
  switch (which) {
  case LinePlaneCase::Point:
    return "point";
  case LinePlaneCase::Parallel:
    return "parallel";
  case LinePlaneCase::InPlane:
    return "in-plane";
  case LinePlaneCase::NotALine:
    return "not-a-line";
  case LinePlaneCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(PlanePlaneCase which) {
  switch (which) {
  case PlanePlaneCase::Line:
    return "line";
  case PlanePlaneCase::Parallel:
    return "parallel";
  case PlanePlaneCase::Coincident:
    return "coincident";
  case PlanePlaneCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(PlaneSphereCase which) {
  switch (which) {
  case PlaneSphereCase::Circle:
    return "circle";
  case PlaneSphereCase::GreatCircle:
    return "great-circle";
  case PlaneSphereCase::Tangent:
    return "tangent";
  case PlaneSphereCase::Miss:
    return "miss";
  case PlaneSphereCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(PointLineCase which) {
  switch (which) {
  case PointLineCase::Off:
    return "off";
  case PointLineCase::On:
    return "on";
  case PointLineCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(PointPlaneCase which) {
  switch (which) {
  case PointPlaneCase::Positive:
    return "positive";
  case PointPlaneCase::Negative:
    return "negative";
  case PointPlaneCase::On:
    return "on";
  case PointPlaneCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(RayPlaneCase which) {
  switch (which) {
  case RayPlaneCase::Hit:
    return "hit";
  case RayPlaneCase::Behind:
    return "behind";
  case RayPlaneCase::Parallel:
    return "parallel";
  case RayPlaneCase::InPlane:
    return "in-plane";
  case RayPlaneCase::ZeroNormal:
    return "zero-normal";
  case RayPlaneCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(RayPolygonCase which) {
  switch (which) {
  case RayPolygonCase::Hit:
    return "hit";
  case RayPolygonCase::Miss:
    return "miss";
  case RayPolygonCase::Behind:
    return "behind";
  case RayPolygonCase::Parallel:
    return "parallel";
  case RayPolygonCase::InPlane:
    return "in-plane";
  case RayPolygonCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(RaySolidCase which) {
  switch (which) {
  case RaySolidCase::Hit:
    return "hit";
  case RaySolidCase::Behind:
    return "behind";
  case RaySolidCase::Miss:
    return "miss";
  case RaySolidCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(RaySphereCase which) {
  switch (which) {
  case RaySphereCase::Hit:
    return "hit";
  case RaySphereCase::Behind:
    return "behind";
  case RaySphereCase::Miss:
    return "miss";
  case RaySphereCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(RayTriangleCase which) {
  switch (which) {
  case RayTriangleCase::Hit:
    return "hit";
  case RayTriangleCase::Miss:
    return "miss";
  case RayTriangleCase::Behind:
    return "behind";
  case RayTriangleCase::Parallel:
    return "parallel";
  case RayTriangleCase::InPlane:
    return "in-plane";
  case RayTriangleCase::Coincident:
    return "coincident";
  case RayTriangleCase::Collinear:
    return "collinear";
  case RayTriangleCase::ZeroDirection:
    return "zero-direction";
  }
  return {};
}

std::string_view nameOf(SegmentPlaneCase which) {
  switch (which) {
  case SegmentPlaneCase::Crosses:
    return "crosses";
  case SegmentPlaneCase::Touches:
    return "touches";
  case SegmentPlaneCase::Beside:
    return "beside";
  case SegmentPlaneCase::Parallel:
    return "parallel";
  case SegmentPlaneCase::InPlane:
    return "in-plane";
  case SegmentPlaneCase::ZeroLength:
    return "zero-length";
  case SegmentPlaneCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

std::string_view nameOf(SolidContacts which) {
  switch (which) {
  case SolidContacts::None:
    return "none";
  case SolidContacts::One:
    return "one";
  case SolidContacts::Two:
    return "two";
  case SolidContacts::Along:
    return "along";
  }
  return {};
}

std::string_view nameOf(SolidLocation which) {
  switch (which) {
  case SolidLocation::Outside:
    return "outside";
  case SolidLocation::On:
    return "on";
  case SolidLocation::Inside:
    return "inside";
  }
  return {};
}

std::string_view nameOf(SphereContacts which) {
  switch (which) {
  case SphereContacts::None:
    return "none";
  case SphereContacts::Tangent:
    return "tangent";
  case SphereContacts::Two:
    return "two";
  }
  return {};
}

std::string_view nameOf(ThreePlanesCase which) {
  switch (which) {
  case ThreePlanesCase::Point:
    return "point";
  case ThreePlanesCase::Line:
    return "line";
  case ThreePlanesCase::Prism:
    return "prism";
  case ThreePlanesCase::Parallel:
    return "parallel";
  case ThreePlanesCase::Coincident:
    return "coincident";
  case ThreePlanesCase::ZeroNormal:
    return "zero-normal";
  }
  return {};
}

} // namespace halfspace
