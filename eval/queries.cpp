#include "eval/queries.h"

#include "geometry/case_names.h"
#include "geometry/hit_all.h"
#include "geometry/intersect_line_plane.h"
#include "geometry/intersect_planes.h"
#include "geometry/intersect_ray_polygon.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "geometry/intersect_ray_triangle_plucker.h"
#include "geometry/point_plane.h"
#include "geometry/project_vector.h"
#include "geometry/relate_lines.h"

#include <algorithm>
#include <unordered_map>

namespace halfspace {
namespace {

// --- The queries

void plane(Operands &operands, Answer &answer) {
  const auto plane = operands.plane("plane");
  if (operands.fault())
    return;
  answer.numbers("coefficients", std::array{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
  answer.numbers("primitive", primitiveCoefficients(plane));
  answer.numbers("normalized", normalizedCoefficients(plane));
  answer.number("origin_distance", measurePointPlane(ExactVec3(), plane).signedDistance);
}

void pointPlane(Operands &operands, Answer &answer) {
  const auto point = operands.vector("point");
  const auto plane = operands.plane("plane");
  if (operands.fault())
    return;
  const auto measured = measurePointPlane(point, plane);
  answer.number("f", measured.f);
  answer.number("signed_distance", measured.signedDistance);
  answer.word("side", nameOf(measured.which));
  answer.vector("foot", measured.foot);
}

void projectVector(Operands &operands, Answer &answer) {
  const auto vector = operands.vector("vector");
  const auto onto = operands.direction("onto");
  if (operands.fault())
    return;
  const auto projected = halfspace::projectVector(vector, onto);
  answer.number("scalar", projected.scalar);
  answer.vector("projection", projected.projection);
  answer.vector("rejection", projected.rejection);
}

void rayPlane(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto plane = operands.plane("plane");
  if (operands.fault())
    return;
  const auto meet = intersectRayPlane(ray, plane);
  answer.word("case", nameOf(meet.which));
  answer.number("numerator", meet.numerator);
  answer.number("denominator", meet.denominator);
  if (!meet.crosses())
    return;
  answer.number("t", meet.t);
  answer.vector("point", meet.point);
  answer.numbers("facing_normal", facingNormal(plane.normal, ray.direction));
}

void addLocation(Answer &answer, const auto &location) {
  answer.word("location", nameOf(location.part));
  if (location.feature >= 0)
    answer.index("feature", static_cast<std::size_t>(location.feature));
}

void addPerps(Answer &answer, const RayTriangle<Rational> &meet) {
  answer.beginGroup("perp");
  answer.vector("u_perp", meet.perps.uPerp);
  answer.vector("v_perp", meet.perps.vPerp);
  answer.number("uu", meet.perps.uu);
  answer.number("uv", meet.perps.uv);
  answer.number("vv", meet.perps.vv);
  answer.number("wu", meet.wu);
  answer.number("wv", meet.wv);
  answer.number("denominator", meet.perps.denominator);
  answer.endGroup();
}

void addDeterminants(Answer &answer, const RayTriangleCramer<Rational> &meet) {
  answer.beginGroup("cramer");
  answer.number("det", meet.det);
  answer.number("det_sigma", meet.detSigma);
  answer.number("det_tau", meet.detTau);
  answer.number("det_t", meet.detT);
  answer.endGroup();
}

void rayTriangle(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto triangle = operands.triangle("triangle");
  if (operands.fault())
    return;
  const auto meet = intersectRayTriangle(ray, triangle);
  answer.word("case", nameOf(meet.which));
  if (meet.crosses()) {
    addLocation(answer, meet.location);
    answer.number("t", meet.plane.t);
    answer.vector("point", meet.plane.point);
    answer.number("s", meet.s);
    answer.number("t_triangle", meet.tTriangle);
    answer.numbers("barycentric",
                   std::array<Rational, 3>{1 - meet.s - meet.tTriangle, meet.s, meet.tTriangle});
    addPerps(answer, meet);
    addDeterminants(answer, intersectRayTriangleCramer(ray, triangle));
  }
  answer.beginGroup("plucker");
  answer.numbers("products", pluckerProducts(ray, triangle));
  answer.endGroup();
}

void raySphere(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto sphere = operands.sphere("sphere");
  if (operands.fault())
    return;
  const auto meet = intersectRaySphere(ray, sphere);
  answer.word("case", nameOf(meet.which));
  answer.word("contacts", nameOf(meet.contacts));
  answer.word("origin", nameOf(meet.origin));
  answer.number("discriminant", meet.discriminant);
  if (meet.along.empty())
    return;
  std::vector<Surd> t;
  std::vector<std::array<Surd, 3>> points;
  std::vector<std::array<Surd, 3>> normals;
  for (const auto &contact : meet.along) {
    t.push_back(contact.t);
    points.push_back(contact.point);
    normals.push_back(contact.normal);
  }
  answer.numbers("t", t);
  answer.vectors("points", points);
  answer.vectors("normals", normals);
}

void rayPolygon(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto polygon = operands.polygon("polygon");
  if (operands.fault())
    return;
  const auto meet = intersectRayPolygon(ray, std::span<const ExactVec3>(polygon));
  answer.word("case", nameOf(meet.which));
  if (meet.crosses()) {
    addLocation(answer, meet.location);
    answer.number("t", meet.t);
    answer.vector("point", meet.point);
  }
  answer.numbers("products", meet.products);
}

void raySolid(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto solid = operands.solid("solid");
  if (operands.fault())
    return;
  const auto meet = intersectRaySolid(ray, solid);
  answer.word("case", nameOf(meet.which));
  answer.word("contacts", nameOf(meet.contacts));
  answer.word("origin", nameOf(meet.origin));
  if (!meet.entered || !meet.left)
    return;
  const auto coordinates = [](const ExactVec3 &point) {
    return std::array<Surd, 3>{point.x, point.y, point.z};
  };
  answer.numbers("t", std::array{meet.entered->t, meet.left->t});
  answer.vectors("points", std::array{coordinates(meet.entered->point), coordinates(meet.left->point)});
  answer.indices("faces", std::array{meet.entered->face, meet.left->face});
}

void planePlane(Operands &operands, Answer &answer) {
  const auto first = operands.plane("plane");
  const auto second = operands.plane("plane2");
  if (operands.fault())
    return;
  const auto meet = intersectPlanes(first, second);
  answer.word("case", nameOf(meet.which));
  answer.number("cos_angle", meet.cosine);
  if (meet.which != PlanePlaneCase::Line)
    return;
  answer.vector("direction", meet.line.direction);
  answer.vector("moment", meet.line.moment);
  answer.vector("point", meet.nearest);
}

void line(Operands &operands, Answer &answer) {
  const auto line = operands.line("line");
  if (operands.fault())
    return;
  const bool real = isReal(line);
  answer.vector("direction", line.direction);
  answer.vector("moment", line.moment);
  answer.number("relation", relation(line));
  answer.truth("real", real);
  if (!real)
    return;
  answer.truth("through_origin", passesThroughOrigin(line));
  answer.vector("nearest_to_origin", nearestToOrigin(line));
}

void lineLine(Operands &operands, Answer &answer) {
  const auto first = operands.realLine("line");
  const auto second = operands.realLine("line2");
  if (operands.fault())
    return;
  const auto related = relateLines(first, second);
  answer.word("case", nameOf(related.which));
  answer.number("product", related.product);
  answer.truth("perpendicular", related.perpendicular);
  answer.number("distance", related.distance);
  if (related.which == LineLineCase::Intersecting)
    answer.vector("point", related.point);
}

void linePlane(Operands &operands, Answer &answer) {
  const auto line = operands.realLine("line");
  const auto plane = operands.plane("plane");
  if (operands.fault())
    return;
  const auto meet = intersectLinePlane(line, plane);
  answer.word("case", nameOf(meet.which));
  answer.numbers("homogeneous", std::array{meet.weighted.x, meet.weighted.y, meet.weighted.z, meet.weight});
  if (meet.which == LinePlaneCase::Point)
    answer.vector("point", meet.point);
}

void parametric(Operands &operands, Answer &answer) {
  const auto triangle = operands.triangle("triangle");
  const auto s = operands.number("s");
  const auto t = operands.number("t");
  if (operands.fault())
    return;
  answer.vector("point", pointOf(triangle, s, t));
  answer.word("location", nameOf(locationInTriangle(s, t).part));
  answer.truth("in_parallelogram", isInParallelogram(s, t));
}

void nearestHit(Operands &operands, Answer &answer) {
  const auto ray = operands.ray("ray");
  const auto triangles = operands.triangles("triangles");
  if (operands.fault())
    return;
  const auto all = hitAll(ray, std::span<const Triangle<Rational>>(triangles));
  answer.word("case", all.hits.empty() ? "miss" : "hit");
  if (!all.hits.empty()) {
    answer.index("index", all.hits.front().index);
    answer.number("t", all.hits.front().t);
    answer.vector("point", all.hits.front().point);
  }
  std::vector<std::size_t> order;
  for (const auto &hit : all.hits)
    order.push_back(hit.index);
  answer.indices("order", order);
  answer.indices("skipped", all.skipped);
}

} // namespace

Query findQuery(std::string_view name) {
  static const std::unordered_map<std::string_view, Query> queries{
      {"plane", plane},
      {"point-plane", pointPlane},
      {"project-vector", projectVector},
      {"ray-plane", rayPlane},
      {"ray-triangle", rayTriangle},
      {"ray-sphere", raySphere},
      {"ray-polygon", rayPolygon},
      {"ray-solid", raySolid},
      {"plane-plane", planePlane},
      {"line", line},
      {"line-line", lineLine},
      {"line-plane", linePlane},
      {"parametric", parametric},
      {"nearest-hit", nearestHit},
  };
  const auto found = queries.find(name);
  return found == queries.end() ? nullptr : found->second;
}

} // namespace halfspace
