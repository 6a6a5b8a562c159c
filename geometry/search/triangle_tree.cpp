#include "geometry/search/triangle_tree.h"

#include "geometry/bounding_box.h"
#include "geometry/decide.h"
#include "geometry/filter.h"
#include "geometry/search/approach_ball.h"
#include "geometry/search/embree.h"
#include "geometry/search/lanes.h"
#include "geometry/search/large_pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

/// By how much each box is made larger on each side, in the tree's units. A ray is followed for less than
/// eight of them: four to where it is nearest to the middle, and no more than 2√3 from there on. Where it
/// crosses the plane of a box's side is told after four roundings of 2^-24, one of its origin and one of the
/// side: less than 2^-19 + 2^-21 + 2^-24 off. One over fractions is rounded to doubles before: that is
/// another 2^-26 off.
constexpr double boxMargin = 0x1p-18;
/// A bound on the error of a triangle's products, as a share of the sum of their terms' magnitudes: at most
/// 20 roundings of 2^-24. How far a corner lies from the ray's origin is off by another 2^-20 at most,
/// wherever they are: as much as if that way were a unit longer than it is.
constexpr float productError = 0x1p-19F;
/// More than what underflow adds to that.
constexpr float leastError = 0x1p-120F;
/// Origins further off than so many units are not moved up to the scene: in doubles that rounds by up to
/// 2^-25 of a unit, and the margin has no more to spare.
constexpr double farthestOrigin = 0x1p26;
/// A direction's coordinates below this share of the largest one are taken as this: over eight units that
/// moves the ray by far less than the margin, and its reciprocal stays finite.
constexpr float smallestSlope = 0x1p-60F;

/// In a ball of this radius around the middle is the whole scene: the corners of its box are at most √3 away,
/// and twice that where the middle could only be rounded to a corner.
constexpr double ballRadius = 4;

constexpr std::size_t mostChildren = 2 * laneCount;
constexpr std::size_t mostInLeaf = 4 * laneCount;
/// What it costs to ask four triangles, in node openings; by measurement.
constexpr float blockCost = 0.3F;
/// Embree's own limit. Of a node's children one is gone into at once, the others wait.
constexpr unsigned maxDepth = 32;
constexpr std::size_t mostWaiting = maxDepth * (mostChildren - 1);

constexpr std::uint32_t noTriangle = std::numeric_limits<std::uint32_t>::max();

} // namespace

/// Up to eight boxes and what lies in them. The boxes are three lines of a cache, the links one.
struct alignas(64) TriangleTree::Node {
  using Sides = std::array<Lanes, 2>; ///< of four boxes, on one axis: the lower ones, the upper ones
  std::array<std::array<Sides, 3>, mostChildren / laneCount> boxes;
  std::array<Link, mostChildren> children;
};

/// Up to four triangles of a leaf.
struct alignas(32) TriangleTree::Block {
  VectorLanes p0, u, v; ///< P0, P1 − P0, P2 − P0
  std::array<std::uint32_t, laneCount> indices;
};

TriangleTree::Link::Link(const Block *blocks, std::size_t count)
    : m_place(reinterpret_cast<const std::byte *>(blocks) + count) {
  static_assert(alignof(Block) == alignment && mostInLeaf / laneCount < alignment);
}

const TriangleTree::Node &TriangleTree::Link::node() const {
  return *reinterpret_cast<const Node *>(m_place);
}

std::span<const TriangleTree::Block> TriangleTree::Link::blocks() const {
  return {reinterpret_cast<const Block *>(m_place - blockCount()), blockCount()};
}

void TriangleTree::Link::expect() const {
  constexpr std::size_t cacheLine = 64;
  __builtin_prefetch(m_place);
  __builtin_prefetch(m_place + cacheLine);
}

/// A ray as the tree is asked with it: from a place near the scene.
struct TriangleTree::MovedRay {
  Vec3<float> origin;
  Vec3<float> direction; ///< its largest coordinate is 1
  double start;          ///< how far it was moved
  double perT;           ///< how far a t of 1 leads
};

/// Embree's, in which nodes and blocks lie.
struct TriangleTree::Memory {
  Memory() : device(rtcNewDevice(nullptr)), nodes(device != nullptr ? rtcNewBVH(device) : nullptr) {}
  Memory(const Memory &) = delete;
  Memory &operator=(const Memory &) = delete;
  ~Memory() {
    if (nodes != nullptr)
      rtcReleaseBVH(nodes);
    if (device != nullptr)
      rtcReleaseDevice(device);
  }

  RTCDevice device;
  RTCBVH nodes;
};

/// What Embree calls while it builds, from several threads at once.
struct TriangleTree::Builder {
  const TriangleTree &tree;
  std::span<const Triangle<double>> triangles;
  const std::atomic<bool> *cancelled; ///< null: it cannot be

