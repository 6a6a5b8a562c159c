#include "geometry/search/triangle_tree.h"

#include "geometry/bounding_box.h"
#include "geometry/decide.h"
#include "geometry/filter.h"
#include "geometry/search/embree.h"
#include "geometry/search/large_pages.h"
#include "geometry/search/triangle_tree_nodes.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <vector>

namespace halfspace {
namespace {

/// What it costs to ask four triangles, in node openings; by measurement.
constexpr float blockCost = 0.3F;

} // namespace

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
      const auto low = Vec3<float>((box.low - tree.m_middle) * tree.m_scale - tree::boxMargin);
      const auto high = Vec3<float>((box.high - tree.m_middle) * tree.m_scale + tree::boxMargin);
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
      (new (blocks + i) Block{})->indices.fill(tree::noTriangle);
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
  assert(triangles.size() < tree::noTriangle);
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
  arguments.maxBranchingFactor = tree::mostChildren;
  arguments.maxDepth = tree::maxDepth;
  arguments.sahBlockSize = laneCount;
  arguments.maxLeafSize = tree::mostInLeaf;
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

} // namespace halfspace
