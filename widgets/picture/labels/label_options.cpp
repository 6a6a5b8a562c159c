#include "widgets/picture/labels/label_options.h"

#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace halfspace {
namespace {

/// Directions around an anchor, and the distances that are tried, in design pixels; the last ones need a
/// leader line.
constexpr std::size_t directionCount = 12;
constexpr std::array<double, 5> distances{3, 16, 38, 70, 110};
constexpr std::size_t firstWithLeader = 2;

// What makes a place less liked; to be pushed by the screen's edge makes a label hard to tell from others'.
constexpr double costOfOtherSide = 7;
constexpr double costOfNextAnchor = 6;
constexpr std::array<double, distances.size()> costOfDistance{0, 7, 22, 40, 60};
constexpr double costOfLeaving = 200;

/// Labels side by side that are nearer to each other than this, in design pixels, are read as one.
constexpr double readTogether = 8;

/// A box that the screen's edge pushes by less than this part of its size still stands where it was wanted.
constexpr double freePush = 0.02;

/// The obstacles that touch a box, and the points that a label in it could be taken for that of.
LabelObstacles obstaclesIn(const PixelBox &box, const LabelObstacles &all) {
  LabelObstacles found;
  std::copy_if(all.discs.begin(), all.discs.end(), std::back_inserter(found.discs),
               [&](const LabelObstacles::Disc &disc) {
                 return disc.owner != nobody || distanceTo(box, disc.center) < disc.radius;
               });
  std::copy_if(all.segments.begin(), all.segments.end(), std::back_inserter(found.segments),
               [&](const LabelObstacles::Segment &segment) {
                 return lengthInside(box, segment.from, segment.to) > 0;
               });
  return found;
}

/// A direction around an anchor: on the unit circle, and on the square around it.
struct Way {
  glm::dvec2 onCircle;
  glm::dvec2 onSquare;
};

const std::array<Way, directionCount> &waysAround() {
  static const auto around = [] {
    std::array<Way, directionCount> ways;
    for (std::size_t i = 0; i < directionCount; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / directionCount;
      const glm::dvec2 toward(std::cos(angle), std::sin(angle));
      ways[i] = {toward, toward / std::max(std::abs(toward.x), std::abs(toward.y))};
    }
    return ways;
  }();
  return around;
}

/// The box beside an anchor: its side or corner that faces the anchor is `gap` away from it.
PixelBox boxBeside(glm::dvec2 anchor, const Way &way, double gap, glm::dvec2 extent) {
  const glm::dvec2 low = anchor + way.onCircle * gap + (way.onSquare - 1.0) * extent / 2.0;
  return {low, low + extent};
}

/// The box moved into the screen, as far as it fits, and onto whole pixels.
PixelBox movedInside(const PixelBox &box, PixelSize size) {
  const glm::dvec2 extent = box.extent();
  const glm::dvec2 room = glm::max(glm::dvec2(0), glm::dvec2(size.width, size.height) - extent);
  const glm::dvec2 low = glm::floor(glm::clamp(box.low, glm::dvec2(0), room) + 0.5);
  return {low, low + extent};
}

/// How far a box was moved from where it was wanted, in parts of its size; 0 for next to nothing.
double pushOf(const PixelBox &box, const PixelBox &wanted) {
  const glm::dvec2 extent = box.extent();
  return std::max(0.0, glm::distance(wanted.low, box.low) / (extent.x + extent.y) - freePush);
}

bool isOnScreen(glm::dvec2 pixel, PixelSize size) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x <= size.width && pixel.y <= size.height;
}

/// What all places of a label lie in; nothing where no anchor is on the screen.
std::optional<PixelBox> reachOf(const LabelRequest &request, PixelSize size, double pixelRatio) {
  std::optional<PixelBox> reach;
  for (const LabelAnchor &anchor : request.anchors) {
    if (!isOnScreen(anchor.pixel, size))
      continue;
    // Boxes are moved onto whole pixels.
    const glm::dvec2 far = request.extent + anchor.clearance + distances.back() * pixelRatio + 1.0;
    const PixelBox around{anchor.pixel - far, anchor.pixel + far};
    reach = reach ? PixelBox{glm::min(reach->low, around.low), glm::max(reach->high, around.high)} : around;
  }
  return reach;
}

} // namespace

bool LabelChoice::needsLeader() const { return distance >= firstWithLeader; }

LabelObstacles::Segment leaderTo(const PixelBox &box, glm::dvec2 anchor) {
  return {anchor, glm::clamp(anchor, box.low, box.high)};
}

bool LabelScreen::isCovered(const PixelBox &box) const {
  return std::any_of(covered.begin(), covered.end(),
                     [&](const PixelBox &other) { return overlapArea(box, other) > 0; });
}

LabelOptions::LabelOptions(const LabelRequest &request, const LabelScreen &screen, const LabelObstacles &all)
    : m_request(request), m_screen(screen) {
  if (const std::optional<PixelBox> reach = reachOf(request, screen.size, screen.pixelRatio))
    m_obstacles = obstaclesIn(*reach, all);
  if (request.owner != nobody)
    std::copy_if(m_obstacles.segments.begin(), m_obstacles.segments.end(), std::back_inserter(m_own),
                 [&](const LabelObstacles::Segment &segment) { return segment.owner == request.owner; });
}

double LabelOptions::reachToOwn(const LabelCandidate &candidate) const {
  if (m_own.empty())
    return distanceTo(candidate.box, candidate.anchor) - candidate.clearance;
  double least = std::numeric_limits<double>::infinity();
  for (const LabelObstacles::Segment &line : m_own)
    least = std::min(least, distanceTo(candidate.box, line.from, line.to));
  return least;
}

