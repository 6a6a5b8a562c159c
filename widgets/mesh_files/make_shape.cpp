#include "widgets/mesh_files/make_shape.h"

#include "geometry/bounding_box.h"
#include "geometry/decide.h"
#include "geometry/search/make_hit_search.h"
#include "lessons/words.h"
#include "widgets/mesh_files/numbering.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace halfspace {
namespace {

using TriangleCorners = std::array<std::uint32_t, 3>;

/// Every so many items it is told how far they are, and asked whether to go on.
constexpr std::size_t itemsBetween = 1U << 16U;

/// Which part of the time each step takes; by measurement. The rest makes the search.
constexpr double untilChecked = 0.03;
constexpr double untilMerged = 0.2;
constexpr double untilSorted = 0.33;

Problem problemOf(std::string sentence) { return {std::move(sentence), "", 0, ""}; }

bool isFinite(const Vec3<float> &corner) {
  return std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z);
}

/// Where corners go: numbers of steps from an origin, which fit 21 bits each.
class Grid {
public:
  using Key = Numbering<1>::Key;

  explicit Grid(const BoundingBox &box)
      : m_origin((box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, box.low.z) {
    int exponent = 0; // of the power of two above the longest side, or as large
    if (std::frexp(box.longestSide(), &exponent) == 0.5)
      --exponent;
    m_exponent = exponent - meshGridBits;
  }

  [[nodiscard]] Key keyOf(const Vec3<float> &corner) const {
    const auto steps = [&](int axis) {
      const double away = static_cast<double>(corner[axis]) - m_origin[axis];
      return static_cast<std::uint64_t>(std::llround(std::ldexp(away, -m_exponent)) + half);
    };
    return {steps(0) << (2 * bits) | steps(1) << bits | steps(2)};
  }
  [[nodiscard]] Vec3<double> placeOf(const Key &key) const {
    const auto coordinate = [&](unsigned shift) {
      const auto steps = static_cast<std::int64_t>(key[0] >> shift & mask) - half;
      return std::ldexp(static_cast<double>(steps), m_exponent);
    };
    return {coordinate(2 * bits), coordinate(bits), coordinate(0)};
  }

private:
  // From −2^19 to 2^20.
  static constexpr unsigned bits = meshGridBits + 1;
  static constexpr std::int64_t half = std::int64_t{1} << (meshGridBits - 1);
  static constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;

  Vec3<double> m_origin;
  int m_exponent = 0;
};

/// One mesh on its way. Each step returns false once it is cancelled.
class ShapeMaker {
public:
  ShapeMaker(RawMesh raw, const std::atomic<bool> &cancelled, const PartDone &partDone)
      : m_raw(std::move(raw)), m_cancelled(cancelled), m_partDone(partDone) {}

  Result<LoadedMesh> make(std::string name) {
    const std::size_t all = m_raw.triangles.size();
    if (!leaveOutBroken())
      return cancelled();
    if (m_raw.triangles.empty())
      return nothingLeft(all);
    m_loaded.size = m_box.size();
    if (auto refused = refusedSize())
      return std::move(*refused);
    if (!merge() || !keepOnce() || m_cancelled)
      return cancelled();
    if (m_mesh.triangles.empty())
      return nothingLeft(all);
    m_loaded.name = std::move(name);
    m_loaded.triangles = m_mesh.triangles.size();
    makeSearchable();
    return m_cancelled ? cancelled() : Result<LoadedMesh>(std::move(m_loaded));
  }

private:
  static Result<LoadedMesh> cancelled() { return problemOf(words("Loading the mesh was cancelled.")); }

  Result<LoadedMesh> nothingLeft(std::size_t all) const {
    return problemOf(words("No triangle of the file can be used: of {all}, {degenerate} have no area, and "
                           "{broken} have a corner that is missing or no number.",
                           {{"all", std::to_string(all)},
                            {"degenerate", std::to_string(m_loaded.degenerate)},
                            {"broken", std::to_string(m_loaded.broken)}}));
  }

  /// A box without any length is left to the triangles, which then have no area.
  [[nodiscard]] std::optional<Result<LoadedMesh>> refusedSize() const {
    const double side = m_box.longestSide();
    if (side > longestMeshSide)
      return problemOf(
          words("The mesh is too large: its longest side may be {limit} at most. Scale it down in the "
                "program that it comes from.",
                {{"limit", std::to_string(std::llround(longestMeshSide))}}));
    if (side > 0 && side < shortestMeshSide)
      return problemOf(
          words("The mesh is too small to be drawn. Scale it up in the program that it comes from."));
    return {};
  }

