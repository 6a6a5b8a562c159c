// The nearest hit among 10^2 to 10^6 triangles: time to make ready, and for a ray, beside the libraries that
// do it.
#include "geometry/search/embree.h"
#include "geometry/search/hit_finder.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/vtk_segment.h"

#ifdef HALFSPACE_BENCH_CGAL
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#endif
#include <glm/geometric.hpp>
#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace halfspace::bench {
namespace {

using Vector = Vec3<double>;

constexpr int rounds = 5;
constexpr std::size_t rayCount = 20'000;
/// VTK takes fifty times as long; that many rays tell as much.
constexpr std::size_t vtkRayCount = 2'000;

/// A bumpy ball of about so many triangles around the origin.
struct Mesh {
  std::vector<Vector> points;
  std::vector<std::array<unsigned, 3>> corners;

  explicit Mesh(std::size_t count) {
    const auto rows = static_cast<unsigned>(std::sqrt(static_cast<double>(count) / 4)) + 1;
    const unsigned columns = 2 * rows;
    for (unsigned row = 0; row <= rows; ++row)
      for (unsigned column = 0; column < columns; ++column) {
        const double latitude = std::numbers::pi * row / rows;
        const double longitude = 2 * std::numbers::pi * column / columns;
        const double radius = 10 + std::sin(9 * latitude) * std::cos(7 * longitude);
        points.push_back(Vector(std::sin(latitude) * std::cos(longitude),
                                std::sin(latitude) * std::sin(longitude), std::cos(latitude)) *
                         radius);
      }
    for (unsigned row = 0; row < rows; ++row)
      for (unsigned column = 0; column < columns; ++column) {
        const unsigned a = row * columns + column;
        const unsigned b = row * columns + (column + 1) % columns;
        // At the poles one side of each cell has no length.
        if (row > 0)
          corners.push_back({a, b, a + columns});
        if (row + 1 < rows)
          corners.push_back({b, b + columns, a + columns});
      }
  }
};

/// From outside; about half of them hit.
std::vector<Ray<double>> makeRays() {
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return glm::normalize(Vector(normal(engine), normal(engine), normal(engine)));
  };
  std::vector<Ray<double>> rays;
  for (std::size_t i = 0; i < rayCount; ++i) {
    const Vector origin = direction() * 30.0;
    const Vector target = direction() * 14.0;
    rays.push_back({origin, glm::normalize(target - origin)});
  }
  return rays;
}

/// Adds up where the first `count` rays hit.
template <class Find>
Contender asker(const char *name, const std::vector<Ray<double>> &rays, std::size_t count, Find find) {
  return {name, count, [&rays, count, find] {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i)
              sum += find(rays[i]);
            return sum;
          }};
}

/// Embree as it is meant to be used: its own triangles in floats.
class EmbreeScene {
public:
  explicit EmbreeScene(const Mesh &mesh) : m_device(rtcNewDevice(nullptr)), m_scene(rtcNewScene(m_device)) {
    const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *vertices = static_cast<float *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.points.size()));
    for (const Vector &point : mesh.points)
      for (glm::length_t axis = 0; axis < 3; ++axis)
        *vertices++ = static_cast<float>(point[axis]);
    auto *indices = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.corners.size()));
    for (const auto &corners : mesh.corners)
      for (const unsigned corner : corners)
        *indices++ = corner;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(m_scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(m_scene);
  }
  EmbreeScene(const EmbreeScene &) = delete;
  EmbreeScene &operator=(const EmbreeScene &) = delete;
  ~EmbreeScene() {
    rtcReleaseScene(m_scene);
    rtcReleaseDevice(m_device);
  }

  [[nodiscard]] double find(const Ray<double> &ray) const {
    RTCRayHit asked{};
    asked.ray.org_x = static_cast<float>(ray.origin.x);
    asked.ray.org_y = static_cast<float>(ray.origin.y);
    asked.ray.org_z = static_cast<float>(ray.origin.z);
    asked.ray.dir_x = static_cast<float>(ray.direction.x);
    asked.ray.dir_y = static_cast<float>(ray.direction.y);
    asked.ray.dir_z = static_cast<float>(ray.direction.z);
    asked.ray.tfar = std::numeric_limits<float>::infinity();
    asked.ray.mask = std::numeric_limits<unsigned>::max();
    asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(asked);
    return asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 0 : asked.ray.tfar;
  }

private:
  void intersect(RTCRayHit &asked) const {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(m_scene, &asked);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(m_scene, &context, &asked);
#endif
  }

  RTCDevice m_device;
  RTCScene m_scene;
};

