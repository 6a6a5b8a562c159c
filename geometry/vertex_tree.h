// Many points, to be asked which side of a plane they lie on.
#pragma once

#include "geometry/filter.h"
#include "geometry/weighted_point.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace halfspace {

/// The exponent of a power of two near |p/q|. Requires p, q ≠ 0, and fractions that are whole numbers.
/// (1) Over fractions 2^(exponent − 1) < |p/q| < 2^(exponent + 1).
[[nodiscard]] int binaryExponent(const Rational &p, const Rational &q);
template <class Scalar> [[nodiscard]] int binaryExponent(const Scalar &p, const Scalar &q) {
  return std::ilogb(toDouble(p)) - std::ilogb(toDouble(q));
}

/// p/q·2^exponent as a double, over fractions the nearest one. Requires q > 0, and fractions that are whole
/// numbers.
[[nodiscard]] double nearestQuotient(const Rational &p, const Rational &q, int exponent);
template <class Scalar> [[nodiscard]] double nearestQuotient(const Scalar &p, const Scalar &q, int exponent) {
  return std::ldexp(toDouble(p) / toDouble(q), exponent);
}

/// Points in nested boxes: whether one of them lies in front of a plane is told without looking at each.
///
/// Exact over fractions. Doubles near to them decide wherever they can, so long numbers cost no more than
/// others unless points lie on the plane or very near to it. The doubles are counted along each axis in units
/// of about the size of the whole, and from a point nearby where the origin lies far off.
template <class Scalar> class VertexTree {
public:
  /// Requires at least one point.
  explicit VertexTree(const std::vector<WeightedPoint<Scalar>> &points) : m_from(points.front()) {
    for (const auto &point : points)
      m_points.push_back({point, {}});
    findFrame();
    for (Point &point : m_points)
      point.nearby = nearby(point.exact);
    m_nodes.reserve(2 * (m_points.size() / leafSize + 1));
    build(0, m_points.size());
  }

  /// Whether one of the points lies in front of a plane. Over fractions requires one of whole numbers.
  /// (1) Over fractions the answer is exactly whether evaluate(plane, x) > 0 for one of the points x.
  [[nodiscard]] bool hasInFront(const Plane<Scalar> &plane) const {
    return hasInFront({plane, nearby(plane)}, 0);
  }

private:
  static constexpr std::size_t leafSize = 8;

  struct Point {
    WeightedPoint<Scalar> exact;
    Vec3<double> nearby;
  };
  struct Question {
    const Plane<Scalar> &exact;
    Plane<double> nearby;
  };
  struct Node {
    Vec3<double> low;
    Vec3<double> high;
    std::size_t begin;
    std::size_t end;
    std::size_t second =
        0; ///< of the two nodes that it is made of, the first stands behind it; 0: it has none
  };

  [[nodiscard]] WeightedPoint<Scalar> seen(const WeightedPoint<Scalar> &point) const {
    return {lineThrough(m_from, point).direction, m_from.weight * point.weight};
  }

  void findFrame() {
    m_units = largestExponents();
    for (glm::length_t axis = 0; axis < 3; ++axis)
      if (const Scalar &first = m_from.position[axis];
          first != Scalar(0) && binaryExponent(first, m_from.weight) <= m_units[axis])
        m_from.position[axis] = Scalar(0);
    m_units = largestExponents();
  }

  /// Of zero, smaller than any exponent.
  static constexpr int noExponent = std::numeric_limits<int>::min();
  static int orZero(int exponent) { return exponent == noExponent ? 0 : exponent; }

  /// Of the points' coordinates as they are seen; 0 where all are 0.
  [[nodiscard]] Vec3<int> largestExponents() const {
    Vec3<int> largest(noExponent);
    for (const Point &point : m_points) {
      const auto from = seen(point.exact);
      for (glm::length_t axis = 0; axis < 3; ++axis)
        if (from.position[axis] != Scalar(0))
          largest[axis] = std::max(largest[axis], binaryExponent(from.position[axis], from.weight));
    }
    for (glm::length_t axis = 0; axis < 3; ++axis)
      largest[axis] = orZero(largest[axis]);
    return largest;
  }

  [[nodiscard]] Vec3<double> nearby(const WeightedPoint<Scalar> &point) const {
    const auto from = seen(point);
    Vec3<double> result;
    for (glm::length_t axis = 0; axis < 3; ++axis)
      result[axis] = nearestQuotient(from.position[axis], from.weight, -m_units[axis]);
    return result;
  }

  /// A positive multiple of the plane, with coefficients of about 1 or less.
  [[nodiscard]] Plane<double> nearby(const Plane<Scalar> &plane) const {
    const Scalar one(1);
    const Vec3<Scalar> normal = plane.normal * m_from.weight;
    const Scalar offset = evaluate(plane, m_from);
    int size = offset == Scalar(0) ? noExponent : binaryExponent(offset, one);
    for (glm::length_t axis = 0; axis < 3; ++axis)
      if (normal[axis] != Scalar(0))
        size = std::max(size, binaryExponent(normal[axis], one) + m_units[axis]);
    size = orZero(size);
    Plane<double> result{{}, nearestQuotient(offset, one, -size)};
    for (glm::length_t axis = 0; axis < 3; ++axis)
      result.normal[axis] = nearestQuotient(normal[axis], one, m_units[axis] - size);
    return result;
  }

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t index = m_nodes.size();
    m_nodes.push_back(boxOf(begin, end));
    if (end - begin <= leafSize)
      return index;
    const glm::length_t axis = widestAxis(m_nodes[index]);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this](std::size_t i) { return m_points.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const Point &a, const Point &b) { return a.nearby[axis] < b.nearby[axis]; });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    m_nodes[index].second = second;
    return index;
  }

  [[nodiscard]] Node boxOf(std::size_t begin, std::size_t end) const {
    Node node{m_points[begin].nearby, m_points[begin].nearby, begin, end};
    for (std::size_t i = begin; i < end; ++i)
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        node.low[axis] = std::min(node.low[axis], m_points[i].nearby[axis]);
        node.high[axis] = std::max(node.high[axis], m_points[i].nearby[axis]);
      }
    return node;
  }

  static glm::length_t widestAxis(const Node &node) {
    const Vec3<double> size = node.high - node.low;
    if (size.x >= size.y && size.x >= size.z)
      return 0;
    return size.y >= size.z ? 1 : 2;
  }

  /// f at the corner of the box that reaches farthest to the front, and a bound for all points in the box.
  static Bounded farthest(const Plane<double> &plane, const Node &node) {
    Vec3<double> front = node.low;
    Vec3<double> outermost = node.low;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      if (plane.normal[axis] > 0)
        front[axis] = node.high[axis];
      outermost[axis] = std::max(std::abs(node.low[axis]), std::abs(node.high[axis]));
    }
    return {boundedEvaluate(plane, front).value, boundedEvaluate(plane, outermost).error};
  }

  static bool isInFront(const Question &question, const Point &point) {
    const int sign = boundedEvaluate(question.nearby, point.nearby).sign();
    return sign != 0 ? sign > 0 : evaluate(question.exact, point.exact) > Scalar(0);
  }

  [[nodiscard]] bool hasInFront(const Question &question, std::size_t index) const {
    const Node &node = m_nodes[index];
    if (farthest(question.nearby, node).sign() < 0)
      return false;
    if (node.second != 0)
      return hasInFront(question, index + 1) || hasInFront(question, node.second);
    return std::any_of(m_points.begin() + static_cast<std::ptrdiff_t>(node.begin),
                       m_points.begin() + static_cast<std::ptrdiff_t>(node.end),
                       [&](const Point &point) { return isInFront(question, point); });
  }

  WeightedPoint<Scalar> m_from; ///< what the doubles are counted from
  Vec3<int> m_units{};          ///< exponents of powers of two
  std::vector<Point> m_points;
  std::vector<Node> m_nodes;
};

} // namespace halfspace