bool LabelOptions::canBeTakenForThatOf(LabelOwner owner, const LabelCandidate &candidate) const {
  return owner != nobody && owner != m_request.owner && !candidate.choice.needsLeader();
}

bool LabelOptions::isTakenForThatOf(const LabelObstacles::Disc &disc, const LabelCandidate &candidate,
                                    double reachToOwn) const {
  if (!canBeTakenForThatOf(disc.owner, candidate))
    return false;
  const double reach = distanceTo(candidate.box, disc.center);
  const bool isInPoint = glm::distance(disc.center, candidate.anchor) < disc.radius;
  if (!m_own.empty() && isInPoint)
    return reach - disc.radius < reachToOwn;
  const double toAnchor = distanceTo(candidate.box, candidate.anchor);
  return disc.center != candidate.anchor &&
         (reach < toAnchor || reach - disc.radius < toAnchor - candidate.clearance);
}

bool LabelOptions::isTakenForThatOf(const LabelObstacles::Segment &line, const LabelCandidate &candidate,
                                    double reachToOwn) const {
  if (!canBeTakenForThatOf(line.owner, candidate))
    return false;
  const bool isThroughAnchor = distanceToSegment(candidate.anchor, line.from, line.to) <= candidate.clearance;
  const bool isOnThinLine = !m_own.empty() && !m_own.front().isThick;
  if (isThroughAnchor && !(line.isThick && isOnThinLine))
    return false;
  return distanceTo(candidate.box, line.from, line.to) <= reachToOwn;
}

PixelBox LabelOptions::roomAround(const PixelBox &box) const {
  const glm::dvec2 aside(readTogether / 2 * m_screen.pixelRatio, 0);
  return {box.low - aside, box.high + aside};
}

const std::vector<LabelCandidate> &LabelOptions::candidates() const {
  if (!m_candidates)
    m_candidates = m_request.stand == LabelStand::Pinned   ? pinned()
                   : m_request.stand == LabelStand::ByHand ? byHand()
                                                           : beside();
  return *m_candidates;
}

std::optional<LabelCandidate> LabelOptions::chosen(const LabelChoice &choice) const {
  if (choice.anchor >= m_request.anchors.size() ||
      !isOnScreen(m_request.anchors[choice.anchor].pixel, m_screen.size))
    return {};
  const LabelAnchor &anchor = m_request.anchors[choice.anchor];
  const Way &way = waysAround()[choice.direction];
  const double gap = anchor.clearance + distances[choice.distance] * m_screen.pixelRatio;
  const PixelBox wanted = boxBeside(anchor.pixel, way, gap, m_request.extent);
  const PixelBox box = movedInside(wanted, m_screen.size);
  if (m_screen.isCovered(box))
    return {};
  const glm::dvec2 best = anchor.toward == glm::dvec2(0) ? glm::dvec2(0) : glm::normalize(anchor.toward);
  const double cost = costOfAnchor(choice.anchor) + costOfOtherSide * (1 - glm::dot(best, way.onCircle)) +
                      costOfDistance[choice.distance] + costOfLeaving * pushOf(box, wanted);
  return LabelCandidate{choice, box, cost, anchor.pixel, anchor.clearance, roomAround(box)};
}

double LabelOptions::costOfAnchor(std::size_t anchor) const {
  const auto first = m_request.anchors.begin();
  const auto better =
      std::count_if(first, first + static_cast<std::ptrdiff_t>(anchor),
                    [&](const auto &other) { return isOnScreen(other.pixel, m_screen.size); });
  return costOfNextAnchor * static_cast<double>(better);
}

std::vector<LabelCandidate> LabelOptions::pinned() const {
  for (std::size_t a = 0; a < m_request.anchors.size(); ++a) {
    const LabelAnchor &anchor = m_request.anchors[a];
    if (!isOnScreen(anchor.pixel, m_screen.size))
      continue;
    const PixelBox box{anchor.pixel - m_request.extent / 2.0, anchor.pixel + m_request.extent / 2.0};
    const PixelBox inside = movedInside(box, m_screen.size);
    if (pushOf(inside, box) > 0 || m_screen.isCovered(inside))
      return {};
    return {{{a, 0, 0}, inside, 0, anchor.pixel, anchor.clearance, roomAround(inside)}};
  }
  return {};
}

std::vector<LabelCandidate> LabelOptions::byHand() const {
  const LabelAnchor &anchor = m_request.anchors.front();
  const glm::dvec2 low = anchor.pixel + m_request.offset - m_request.extent / 2.0;
  const PixelBox wanted{low, low + m_request.extent};
  if (overlapArea(wanted, {{0, 0}, {m_screen.size.width, m_screen.size.height}}) <= 0)
    return {};
  const PixelBox box = movedInside(wanted, m_screen.size);
  const double way = distanceTo(box, anchor.pixel) - anchor.clearance;
  const bool isFar = way > distances[firstWithLeader] * m_screen.pixelRatio;
  return {{{0, 0, isFar ? firstWithLeader : 0}, box, 0, anchor.pixel, anchor.clearance, roomAround(box)}};
}

std::vector<LabelCandidate> LabelOptions::beside() const {
  std::vector<LabelCandidate> candidates;
  candidates.reserve(m_request.anchors.size() * directionCount * distances.size());
  for (std::size_t a = 0; a < m_request.anchors.size(); ++a)
    for (std::size_t way = 0; way < directionCount; ++way)
      for (std::size_t far = 0; far < distances.size(); ++far)
        if (const std::optional<LabelCandidate> candidate = chosen({a, way, far}))
          candidates.push_back(*candidate);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const LabelCandidate &a, const LabelCandidate &b) { return a.cost < b.cost; });
  return candidates;
}

} // namespace halfspace