  [[nodiscard]] bool isCancelled() const { return cancelled != nullptr && *cancelled; }

  [[nodiscard]] std::vector<RTCBuildPrimitive> boxes() const {
    std::vector<RTCBuildPrimitive> boxes;
    reserveInLargePages(boxes, triangles.size());
    for (std::size_t i = 0; i < triangles.size() && !isCancelled(); ++i) {
      if (decideShape(triangles[i]) != TriangleShape::Proper) // no ray hits it
        continue;
      BoundingBox box;
      box.include(triangles[i]);
      const auto low = Vec3<float>((box.low - tree.m_middle) * tree.m_scale - boxMargin);
      const auto high = Vec3<float>((box.high - tree.m_middle) * tree.m_scale + boxMargin);
      boxes.push_back({low.x, low.y, low.z, 0, high.x, high.y, high.z, static_cast<unsigned>(i)});
    }
    return boxes;
  }

  /// Embree catches what is thrown, and has then built nothing.
  template <class Kept> static Kept *roomFor(std::size_t count, RTCThreadLocalAllocator allocator) {
    void *room = rtcThreadLocalAlloc(allocator, count * sizeof(Kept), alignof(Kept));
    return room != nullptr ? static_cast<Kept *>(room) : throw std::bad_alloc();
  }

  static void *createNode(RTCThreadLocalAllocator allocator, unsigned, void *builder) {
    if (static_cast<const Builder *>(builder)->isCancelled())
      throw std::runtime_error("cancelled");
    auto *node = new (roomFor<Node>(1, allocator)) Node;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (auto &four : node->boxes) // no ray meets these
      four.fill({inAllLanes(infinity), inAllLanes(-infinity)});
    return Link(node).place();
  }

  static void setChildren(void *node, void **children, unsigned count, void *) {
    for (unsigned child = 0; child < count; ++child)
      static_cast<Node *>(node)->children[child] = Link(children[child]);
  }

  static void setBounds(void *node, const RTCBounds **bounds, unsigned count, void *) {
    for (unsigned child = 0; child < count; ++child) {
      auto &[x, y, z] = static_cast<Node *>(node)->boxes[child / laneCount];
      const std::size_t lane = child % laneCount;
      const RTCBounds &box = *bounds[child];
      x[0][lane] = box.lower_x;
      y[0][lane] = box.lower_y;
      z[0][lane] = box.lower_z;
      x[1][lane] = box.upper_x;
      y[1][lane] = box.upper_y;
      z[1][lane] = box.upper_z;
    }
  }

  static void *createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive *primitives,
                          std::size_t count, void *builder) {
    const std::size_t blockCount = (count + laneCount - 1) / laneCount;
    auto *blocks = roomFor<Block>(blockCount, allocator);
    for (std::size_t i = 0; i < blockCount; ++i)
      (new (blocks + i) Block{})->indices.fill(noTriangle);
    for (std::size_t i = 0; i < count; ++i)
      static_cast<const Builder *>(builder)->put(primitives[i].primID, blocks[i / laneCount], i % laneCount);
    return Link(blocks, blockCount).place();
  }

  void put(std::uint32_t index, Block &block, std::size_t lane) const {
    const auto &[p0, p1, p2] = triangles[index];
    block.indices[lane] = index;
    setLane(block.p0, lane, Vec3<float>((p0 - tree.m_middle) * tree.m_scale));
    setLane(block.u, lane, Vec3<float>((p1 - p0) * tree.m_scale));
    setLane(block.v, lane, Vec3<float>((p2 - p0) * tree.m_scale));
  }
};

TriangleTree::TriangleTree(std::span<const Triangle<double>> triangles, const std::atomic<bool> *cancelled) {
  assert(triangles.size() < noTriangle);
  BoundingBox box;
  for (const Triangle<double> &triangle : triangles) {
    m_isTame = m_isTame && halfspace::isTame(triangle);
    box.include(triangle);
  }
  const double halfWidth = box.longestSide() * 0.5;
  constexpr double smallest = 0x1p-200;
  if (triangles.empty() || !m_isTame || halfWidth < smallest)
    return;
  m_middle = (box.low + box.high) * 0.5;
  m_scale = std::exp2(-std::ilogb(halfWidth) - 1);
  build(triangles, cancelled);
}

TriangleTree::~TriangleTree() = default;

