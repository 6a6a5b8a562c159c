#include "widgets/picture/labels/label_layout.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace halfspace {
namespace {

/// Directions around an anchor, and the distances that are tried, in design pixels; the last ones need a
/// leader line.
constexpr std::size_t directionCount = 12;
constexpr std::array<double, 4> distances{3, 16, 38, 70};
constexpr std::size_t firstWithLeader = 2;

// What makes a candidate worse. An overlap counts by the part of the label that it takes.
constexpr double costOfOtherSide = 7;
constexpr double costOfNextAnchor = 6;
constexpr std::array<double, 4> costOfDistance{0, 7, 22, 40};
constexpr double costOfOverlap = 140;
constexpr double costOfTouching = 24;
constexpr double costOfPoint = 45;
constexpr double costOfLine = 16;
constexpr double costOfChange = 9;
constexpr double costOfLeaving = 200;

/// A box that the screen's edge pushes by less than this part of its size still stands where it was wanted.
constexpr double freePush = 0.02;

/// Labels are gone through this often: the second time each sees where all others are.
constexpr int passes = 2;

struct Rectangle {
  glm::dvec2 low{};
  glm::dvec2 high{};

  [[nodiscard]] glm::dvec2 extent() const { return high - low; }
};

double overlapArea(const Rectangle &a, const Rectangle &b) {
  const glm::dvec2 common = glm::min(a.high, b.high) - glm::max(a.low, b.low);
  return std::max(0.0, common.x) * std::max(0.0, common.y);
}

double distanceTo(const Rectangle &box, glm::dvec2 pixel) {
  return glm::distance(pixel, glm::clamp(pixel, box.low, box.high));
}

/// The length of the part of a segment that lies in a box.
double lengthInside(const Rectangle &box, const LabelObstacles::Segment &segment) {
  const glm::dvec2 low = glm::min(segment.from, segment.to);
  const glm::dvec2 high = glm::max(segment.from, segment.to);
  if (high.x < box.low.x || high.y < box.low.y || low.x > box.high.x || low.y > box.high.y)
    return 0;
  const glm::dvec2 along = segment.to - segment.from;
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0)
      continue;
    const double a = (box.low[axis] - segment.from[axis]) / along[axis];
    const double b = (box.high[axis] - segment.from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return std::max(0.0, leave - enter) * glm::length(along);
}

/// The obstacles that touch a box.
LabelObstacles obstaclesIn(const Rectangle &box, const LabelObstacles &all) {
  LabelObstacles found;
  std::copy_if(all.discs.begin(), all.discs.end(), std::back_inserter(found.discs),
               [&](const LabelObstacles::Disc &disc) { return distanceTo(box, disc.center) < disc.radius; });
  std::copy_if(all.segments.begin(), all.segments.end(), std::back_inserter(found.segments),
               [&](const LabelObstacles::Segment &segment) { return lengthInside(box, segment) > 0; });
  return found;
}

/// A direction around an anchor: on the unit circle, and on the square around it.
struct Way {
  glm::dvec2 onCircle;
  glm::dvec2 onSquare;
};

std::array<Way, directionCount> waysAround() {
  std::array<Way, directionCount> ways;
  for (std::size_t i = 0; i < directionCount; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / directionCount;
    const glm::dvec2 toward(std::cos(angle), std::sin(angle));
    ways[i] = {toward, toward / std::max(std::abs(toward.x), std::abs(toward.y))};
  }
  return ways;
}

/// The box beside an anchor: its side or corner that faces the anchor is `gap` away from it.
Rectangle boxBeside(glm::dvec2 anchor, const Way &way, double gap, glm::dvec2 extent) {
  const glm::dvec2 low = anchor + way.onCircle * gap + (way.onSquare - 1.0) * extent / 2.0;
  return {low, low + extent};
}

/// The box moved into the screen, as far as it fits, and onto whole pixels.
Rectangle movedInside(const Rectangle &box, PixelSize size) {
  const glm::dvec2 extent = box.extent();
  const glm::dvec2 room = glm::max(glm::dvec2(0), glm::dvec2(size.width, size.height) - extent);
  const glm::dvec2 low = glm::floor(glm::clamp(box.low, glm::dvec2(0), room) + 0.5);
  return {low, low + extent};
}

bool isOnScreen(glm::dvec2 pixel, PixelSize size) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x <= size.width && pixel.y <= size.height;
}

} // namespace

struct LabelLayout::Candidate {
  Choice choice;
  Rectangle box;
  double cost = 0; ///< by itself, whatever else is on the screen
};

/// Where a label may stand, the cheapest place first, and what it may come upon there: each obstacle is
/// looked at once for a label before it is for each of its candidates.
struct LabelLayout::Options {
  std::vector<Candidate> candidates;
  LabelObstacles obstacles;

  Options(std::vector<Candidate> places, const LabelObstacles &all) : candidates(std::move(places)) {
    if (candidates.empty())
      return;
    Rectangle reach = candidates.front().box;
    for (const Candidate &candidate : candidates)
      reach = {glm::min(reach.low, candidate.box.low), glm::max(reach.high, candidate.box.high)};
    obstacles = obstaclesIn(reach, all);
  }
};