class VtkLocator {
public:
  explicit VtkLocator(const Mesh &mesh) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector &point : mesh.points)
      points->InsertNextPoint(&point.x);
    vtkNew<vtkCellArray> cells;
    for (const auto &[a, b, c] : mesh.corners)
      cells->InsertNextCell({vtkIdType(a), vtkIdType(b), vtkIdType(c)});
    m_data->SetPoints(points);
    m_data->SetPolys(cells);
    m_locator->SetDataSet(m_data);
    m_locator->BuildLocator();
  }

  double find(const Ray<double> &ray) {
    VtkSegment ask(ray);
    vtkIdType cell = 0;
    const bool hit = m_locator->IntersectWithLine(&ask.origin.x, &ask.end.x, 0, ask.t, &ask.point.x,
                                                  &ask.parametric.x, ask.part, cell, m_cell) != 0;
    return hit ? ask.t * VtkSegment::length : 0;
  }

private:
  vtkNew<vtkPolyData> m_data;
  vtkNew<vtkStaticCellLocator> m_locator;
  vtkNew<vtkGenericCell> m_cell;
};

#ifdef HALFSPACE_BENCH_CGAL
class CgalTree {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

public:
  explicit CgalTree(const Mesh &mesh) {
    for (const auto &[a, b, c] : mesh.corners)
      m_triangles.emplace_back(point(mesh.points[a]), point(mesh.points[b]), point(mesh.points[c]));
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
  }

  [[nodiscard]] double find(const Ray<double> &ray) const {
    const auto hit = m_tree.first_intersected_primitive(Kernel::Ray_3(
        point(ray.origin), Kernel::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z)));
    return hit ? 1 : 0;
  }

private:
  static Kernel::Point_3 point(const Vector &v) { return {v.x, v.y, v.z}; }

  Triangles m_triangles;
  Tree m_tree;
};
#endif

/// Of making something ready, once.
template <class Make> double milliseconds(Make make) {
  return nanosecondsOf([&] {
           make();
           return 0.0;
         }) /
         1e6;
}

/// Ours and Embree's time for a ray, in nanoseconds, and how much longer ours takes to be made ready.
struct Times {
  double ours;
  double embree;
  double readyRatio;
};

Times run(std::size_t count, const std::vector<Ray<double>> &rays) {
  const Mesh mesh(count);
  const TriangleMesh kept{mesh.points, mesh.corners}; // as the program keeps one
  std::optional<HitFinder> ours;
  std::optional<EmbreeScene> embree;
  std::optional<VtkLocator> vtk;
  const double oursReady = milliseconds([&] { ours.emplace(trianglesOf(kept)); });
  const double embreeReady = milliseconds([&] { embree.emplace(mesh); });
  std::printf("\n%zu triangles; made ready in ms: ours %.2f", kept.triangles.size(), oursReady);
  std::printf(", Embree %.2f", embreeReady);
  std::printf(", vtkStaticCellLocator %.2f", milliseconds([&] { vtk.emplace(mesh); }));
  std::vector<Contender> contenders{
      asker("Embree, floats", rays, rayCount, [&](const auto &ray) { return embree->find(ray); }),
      asker("ours, exact", rays, rayCount,
            [&](const auto &ray) {
              const auto hit = ours->find(ray);
              return hit ? hit->t : 0;
            }),
      asker("vtkStaticCellLocator", rays, vtkRayCount, [&](const auto &ray) { return vtk->find(ray); })};
#ifdef HALFSPACE_BENCH_CGAL
  std::optional<CgalTree> cgal;
  std::printf(", CGAL %.2f", milliseconds([&] { cgal.emplace(mesh); }));
  contenders.push_back(
      asker("CGAL's AABB tree, doubles", rays, rayCount, [&](const auto &ray) { return cgal->find(ray); }));
#endif
  race(contenders, rounds);
  print("for a ray, half of them hit", contenders);
  std::fflush(stdout);
  return {contenders[1].nanoseconds, contenders[0].nanoseconds, oursReady / embreeReady};
}

} // namespace
} // namespace halfspace::bench

int main() {
  using namespace halfspace::bench;
  const auto rays = makeRays();
  run(100, rays);
  const Times thousand = run(1'000, rays);
  run(10'000, rays);
  const Times hundredThousand = run(100'000, rays);
  const Times million = run(1'000'000, rays);
  std::printf("\n");
  printGoal("ours / Embree at 10^5 triangles", hundredThousand.ours / hundredThousand.embree, 1.3);
  printGoal("made ready, ours / Embree at 10^6 triangles", million.readyRatio, 1.2);
  printGoal("ours at 10^6 / at 10^3 triangles", million.ours / thousand.ours, 6.0);
}