void TriangleTree::build(std::span<const Triangle<double>> triangles, const std::atomic<bool> *cancelled) {
  m_memory = std::make_unique<Memory>();
  if (m_memory->nodes == nullptr)
    return;
  Builder builder{*this, triangles, cancelled};
  std::vector<RTCBuildPrimitive> boxes = builder.boxes();
  if (builder.isCancelled())
    return;
  if (boxes.empty()) {
    m_isBuilt = true;
    return;
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxBranchingFactor = mostChildren;
  arguments.maxDepth = maxDepth;
  arguments.sahBlockSize = laneCount;
  arguments.maxLeafSize = mostInLeaf;
  arguments.intersectionCost = blockCost;
  arguments.bvh = m_memory->nodes;
  arguments.primitives = boxes.data();
  arguments.primitiveCount = boxes.size();
  arguments.primitiveArrayCapacity = boxes.size();
  arguments.createNode = Builder::createNode;
  arguments.setNodeChildren = Builder::setChildren;
  arguments.setNodeBounds = Builder::setBounds;
  arguments.createLeaf = Builder::createLeaf;
  arguments.userPtr = &builder;
  m_root = Link(rtcBuildBVH(&arguments));
  m_isBuilt = !m_root.isNull();
}

std::optional<Rational> TriangleTree::approach(const Ray<Rational> &ray) const {
  return m_isBuilt ? approachBall(ray, m_middle, ballRadius / m_scale) : Rational(0);
}

/// Of a ray as seen from the middle. Nothing where it is so far off, or so short, that each triangle must be
/// asked.
std::optional<TriangleTree::MovedRay> TriangleTree::move(const Ray<double> &ray) const {
  const Vec3<double> origin = ray.origin * m_scale;
  const double size = largestCoordinate(ray.direction);
  const double perT = size * m_scale;
  // What is below the smallest normal number has no reciprocal, or lost digits.
  if (!halfspace::isTame(ray) || largestCoordinate(origin) > farthestOrigin ||
      std::min(size, perT) < std::numeric_limits<double>::min())
    return {};
  const Vec3<double> direction = ray.direction * (1 / size);
  // To where the ray comes into the ball, or a little before.
  double start = 0;
  if (largestCoordinate(origin) > ballRadius / 2)
    start = std::max(0.0, -dot(origin, direction) / dot(direction, direction) - ballRadius);
  return MovedRay{Vec3<float>(origin + direction * start), Vec3<float>(direction), start, perT};
}

/// One ray on its way through the tree.
class TriangleTree::Search {
public:
  Search(const MovedRay &ray, NearestSoFar &nearest) : m_ray(ray), m_nearest(nearest) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float slope = ray.direction[static_cast<glm::length_t>(axis)];
      const float inverse =
          1 / (std::abs(slope) < smallestSlope ? std::copysign(smallestSlope, slope) : slope);
      m_axes[axis] = {inAllLanes(ray.origin[static_cast<glm::length_t>(axis)]), inAllLanes(inverse),
                      std::signbit(slope) ? 1U : 0U};
    }
  }

  void run(Link root) {
    Waiting next{root, 0};
    do {
      while (!next.link.isLeaf())
        if (!goInto(next.link.node(), next) && !goBack(next))
          return;
      for (const Block &block : next.link.blocks())
        ask(block);
    } while (goBack(next));
  }

  [[nodiscard]] const SearchCost &cost() const { return m_cost; }