  /// Whether to go on after this item of so many.
  bool goOn(std::size_t item, std::size_t count, double from, double to) const {
    if (item % itemsBetween != 0)
      return true;
    if (m_cancelled)
      return false;
    m_partDone(from + (to - from) * static_cast<double>(item) / static_cast<double>(count));
    return true;
  }

  [[nodiscard]] bool isWhole(const TriangleCorners &triangle) const {
    return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
      return corner < m_raw.corners.size() && isFinite(m_raw.corners[corner]);
    });
  }

  bool leaveOutBroken() {
    const std::size_t count = m_raw.triangles.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!goOn(i, count, 0, untilChecked))
        return false;
      const TriangleCorners triangle = m_raw.triangles[i];
      if (!isWhole(triangle))
        continue;
      m_raw.triangles[kept++] = triangle;
      for (const std::uint32_t corner : triangle)
        m_box.include(Vec3<double>(m_raw.corners[corner]));
    }
    m_raw.triangles.resize(kept);
    m_loaded.broken = count - kept;
    return true;
  }

  /// Gives all triangles the corners that are left once equal ones are one. Those that none uses are dropped.
  bool merge() {
    const Grid grid(m_box);
    Numbering<1> places;
    std::vector<std::uint32_t> merged(m_raw.corners.size(), noCorner);
    const std::size_t count = m_raw.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!goOn(i, count, untilChecked, untilMerged))
        return false;
      for (std::uint32_t &corner : m_raw.triangles[i]) {
        std::uint32_t &number = merged[corner];
        if (number == noCorner)
          number = places.numberOf(grid.keyOf(m_raw.corners[corner])).first;
        corner = number;
      }
    }
    m_raw.corners = {};
    m_mesh.corners.reserve(places.keys().size());
    for (const Grid::Key &place : places.keys())
      m_mesh.corners.push_back(grid.placeOf(place));
    return true;
  }

  /// Keeps the triangles that have an area, the first of those with the same corners.
  bool keepOnce() {
    Numbering<2> seen;
    const std::size_t count = m_raw.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!goOn(i, count, untilMerged, untilSorted))
        return false;
      const TriangleCorners &triangle = m_raw.triangles[i];
      TriangleCorners sorted = triangle;
      std::sort(sorted.begin(), sorted.end());
      const auto &[a, b, c] = sorted;
      if (a == b || b == c || !hasArea(triangle))
        ++m_loaded.degenerate;
      else if (!seen.numberOf({static_cast<std::uint64_t>(a) << 32U | b, c}).second)
        ++m_loaded.repeated;
      else
        m_mesh.triangles.push_back(triangle);
    }
    m_raw.triangles = {};
    return true;
  }

  [[nodiscard]] bool hasArea(const TriangleCorners &triangle) const {
    const auto &[a, b, c] = triangle;
    return decideShape({m_mesh.corners[a], m_mesh.corners[b], m_mesh.corners[c]}) == TriangleShape::Proper;
  }

  void makeSearchable() {
    m_partDone(untilSorted);
    m_loaded.shape = m_mesh.triangles.size() <= mostDrawnFaces ? shapeOfFaces() : shapeOfTriangles();
    m_partDone(1);
  }

  /// As sessions have it, which write each triangle as a face.
  std::shared_ptr<const MeshShape> shapeOfFaces() {
    std::vector<MeshFace> faces;
    faces.reserve(m_mesh.triangles.size());
    for (const auto &[a, b, c] : m_mesh.triangles)
      faces.push_back({a, b, c});
    return std::make_shared<const MeshShape>(std::move(m_mesh.corners), std::move(faces));
  }

  std::shared_ptr<const MeshShape> shapeOfTriangles() {
    std::shared_ptr<const HitSearch> search = makeHitSearch(m_mesh, m_cancelled);
    return m_cancelled ? nullptr : std::make_shared<const MeshShape>(std::move(m_mesh), std::move(search));
  }

  RawMesh m_raw;
  const std::atomic<bool> &m_cancelled;
  const PartDone &m_partDone;
  BoundingBox m_box;
  TriangleMesh m_mesh;
  LoadedMesh m_loaded;
};

} // namespace

Result<LoadedMesh> makeShape(RawMesh raw, std::string name, const std::atomic<bool> &cancelled,
                             const PartDone &partDone) {
  return ShapeMaker(std::move(raw), cancelled, partDone).make(std::move(name));
}

} // namespace halfspace
