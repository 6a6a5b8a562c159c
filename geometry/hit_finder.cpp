#include "geometry/hit_finder.h"

#include "geometry/decide.h"
#include "geometry/filter.h"

#include <embree3/rtcore.h>

#include <cassert>
#include <limits>
#include <vector>

namespace halfspace {
namespace {

using Floats = Vec3<float>;

/// By how much each box is made larger, as a share of the scene's half width. Coordinates in the tree are at
/// most a few half widths, so rounding a ray to floats and Embree's own arithmetic move it by less than a
/// 2^-20 of that.
constexpr double boxMargin = 0x1p-18;
/// Origins further off than so many half widths are not moved up to the scene in doubles: the move's own
/// rounding would use up the margin.
constexpr double farthestOrigin = 0x1p20;

struct Box {
  Vec3<double> low{std::numeric_limits<double>::infinity()};
  Vec3<double> high{-std::numeric_limits<double>::infinity()};

  void include(const Vec3<double> &point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
  }
};

Box boxOf(const Triangle<double> &triangle) {
  Box box;
  box.include(triangle.p0);
  box.include(triangle.p1);
  box.include(triangle.p2);
  return box;
}

/// The nearest of the hits that were offered so far; t is compared over fractions where doubles leave it
/// open.
class NearestSoFar {
public:
  /// `tame` tells whether all triangles are.
  NearestSoFar(const Ray<double> &ray, std::span<const Triangle<double>> triangles, bool tame)
      : m_ray(ray), m_tame(tame && isTame(ray)), m_triangles(triangles) {}

  /// Looks whether the ray hits a triangle, and takes it if it is nearer, or as near and of lower index.
  void offer(std::size_t index) {
    const Triangle<double> &triangle = m_triangles[index];
    if (m_tame) {
      const FilteredTriangle filtered = filterRayTriangle(m_ray, triangle);
      if (const auto which = surelyCaseOf(filtered)) {
        if (*which == RayTriangleCase::Hit)
          take(index, filtered.bounded.volume / filtered.bounded.sum);
        return;
      }
    }
    if (const auto exact = exactHit(m_ray, triangle)) {
      const double t = toDouble(*exact);
      take(index, {t, t * filterError});
    }
  }

  /// No hit beyond this t can become the nearest.
  [[nodiscard]] double reach() const { return m_t.value + m_t.error; }
  [[nodiscard]] std::optional<NearestHit> result() const {
    if (!m_index)
      return {};
    const bool precise = std::isfinite(m_t.value) && m_t.error <= hitPrecision * m_t.value;
    return NearestHit{*m_index, precise ? m_t.value : toDouble(exactT(m_ray, m_triangles[*m_index]))};
  }

private:
  void take(std::size_t index, const Bounded &t) {
    if (m_index && !isBefore(index, t))
      return;
    m_index = index;
    m_t = t;
  }

  [[nodiscard]] bool isBefore(std::size_t index, const Bounded &t) const {
    if (t.value + t.error < m_t.value - m_t.error)
      return true;
    if (t.value - t.error > m_t.value + m_t.error)
      return false;
    const Rational exact = exactT(m_ray, m_triangles[index]);
    const Rational best = exactT(m_ray, m_triangles[*m_index]);
    return exact < best || (exact == best && index < *m_index);
  }

  const Ray<double> &m_ray;
  bool m_tame;
  std::span<const Triangle<double>> m_triangles;
  std::optional<std::size_t> m_index;
  Bounded m_t{std::numeric_limits<double>::infinity(), 0};
};

/// A ray as Embree is asked with it: from a place near the scene, in floats, measured from the scene's
/// middle.
struct MovedRay {
  Floats origin;
  Floats direction;
  double start;   ///< t where it begins
  double perUnit; ///< t of the ray for a length of 1 in the tree
};

struct Question {
  RTCIntersectContext context; ///< first, so that Embree's pointer to it is one to this
  NearestSoFar *nearest;
  const MovedRay *moved;
};

} // namespace

struct HitFinder::Tree {
  explicit Tree(std::span<const Triangle<double>> given);
  Tree(const Tree &) = delete;
  Tree &operator=(const Tree &) = delete;
  ~Tree() {
    if (scene != nullptr)
      rtcReleaseScene(scene);
    if (device != nullptr)
      rtcReleaseDevice(device);
  }

  void setUp();
  [[nodiscard]] std::optional<MovedRay> move(const Ray<double> &ray) const;
  [[nodiscard]] RTCBounds boundsOf(std::size_t index) const;
  static void intersect(const RTCIntersectFunctionNArguments *arguments);