private:
  struct Axis {
    Lanes origin;
    Lanes inverse;         ///< of the direction
    std::size_t firstSide; ///< of a box, where the ray comes in: 0 the lower one, 1 the upper one
  };
  struct Waiting {
    Link link;
    float entered; ///< where the ray comes into the box
  };
  struct Way {
    Lanes entered;
    Lanes left;
  };

  /// Between the two sides of four boxes on one axis.
  [[nodiscard]] static Way wayBetween(const Node::Sides &sides, const Axis &axis) {
    return {(sides[axis.firstSide] - axis.origin) * axis.inverse,
            (sides[1 - axis.firstSide] - axis.origin) * axis.inverse};
  }

  /// The nearest of the node's children that the ray meets is next, the others wait. False where it meets
  /// none.
  [[nodiscard]] bool goInto(const Node &node, Waiting &next) {
    std::array<Lanes, mostChildren / laneCount> entered;
    unsigned met = 0;
    for (unsigned four = 0; four < mostChildren / laneCount; ++four) {
      const auto &[x, y, z] = node.boxes[four];
      m_cost.boxes +=
          static_cast<unsigned>(std::countr_one(lanesOfLessOrEqual(x[0], x[1]))); // those that are there
      const Way onX = wayBetween(x, m_axes[0]);
      const Way onY = wayBetween(y, m_axes[1]);
      const Way onZ = wayBetween(z, m_axes[2]);
      entered[four] = max(max(onX.entered, onY.entered), max(onZ.entered, Lanes{}));
      const Lanes firstLeft = min(min(onX.left, onY.left), min(onZ.left, inAllLanes(m_reach)));
      met |= lanesOfLessOrEqual(entered[four], firstLeft) << four * laneCount;
    }
    if (met == 0)
      return false;
    const auto takeOne = [&] {
      const auto child = static_cast<std::size_t>(std::countr_zero(met));
      met &= met - 1;
      return Waiting{node.children[child], entered[child / laneCount][child % laneCount]};
    };
    next = takeOne();
    while (met != 0) {
      Waiting other = takeOne();
      if (other.entered < next.entered)
        std::swap(other, next);
      other.link.expect();
      m_waiting[m_waitingCount++] = other;
    }
    return true;
  }

  /// To a box that waits. False where none does.
  [[nodiscard]] bool goBack(Waiting &next) {
    do {
      if (m_waitingCount == 0)
        return false;
      next = m_waiting[--m_waitingCount];
    } while (next.entered > m_reach);
    return true;
  }

  void ask(const Block &block) {
    for (const std::uint32_t index : block.indices)
      if (index != noTriangle) {
        ++m_cost.triangles;
        m_nearest.expect(index);
      }
    const Lanes certainty = certaintyOfMiss(block);
    for (std::size_t lane = 0; lane < laneCount; ++lane)
      if (!(certainty[lane] > 0) && block.indices[lane] != noTriangle) {
        m_nearest.offer(block.indices[lane]);
        m_reach = static_cast<float>(m_nearest.reach() * m_ray.perT - m_ray.start + boxMargin);
      }
  }

  /// Above 0 only where the ray misses the triangle. The products and signs are those of `filterRayTriangle`.
  [[nodiscard]] Lanes certaintyOfMiss(const Block &block) const {
    const auto &[p0, u, v, indices] = block;
    const VectorLanes direction = inAllLanes(m_ray.direction);
    const VectorLanes w = VectorLanes{m_axes[0].origin, m_axes[1].origin, m_axes[2].origin} - p0;
    const VectorLanes acrossV = cross(v, direction);
    const VectorLanes acrossU = cross(u, w);
    const Lanes sum = dot(u, acrossV);
    const Lanes second = dot(w, acrossV);
    const Lanes third = dot(direction, acrossU);
    const Lanes first = sum - second - third;
    const Lanes volume = dot(v, acrossU);

    const Lanes one = inAllLanes(1);
    const Lanes sizeU = largestCoordinate(u);
    const Lanes sizeV = largestCoordinate(v);
    const Lanes sizeW = largestCoordinate(w) + one;
    const auto errorOf = [](Lanes size) {
      constexpr float terms = 6; // of a volume of three edges
      return size * inAllLanes(terms * productError) + inAllLanes(leastError);
    };
    const Lanes sumError = errorOf(sizeU * sizeV);
    const Lanes secondError = errorOf(sizeW * sizeV);
    const Lanes thirdError = errorOf(sizeU * sizeW);
    // Each difference may be rounded by as much as what it is taken of may be off.
    const Lanes firstError = inAllLanes(3) * (sumError + secondError + thirdError);
    const Lanes volumeError = errorOf(sizeU * sizeV * sizeW);

    // Which side of the triangle is surely seen: 1, −1, or 0 where that is open.
    const Lanes facing = (sum > sumError ? one : Lanes{}) - (-sum > sumError ? one : Lanes{});
    const auto against = [facing](Lanes product, Lanes error) { return -facing * product - error; };
    return max(max(against(first, firstError), against(second, secondError)),
               max(against(third, thirdError), against(volume, volumeError)));
  }

  const MovedRay &m_ray;
  NearestSoFar &m_nearest;
  std::array<Axis, 3> m_axes;
  float m_reach = std::numeric_limits<float>::infinity(); ///< boxes that are entered later are done with
  std::array<Waiting, mostWaiting> m_waiting;             ///< the first `m_waitingCount` of them
  std::size_t m_waitingCount = 0;
  SearchCost m_cost;
};

std::optional<SearchCost> TriangleTree::search(const Ray<double> &ray, NearestSoFar &nearest) const {
  return searchFromMiddle({ray.origin - m_middle, ray.direction}, nearest);
}

std::optional<SearchCost> TriangleTree::search(const Ray<Rational> &ray, NearestSoFar &nearest) const {
  const Vec3<Rational> fromMiddle = ray.origin - exactly(m_middle);
  return searchFromMiddle({toDouble(fromMiddle), toDouble(ray.direction)}, nearest);
}

std::optional<SearchCost> TriangleTree::searchFromMiddle(const Ray<double> &ray,
                                                         NearestSoFar &nearest) const {
  const auto moved = m_isBuilt ? move(ray) : std::nullopt;
  if (!moved)
    return {};
  if (m_root.isNull())
    return SearchCost{};
  Search search(*moved, nearest);
  search.run(m_root);
  return search.cost();
}

} // namespace halfspace
