// What a tree of triangles is made of, for those that build it and those that search it.
#pragma once

#include "geometry/search/lanes.h"
#include "geometry/search/triangle_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace halfspace::tree {

/// By how much each box is made larger on each side, in the tree's units. A ray is followed for less than
/// eight of them: four to where it is nearest to the middle, and no more than 2√3 from there on. Where it
/// crosses the plane of a box's side is told after four roundings of 2^-24, one of its origin and one of the
/// side: less than 2^-19 + 2^-21 + 2^-24 off. One over fractions is rounded to doubles before: that is
/// another 2^-26 off.
inline constexpr double boxMargin = 0x1p-18;

inline constexpr std::size_t mostChildren = 2 * laneCount;
inline constexpr std::size_t mostInLeaf = 4 * laneCount;
/// Embree's own limit.
inline constexpr unsigned maxDepth = 32;

inline constexpr std::uint32_t noTriangle = std::numeric_limits<std::uint32_t>::max();

} // namespace halfspace::tree

namespace halfspace {

/// Up to eight boxes and what lies in them. The boxes are three lines of a cache, the links one.
struct alignas(64) TriangleTree::Node {
  using Sides = std::array<Lanes, 2>; ///< of four boxes, on one axis: the lower ones, the upper ones
  std::array<std::array<Sides, 3>, tree::mostChildren / laneCount> boxes;
  std::array<Link, tree::mostChildren> children;
};

/// Up to four triangles of a leaf.
struct alignas(32) TriangleTree::Block {
  VectorLanes p0, u, v; ///< P0, P1 − P0, P2 − P0
  std::array<std::uint32_t, laneCount> indices;
};

inline TriangleTree::Link::Link(const Block *blocks, std::size_t count)
    : m_place(reinterpret_cast<const std::byte *>(blocks) + count) {
  static_assert(alignof(Block) == alignment && tree::mostInLeaf / laneCount < alignment);
}

inline const TriangleTree::Node &TriangleTree::Link::node() const {
  return *reinterpret_cast<const Node *>(m_place);
}

inline std::span<const TriangleTree::Block> TriangleTree::Link::blocks() const {
  return {reinterpret_cast<const Block *>(m_place - blockCount()), blockCount()};
}

inline void TriangleTree::Link::expect() const {
  constexpr std::size_t cacheLine = 64;
  __builtin_prefetch(m_place);
  __builtin_prefetch(m_place + cacheLine);
}

} // namespace halfspace