  std::vector<Triangle<double>> triangles;
  bool tame = true;
  Vec3<double> middle{};
  double halfWidth = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr; ///< null: there is nothing to ask Embree about, or it cannot be had
};

HitFinder::Tree::Tree(std::span<const Triangle<double>> given) : triangles(given.begin(), given.end()) {
  Box box;
  for (const Triangle<double> &triangle : triangles) {
    tame = tame && isTame(triangle);
    for (const Vec3<double> &corner : {triangle.p0, triangle.p1, triangle.p2})
      box.include(corner);
  }
  middle = (box.low + box.high) * 0.5;
  halfWidth = largestCoordinate(box.high - box.low) * 0.5;
  // Floats that are squared by Embree must not leave their range.
  constexpr double smallest = 0x1p-40;
  constexpr double largest = 0x1p40;
  if (smallest < halfWidth && halfWidth < largest)
    setUp();
}

void HitFinder::Tree::setUp() {
  device = rtcNewDevice(nullptr);
  if (device == nullptr)
    return;
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(triangles.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments *arguments) {
        *arguments->bounds_o =
            static_cast<const Tree *>(arguments->geometryUserPtr)->boundsOf(arguments->primID);
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
    rtcReleaseScene(scene);
    scene = nullptr;
  }
}

RTCBounds HitFinder::Tree::boundsOf(std::size_t index) const {
  const Box box = boxOf(triangles[index]);
  const double margin = boxMargin * halfWidth;
  const auto low = [&](double value, double center) { return static_cast<float>(value - center - margin); };
  const auto high = [&](double value, double center) { return static_cast<float>(value - center + margin); };
  RTCBounds bounds{};
  bounds.lower_x = low(box.low.x, middle.x);
  bounds.lower_y = low(box.low.y, middle.y);
  bounds.lower_z = low(box.low.z, middle.z);
  bounds.upper_x = high(box.high.x, middle.x);
  bounds.upper_y = high(box.high.y, middle.y);
  bounds.upper_z = high(box.high.z, middle.z);
  return bounds;
}

/// Nothing where the ray is so far off, or so short, that each triangle must be asked.
std::optional<MovedRay> HitFinder::Tree::move(const Ray<double> &ray) const {
  const Vec3<double> origin = ray.origin - middle;
  // A direction of subnormal length has no reciprocal.
  if (largestCoordinate(origin) > farthestOrigin * halfWidth ||
      largestCoordinate(ray.direction) < std::numeric_limits<double>::min())
    return {};
  // To where the ray comes into a ball around the scene, or a little before.
  // In half widths. The corners of the scene's box are √3 away from its middle, and twice that where the
  // middle could only be rounded to a corner.
  constexpr double ballRadius = 4;
  const double perUnit = 1 / largestCoordinate(ray.direction);
  const Vec3<double> direction = ray.direction * perUnit;
  const double nearest = -dot(origin, direction) / dot(direction, direction);
  const double start = std::max(0.0, nearest - ballRadius * halfWidth);
  return MovedRay{Floats(origin + direction * start), Floats(direction), start * perUnit, perUnit};
}

void HitFinder::Tree::intersect(const RTCIntersectFunctionNArguments *arguments) {
  // One ray at a time is asked: N is 1.
  const auto &tree = *static_cast<const Tree *>(arguments->geometryUserPtr);
  const auto &question = *reinterpret_cast<const Question *>(arguments->context);
  question.nearest->offer(arguments->primID);
  const double reach = (question.nearest->reach() - question.moved->start) / question.moved->perUnit;
  auto &ray = reinterpret_cast<RTCRayHit *>(arguments->rayhit)->ray;
  ray.tfar = std::min(ray.tfar, static_cast<float>(reach + boxMargin * tree.halfWidth));
}

HitFinder::HitFinder(std::span<const Triangle<double>> triangles)
    : m_tree(std::make_unique<const Tree>(triangles)) {}
HitFinder::HitFinder(HitFinder &&) noexcept = default;
HitFinder &HitFinder::operator=(HitFinder &&) noexcept = default;
HitFinder::~HitFinder() = default;

std::optional<NearestHit> HitFinder::find(const Ray<double> &ray) const {
  assert(!isZero(ray.direction));
  NearestSoFar nearest(ray, m_tree->triangles, m_tree->tame);
  const auto moved = m_tree->scene != nullptr ? m_tree->move(ray) : std::nullopt;
  if (!moved) {
    for (std::size_t i = 0; i < m_tree->triangles.size(); ++i)
      nearest.offer(i);
    return nearest.result();
  }
  Question question{{}, &nearest, &*moved};
  rtcInitIntersectContext(&question.context);
  RTCRayHit asked{};
  asked.ray.org_x = moved->origin.x;
  asked.ray.org_y = moved->origin.y;
  asked.ray.org_z = moved->origin.z;
  asked.ray.dir_x = moved->direction.x;
  asked.ray.dir_y = moved->direction.y;
  asked.ray.dir_z = moved->direction.z;
  asked.ray.tnear = 0;
  asked.ray.tfar = std::numeric_limits<float>::infinity();
  asked.ray.mask = std::numeric_limits<unsigned>::max();
  asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(m_tree->scene, &question.context, &asked);
  return nearest.result();
}

} // namespace halfspace
