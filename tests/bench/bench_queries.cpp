// One ray and one triangle, plane or sphere, and one point and one plane, with doubles: ours beside what
// others do.
#include "geometry/decide.h"
#include "geometry/quick_hit.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/vtk_segment.h"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/geometric.hpp>
#include <glm/gtx/intersect.hpp>

#ifdef HALFSPACE_BENCH_CGAL
#include <CGAL/Simple_cartesian.h>
#endif
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <cstdio>
#include <random>

namespace halfspace::bench {
namespace {

constexpr int rounds = 15;
constexpr std::size_t inputs = 100'000;
/// VTK's triangles are objects of a kilobyte each; as many as fit the cache well enough.
constexpr std::size_t vtkInputs = 2'000;

using Vector = Vec3<double>;

/// Seeded inputs. Every other ray is aimed at the inside of its triangle, and into its sphere.
struct Inputs {
  std::vector<Ray<double>> rays;
  std::vector<Triangle<double>> triangles;
  std::vector<PreparedTriangle<double>> prepared;
  std::vector<Plane<double>> planes;
  std::vector<Sphere<double>> spheres;
};

Inputs makeInputs() {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto vector = [&] { return Vector(unit(engine), unit(engine), unit(engine)) * 20.0 - 10.0; };
  Inputs all;
  for (std::size_t i = 0; i < inputs; ++i) {
    const Triangle<double> triangle{vector(), vector(), vector()};
    double s = unit(engine);
    double t = unit(engine);
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const Vector origin = vector();
    const Vector target = i % 2 == 0 ? pointOf(triangle, s, t) : vector();
    all.rays.push_back({origin, target - origin});
    all.triangles.push_back(triangle);
    all.prepared.push_back(prepare(triangle));
    all.planes.push_back(planeThrough(triangle.p0, triangle.p1, triangle.p2));
    all.spheres.push_back({i % 2 == 0 ? target : vector(), 1 + unit(engine)});
  }
  return all;
}

/// Does `each` for a number of inputs and adds up what it returns, so that nothing of it can be left out.
template <class Each> Contender contender(const char *name, std::size_t count, Each each) {
  return {name, count, [count, each] {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i)
              sum += each(i);
            return sum;
          }};
}
template <class Each> Contender contender(const char *name, Each each) {
  return contender(name, inputs, each);
}

// --- The plainly written peers

/// Möller and Trumbore, Fast, minimum storage ray–triangle intersection (1997), as it is usually written.
double mollerTrumbore(const Ray<double> &ray, const Triangle<double> &triangle) {
  constexpr double epsilon = 1e-12;
  const Vector edge1 = triangle.p1 - triangle.p0;
  const Vector edge2 = triangle.p2 - triangle.p0;
  const Vector h = glm::cross(ray.direction, edge2);
  const double a = glm::dot(edge1, h);
  if (a > -epsilon && a < epsilon)
    return 0;
  const double f = 1 / a;
  const Vector s = ray.origin - triangle.p0;
  const double u = f * glm::dot(s, h);
  if (u < 0 || u > 1)
    return 0;
  const Vector q = glm::cross(s, edge1);
  const double v = f * glm::dot(ray.direction, q);
  if (v < 0 || u + v > 1)
    return 0;
  const double t = f * glm::dot(edge2, q);
  return t >= 0 ? t : 0;
}

double plainRayPlane(const Ray<double> &ray, const Plane<double> &plane) {
  const double denominator = glm::dot(plane.normal, ray.direction);
  if (denominator == 0)
    return 0;
  const double t = -(glm::dot(plane.normal, ray.origin) + plane.offset) / denominator;
  return t >= 0 ? t : 0;
}

double plainRaySphere(const Ray<double> &ray, const Sphere<double> &sphere) {
  const Vector m = ray.origin - sphere.center;
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(m, ray.direction);
  const double c = glm::dot(m, m) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0)
    return 0;
  const double root = std::sqrt(discriminant);
  const double first = (-b - root) / a;
  const double second = (-b + root) / a;
  return first >= 0 ? first : second >= 0 ? second : 0;
}

double plainDistance(const Vector &point, const Plane<double> &plane) {
  return (glm::dot(plane.normal, point) + plane.offset) / glm::length(plane.normal);
}

// --- The races

#ifdef HALFSPACE_BENCH_CGAL
using Kernel = CGAL::Simple_cartesian<double>;

Kernel::Point_3 cgal(const Vector &v) { return {v.x, v.y, v.z}; }

struct CgalInputs {
  std::vector<Kernel::Ray_3> rays;
  std::vector<Kernel::Triangle_3> triangles;

  explicit CgalInputs(const Inputs &all) {
    for (std::size_t i = 0; i < inputs; ++i) {
      const auto &[p0, p1, p2] = all.triangles[i];
      rays.emplace_back(cgal(all.rays[i].origin), cgal(pointAt(all.rays[i], 1.0)));
      triangles.emplace_back(cgal(p0), cgal(p1), cgal(p2));
    }
  }
};
#endif

double vtkHit(vtkTriangle &triangle, const Ray<double> &ray) {
  VtkSegment ask(ray);
  const bool hit = triangle.IntersectWithLine(&ask.origin.x, &ask.end.x, 0, ask.t, &ask.point.x,
                                              &ask.parametric.x, ask.part) != 0;
  return hit ? ask.t : 0;
}

