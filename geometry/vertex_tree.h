// Many points, to be asked which side of a plane they lie on.
#pragma once

#include "geometry/plane.h"

#include <algorithm>
#include <span>
#include <vector>

namespace halfspace {

/// Points in nested boxes: whether one of them lies in front of a plane is told without looking at each.
/// Exact over fractions.
template <class Scalar> class VertexTree {
public:
  /// At least one point.
  explicit VertexTree(std::span<const Vec3<Scalar>> points) : m_points(points.begin(), points.end()) {
    m_nodes.reserve(2 * (m_points.size() / leafSize + 1));
    build(0, m_points.size());
  }

  /// Whether f(x) > 0 for one of the points.
  [[nodiscard]] bool hasInFront(const Plane<Scalar> &plane) const { return hasInFront(plane, 0); }

private:
  static constexpr std::size_t leafSize = 8;

  struct Node {
    Vec3<Scalar> low;
    Vec3<Scalar> high;
    std::size_t begin;
    std::size_t end;
    std::size_t second =
        0; ///< of the two nodes that it is made of, the first stands behind it; 0: it has none
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t index = m_nodes.size();
    m_nodes.push_back(boxOf(begin, end));
    if (end - begin <= leafSize)
      return index;
    const glm::length_t axis = widestAxis(m_nodes[index]);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this](std::size_t i) { return m_points.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const auto &a, const auto &b) { return a[axis] < b[axis]; });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    m_nodes[index].second = second;
    return index;
  }

  [[nodiscard]] Node boxOf(std::size_t begin, std::size_t end) const {
    Node node{m_points[begin], m_points[begin], begin, end};
    for (std::size_t i = begin; i < end; ++i)
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        node.low[axis] = std::min(node.low[axis], m_points[i][axis]);
        node.high[axis] = std::max(node.high[axis], m_points[i][axis]);
      }
    return node;
  }

  static glm::length_t widestAxis(const Node &node) {
    const Vec3<Scalar> size = node.high - node.low;
    if (size.x >= size.y && size.x >= size.z)
      return 0;
    return size.y >= size.z ? 1 : 2;
  }

  [[nodiscard]] bool hasInFront(const Plane<Scalar> &plane, std::size_t index) const {
    const Node &node = m_nodes[index];
    const Scalar zero(0);
    Vec3<Scalar> farthest = node.low; // the corner of the box that reaches farthest to the front
    for (glm::length_t axis = 0; axis < 3; ++axis)
      if (plane.normal[axis] > zero)
        farthest[axis] = node.high[axis];
    if (evaluate(plane, farthest) <= zero)
      return false;
    if (node.second != 0)
      return hasInFront(plane, index + 1) || hasInFront(plane, node.second);
    return std::any_of(m_points.begin() + static_cast<std::ptrdiff_t>(node.begin),
                       m_points.begin() + static_cast<std::ptrdiff_t>(node.end),
                       [&](const Vec3<Scalar> &point) { return evaluate(plane, point) > zero; });
  }

  std::vector<Vec3<Scalar>> m_points;
  std::vector<Node> m_nodes;
};

} // namespace halfspace
