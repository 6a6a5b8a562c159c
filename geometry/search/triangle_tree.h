// Very many triangles in nested boxes.
#pragma once

#include "geometry/search/nearest_so_far.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace halfspace {

/// Finds the few triangles that a ray may hit among very many.
///
/// Boxes and triangles are asked four at once, in floats: boxes are larger than those are wrong, and a
/// triangle is passed over only where they are sure. So none that the ray hits is missed.
class TriangleTree {
public:
  /// Keeps no reference to the triangles. Requires finite coordinates, and fewer than 2^32 − 1 triangles.
  /// Once `cancelled`, building ends soon, and `search` can tell nothing.
  explicit TriangleTree(std::span<const Triangle<double>> triangles,
                        const std::atomic<bool> *cancelled = nullptr);
  TriangleTree(const TriangleTree &) = delete;
  TriangleTree &operator=(const TriangleTree &) = delete;
  ~TriangleTree();

  /// Offers every triangle that may be the nearest hit, about from near to far, and says what was looked at.
  /// Nothing, and nothing is offered, where it cannot tell: each triangle is to be asked then. Requires a
  /// direction ≠ 0 and finite numbers.
  [[nodiscard]] std::optional<SearchCost> search(const Ray<double> &ray, NearestSoFar &nearest) const;
  /// The same for a ray over fractions, in no doubles perhaps.
  [[nodiscard]] std::optional<SearchCost> search(const Ray<Rational> &ray, NearestSoFar &nearest) const;

  /// Where along a ray it comes near the triangles, so that `search` can tell: see approachBall. Nothing
  /// where it surely hits none.
  [[nodiscard]] std::optional<Rational> approach(const Ray<Rational> &ray) const;

  /// Whether all coordinates are so small that bounds on errors hold.
  [[nodiscard]] bool isTame() const { return m_isTame; }

private:
  struct Node;
  struct Block;
  struct MovedRay;
  struct Memory;
  struct Builder;
  class Search;

  /// To a node, or to the blocks of a leaf.
  class Link {
  public:
    Link() = default;
    explicit Link(const Node *node) : Link(static_cast<const void *>(node)) {}
    Link(const Block *blocks, std::size_t count);
    /// As Embree hands links on.
    explicit Link(const void *place) : m_place(static_cast<const std::byte *>(place)) {}
    [[nodiscard]] void *place() const { return const_cast<std::byte *>(m_place); }

    [[nodiscard]] bool isNull() const { return m_place == nullptr; }
    [[nodiscard]] bool isLeaf() const { return blockCount() != 0; }
    [[nodiscard]] const Node &node() const;
    [[nodiscard]] std::span<const Block> blocks() const;
    /// Tells the machine that this will be looked at soon.
    void expect() const;

  private:
    [[nodiscard]] std::size_t blockCount() const {
      return reinterpret_cast<std::uintptr_t>(m_place) % alignment;
    }

    /// Of a leaf as many bytes further as it has blocks, which the alignment leaves free. Not set from the
    /// start: room is kept for many more than come.
    const std::byte *m_place;
  };
  static constexpr std::size_t alignment = 32;

  void build(std::span<const Triangle<double>> triangles, const std::atomic<bool> *cancelled);
  [[nodiscard]] std::optional<SearchCost> searchFromMiddle(const Ray<double> &ray,
                                                           NearestSoFar &nearest) const;
  [[nodiscard]] std::optional<MovedRay> move(const Ray<double> &ray) const;

  // The tree counts from the middle of the scene, in units of once to twice its half width.
  Vec3<double> m_middle{};
  double m_scale = 1; ///< how many of its units are 1; a power of two
  bool m_isTame = true;
  std::unique_ptr<Memory> m_memory;
  bool m_isBuilt = false; ///< else each triangle is to be asked
  Link m_root{};          ///< null: no triangle can be hit
};

} // namespace halfspace