void raceTriangles(const Inputs &all) {
  std::vector<vtkNew<vtkTriangle>> vtkTriangles(vtkInputs);
  for (std::size_t i = 0; i < vtkInputs; ++i) {
    vtkTriangles[i]->GetPoints()->SetPoint(0, &all.triangles[i].p0.x);
    vtkTriangles[i]->GetPoints()->SetPoint(1, &all.triangles[i].p1.x);
    vtkTriangles[i]->GetPoints()->SetPoint(2, &all.triangles[i].p2.x);
  }
  std::vector<Contender> contenders{
      contender("Möller–Trumbore, written plainly",
                [&](auto i) { return mollerTrumbore(all.rays[i], all.triangles[i]); }),
      contender("ours, per-triangle values kept",
                [&](auto i) { return quickHit(all.rays[i], all.prepared[i]).t; }),
      contender("ours, nothing kept", [&](auto i) { return quickHit(all.rays[i], all.triangles[i]).t; }),
      contender("ours, the verdict certain",
                [&](auto i) { return double(decideRayTriangle(all.rays[i], all.triangles[i]).which); }),
      contender("ours, every number of the lesson",
                [&](auto i) { return intersectRayTriangle(all.rays[i], all.triangles[i]).plane.t; }),
      contender("GLM",
                [&](auto i) {
                  const auto &[p0, p1, p2] = all.triangles[i];
                  glm::dvec2 place;
                  double t = 0;
                  const auto &[origin, direction] = all.rays[i];
                  return glm::intersectRayTriangle(origin, direction, p0, p1, p2, place, t) ? t : 0;
                }),
      contender("VTK", vtkInputs, [&](auto i) { return vtkHit(*vtkTriangles[i], all.rays[i]); })};
#ifdef HALFSPACE_BENCH_CGAL
  const CgalInputs cgalInputs(all);
  contenders.push_back(contender("CGAL over doubles, yes or no", [&](auto i) {
    return CGAL::do_intersect(cgalInputs.rays[i], cgalInputs.triangles[i]) ? 1.0 : 0.0;
  }));
#endif
  race(contenders, rounds);
  print("ray and triangle, half of them hits", contenders);
  const double peer = contenders[0].nanoseconds;
  printGoal("values kept / Möller–Trumbore", contenders[1].nanoseconds / peer, 1.0);
  printGoal("nothing kept / Möller–Trumbore", contenders[2].nanoseconds / peer, 1.15);
  std::printf("  certainty costs %.2f ns a triangle\n",
              contenders[3].nanoseconds - contenders[2].nanoseconds);
}

void racePlanes(const Inputs &all) {
  std::vector<Contender> contenders{
      contender("written plainly: t alone",
                [&](auto i) { return plainRayPlane(all.rays[i], all.planes[i]); }),
      contender("ours, case, t and point",
                [&](auto i) {
                  const auto meet = intersectRayPlane(all.rays[i], all.planes[i]);
                  return meet.t + meet.point.x;
                }),
      contender("ours, the verdict certain",
                [&](auto i) { return double(decideRayPlane(all.rays[i], all.planes[i])); }),
      contender("GLM",
                [&](auto i) {
                  const auto &[origin, direction] = all.rays[i];
                  double t = 0;
                  return glm::intersectRayPlane(origin, direction, all.triangles[i].p0, all.planes[i].normal,
                                                t)
                             ? t
                             : 0;
                }),
      contender("VTK", [&](auto i) {
        Vector origin = all.rays[i].origin;
        Vector end = pointAt(all.rays[i], 1.0);
        Vector normal = all.planes[i].normal;
        Vector corner = all.triangles[i].p0;
        Vector point;
        double t = 0;
        vtkPlane::IntersectWithLine(&origin.x, &end.x, &normal.x, &corner.x, t, &point.x);
        return t + point.x;
      })};
  race(contenders, rounds);
  print("ray and plane", contenders);
}

void raceSpheres(const Inputs &all) {
  std::vector<Contender> contenders{
      contender("written plainly: t alone",
                [&](auto i) { return plainRaySphere(all.rays[i], all.spheres[i]); }),
      contender("ours, all contacts with their normals",
                [&](auto i) {
                  const auto meet = intersectRaySphere(all.rays[i], all.spheres[i]);
                  return meet.contacts == SphereContacts::None ? 0 : meet.along.front().t;
                }),
      contender("ours, the verdict certain",
                [&](auto i) { return double(decideRaySphere(all.rays[i], all.spheres[i]).which); }),
      contender("GLM, point and normal", [&](auto i) {
        const auto &[origin, direction] = all.rays[i];
        Vector point;
        Vector normal;
        const Vector unit = glm::normalize(direction);
        return glm::intersectRaySphere(origin, unit, all.spheres[i].center, all.spheres[i].radius, point,
                                       normal)
                   ? point.x
                   : 0;
      })};
  race(contenders, rounds);
  print("ray and sphere, half of them hits", contenders);
}

void racePoints(const Inputs &all) {
  std::vector<Contender> contenders{
      contender("written plainly: distance alone",
                [&](auto i) { return plainDistance(all.rays[i].origin, all.planes[i]); }),
      contender("ours, side, distance and foot",
                [&](auto i) {
                  const auto measured = measurePointPlane(all.rays[i].origin, all.planes[i]);
                  return measured.signedDistance + measured.foot.x;
                }),
      contender("ours, the side certain",
                [&](auto i) { return double(decidePointPlane(all.rays[i].origin, all.planes[i])); }),
      contender("VTK, unsigned distance", [&](auto i) {
        Vector point = all.rays[i].origin;
        Vector normal = glm::normalize(all.planes[i].normal);
        Vector corner = all.triangles[i].p0;
        return vtkPlane::DistanceToPlane(&point.x, &normal.x, &corner.x);
      })};
  race(contenders, rounds);
  print("point and plane", contenders);
}

} // namespace
} // namespace halfspace::bench

int main() {
  using namespace halfspace::bench;
  const Inputs all = makeInputs();
  raceTriangles(all);
  racePlanes(all);
  raceSpheres(all);
  racePoints(all);
}