/// All that is on the screen while labels are placed.
struct LabelLayout::Board {
  PixelSize size;
  double pixelRatio;
  std::vector<std::optional<Candidate>> placed; ///< by the label's number
};

std::vector<LabelLayout::Candidate> LabelLayout::candidatesOf(const LabelRequest &request,
                                                              const Board &board) {
  static const std::array ways = waysAround();
  std::vector<Candidate> candidates;
  candidates.reserve(request.anchors.size() * directionCount * distances.size());
  double liking = 0;
  for (std::size_t a = 0; a < request.anchors.size(); ++a) {
    const LabelAnchor &anchor = request.anchors[a];
    if (!isOnScreen(anchor.pixel, board.size))
      continue;
    if (request.isPinned) {
      const Rectangle box{anchor.pixel - request.extent / 2.0, anchor.pixel + request.extent / 2.0};
      return {{{a, 0, 0}, movedInside(box, board.size), 0}};
    }
    const glm::dvec2 best = anchor.toward == glm::dvec2(0) ? glm::dvec2(0) : glm::normalize(anchor.toward);
    for (std::size_t way = 0; way < directionCount; ++way)
      for (std::size_t far = 0; far < distances.size(); ++far) {
        const double gap = anchor.clearance + distances[far] * board.pixelRatio;
        const Rectangle wanted = boxBeside(anchor.pixel, ways[way], gap, request.extent);
        const Rectangle box = movedInside(wanted, board.size);
        const double pushed = glm::distance(wanted.low, box.low) / (request.extent.x + request.extent.y);
        const double cost = liking + costOfOtherSide * (1 - glm::dot(best, ways[way].onCircle)) +
                            costOfDistance[far] + costOfLeaving * std::max(0.0, pushed - freePush);
        candidates.push_back({{a, way, far}, box, cost});
      }
    liking += costOfNextAnchor;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate &a, const Candidate &b) { return a.cost < b.cost; });
  return candidates;
}

double LabelLayout::costOf(const Candidate &candidate, std::size_t label, const LabelObstacles &obstacles,
                           const Board &board, double limit) {
  double cost = candidate.cost;
  const Rectangle &box = candidate.box;
  const glm::dvec2 extent = box.extent();
  for (std::size_t other = 0; other < board.placed.size(); ++other) {
    if (other == label || !board.placed[other])
      continue;
    if (cost >= limit)
      return cost;
    const double overlap = overlapArea(box, board.placed[other]->box);
    cost += costOfOverlap * overlap / (extent.x * extent.y) + (overlap > 0 ? costOfTouching : 0);
  }
  for (const LabelObstacles::Disc &disc : obstacles.discs)
    if (distanceTo(box, disc.center) < disc.radius)
      cost += costOfPoint;
  for (const LabelObstacles::Segment &segment : obstacles.segments) {
    if (cost >= limit)
      return cost;
    cost += costOfLine * std::min(1.0, 2 * lengthInside(box, segment) / (extent.x + extent.y));
  }
  return cost;
}

std::optional<LabelLayout::Candidate> LabelLayout::cheapestFor(std::size_t label, const std::string &id,
                                                               const Options &options,
                                                               const Board &board) const {
  const auto previous = m_choices.find(id);
  const Candidate *cheapest = nullptr;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Candidate &candidate : options.candidates) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    const bool isChange = previous != m_choices.end() && previous->second != candidate.choice;
    const double change = isChange ? costOfChange : 0;
    const double cost = costOf(candidate, label, options.obstacles, board, lowest - change) + change;
    if (cost < lowest) {
      lowest = cost;
      cheapest = &candidate;
    }
  }
  return cheapest ? std::optional(*cheapest) : std::nullopt;
}

std::vector<PlacedLabel> LabelLayout::place(const std::vector<LabelRequest> &requests,
                                            const LabelObstacles &obstacles, PixelSize size,
                                            double pixelRatio) {
  Board board{size, pixelRatio, std::vector<std::optional<Candidate>>(requests.size())};
  std::vector<Options> options;
  options.reserve(requests.size());
  for (std::size_t label = 0; label < requests.size(); ++label) {
    options.emplace_back(candidatesOf(requests[label], board), obstacles);
    if (requests[label].isPinned && !options.back().candidates.empty())
      board.placed[label] = options.back().candidates.front();
  }
  // Every label takes the cheapest candidate beside those placed before it; the second time, beside all
  // others. Those that yield come when all others have their places.
  for (const bool yields : {false, true})
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t label = 0; label < requests.size(); ++label)
        if (!requests[label].isPinned && requests[label].yields == yields)
          board.placed[label] = cheapestFor(label, requests[label].id, options[label], board);

  std::vector<PlacedLabel> result;
  m_choices.clear();
  for (std::size_t label = 0; label < requests.size(); ++label) {
    if (!board.placed[label])
      continue;
    const Candidate &chosen = *board.placed[label];
    m_choices[requests[label].id] = chosen.choice;
    result.push_back({requests[label].id, chosen.box.low, chosen.box.extent(),
                      requests[label].anchors[chosen.choice.anchor].pixel,
                      chosen.choice.distance >= firstWithLeader});
  }
  return result;
}

} // namespace halfspace
