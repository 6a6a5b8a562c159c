// A ray on its way through a tree of triangles.
#include "geometry/decide.h"
#include "geometry/filter.h"
#include "geometry/search/approach_ball.h"
#include "geometry/search/triangle_tree_nodes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

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

/// Of the children of a node one is gone into at once, the others wait.
constexpr std::size_t mostWaiting = tree::maxDepth * (tree::mostChildren - 1);

} // namespace

/// A ray as the tree is asked with it: from a place near the scene.
struct TriangleTree::MovedRay {
  Vec3<float> origin;
  Vec3<float> direction; ///< its largest coordinate is 1
  double start;          ///< how far it was moved
  double perT;           ///< how far a t of 1 leads
};

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
    std::array<Lanes, tree::mostChildren / laneCount> entered;
    unsigned met = 0;
    for (unsigned four = 0; four < tree::mostChildren / laneCount; ++four) {
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
      if (index != tree::noTriangle) {
        ++m_cost.triangles;
        m_nearest.expect(index);
      }
    const Lanes certainty = certaintyOfMiss(block);
    for (std::size_t lane = 0; lane < laneCount; ++lane)
      if (!(certainty[lane] > 0) && block.indices[lane] != tree::noTriangle) {
        m_nearest.offer(block.indices[lane]);
        m_reach = static_cast<float>(m_nearest.reach() * m_ray.perT - m_ray.start + tree::boxMargin);
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
