// What is seen through and stands before something or behind it: a flat face, or half of a ball's surface.
#pragma once

#include "widgets/exports/page_path.h"
#include "widgets/exports/paper.h"

#include <set>
#include <variant>

namespace halfspace {

/// How something stands to a veil, seen by the eye.
enum class Standing {
  Aside,  ///< not one before the other
  Before, ///< also in it
  Behind
};

/// A straight piece of a line that is wholly seen.
struct SightedPiece {
  Place from{};
  Place to{};
};

/// A convex polygon; it is not seen edge-on.
class FlatVeil {
public:
  /// Requires corners that are all seen. Nothing where the polygon has no area on the page.
  [[nodiscard]] static std::optional<FlatVeil> of(const std::vector<Place> &corners, const Paper &paper);

  /// The parts of a piece's way where its standing can change, in any order.
  void addChanges(const SightedPiece &piece, const Paper &paper, std::vector<double> &parts) const;
  [[nodiscard]] Standing standingOf(const Place &place, const Paper &paper) const;

  /// Turning like the axes of the page from x to y.
  [[nodiscard]] const std::vector<glm::dvec2> &corners() const { return m_corners; }
  /// From the plane; positive on the eye's side.
  [[nodiscard]] double side(const Place &place) const { return glm::dot(m_normal, place) + m_offset; }
  [[nodiscard]] bool isInOnePlaneWith(const FlatVeil &other) const;

private:
  FlatVeil() = default;

  Place m_normal{}; ///< unit
  double m_offset = 0;
  std::vector<glm::dvec2> m_corners;
};

/// The near or the far half of a ball's surface, seen by an eye outside of it.
class BallVeil {
public:
  enum class Half { Near, Far };
  /// Nothing for an eye inside, and for a ball that is not wholly before it.
  [[nodiscard]] static std::optional<BallVeil> of(const Globe &ball, Half half, const Paper &paper);

  void addChanges(const SightedPiece &piece, const Paper &paper, std::vector<double> &parts) const;
  [[nodiscard]] Standing standingOf(const Place &place, const Paper &paper) const;

  /// Its silhouette on the page.
  [[nodiscard]] const std::vector<glm::dvec2> &corners() const { return m_corners; }

private:
  BallVeil() = default;

  Globe m_ball;
  Half m_half = Half::Near;
  std::vector<glm::dvec2> m_corners;
};

using Veil = std::variant<FlatVeil, BallVeil>;

/// How something stands to veils, by their numbers, which follow an order in which they can be painted.
struct AmongVeils {
  std::set<std::size_t> before{}; ///< those that it stands before
  std::set<std::size_t> behind{}; ///< those that stand before it
  bool operator==(const AmongVeils &) const = default;

  [[nodiscard]] bool isHidden() const { return !behind.empty(); }
  /// Whether all that it stands before are painted before all that stand before it.
  [[nodiscard]] bool canBePainted() const {
    return before.empty() || behind.empty() || *before.rbegin() < *behind.begin();
  }
  [[nodiscard]] AmongVeils with(const AmongVeils &other) const;
};

/// A part of the way of a piece in which it stands in one way to all veils.
struct StandingSpan {
  double begin = 0;
  double end = 1;
  AmongVeils veils{};
};

/// How often it may still be asked how something stands to a veil.
class Questions {
public:
  /// As many as take about a second.
  static constexpr std::size_t most = 40'000'000;

  explicit Questions(std::size_t left = most) : m_left(left) {}
  /// Whether so many more may be asked; if not, none may from then on.
  [[nodiscard]] bool ask(std::size_t count);

private:
  std::size_t m_left;
};

/// Veils by their numbers.
class Veils {
public:
  explicit Veils(const Paper &paper) : m_paper(paper) {}

  void add(Veil veil);
  [[nodiscard]] std::size_t count() const { return m_veils.size(); }
  [[nodiscard]] const Veil &operator[](std::size_t number) const { return m_veils[number]; }
  [[nodiscard]] const std::vector<glm::dvec2> &cornersOf(std::size_t number) const;
  /// Whether two of them lie one over the other on the page, by more than a hair.
  [[nodiscard]] bool overlap(std::size_t one, std::size_t other) const;

  /// A piece, cut where its standing to one of the veils changes. Each veil that it comes near is asked, as
  /// long as questions are left: where very many lines meet very many veils the last stand aside of all.
  [[nodiscard]] std::vector<StandingSpan> spansOf(const SightedPiece &piece, Questions &questions) const;
  /// Of a single place.
  [[nodiscard]] AmongVeils standingOf(const Place &place, Questions &questions) const;

private:
  /// A part of the way of a piece in which it stands in one way to one veil.
  struct Stay {
    double begin;
    double end;
    std::size_t veil;
    Standing standing;
  };
  [[nodiscard]] std::vector<std::size_t> near(const PixelBox &box, Questions &questions) const;
  [[nodiscard]] std::vector<Stay> staysOf(const SightedPiece &piece, Questions &questions) const;

  const Paper &m_paper;
  std::vector<Veil> m_veils;
  std::vector<PixelBox> m_boxes; ///< around them, in points
};

} // namespace halfspace
