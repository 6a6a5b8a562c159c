#include "widgets/picture/labels/label_layout.h"

#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace halfspace {
namespace {

/// Directions around an anchor, and the distances that are tried, in design pixels; the last ones need a
/// leader line.
constexpr std::size_t directionCount = 12;
constexpr std::array<double, 5> distances{3, 16, 38, 70, 110};
constexpr std::size_t firstWithLeader = 2;

// What makes a candidate worse. First what is a matter of liking …
constexpr double costOfOtherSide = 7;
constexpr double costOfNextAnchor = 6;
constexpr std::array<double, distances.size()> costOfDistance{0, 7, 22, 40, 60};
constexpr double costOfChange = 9;
constexpr double costOfThinLine = 16;
/// Of a thin line that goes through from side to side: a label is better farther off than struck through.
constexpr double costOfStrike = 24;
// … then what makes it hard to read: more than all of that together. An overlap counts besides by the part of
// the label that it takes.
constexpr double costOfTouching = 120;
constexpr double costOfOverlap = 140;
constexpr double costOfPoint = 120;
constexpr double costOfMistake = 60;
constexpr double costOfThickLine = 110;
constexpr double costOfLeaving = 200;

/// A box that the screen's edge pushes by less than this part of its size still stands where it was wanted.
constexpr double freePush = 0.02;

/// Labels are gone through this often: from the second time on each sees where all others are.
constexpr int passes = 3;
/// Among more labels no two are placed together: there is no room to be found in such a crowd, and the search
/// for it would take longer than the picture.
constexpr std::size_t mostUntangled = 100;

/// The obstacles that touch a box, and the points that a label in it could be taken for that of.
LabelObstacles obstaclesIn(const PixelBox &box, const LabelObstacles &all) {
  LabelObstacles found;
  std::copy_if(all.discs.begin(), all.discs.end(), std::back_inserter(found.discs),
               [&](const LabelObstacles::Disc &disc) {
                 return disc.hasLabel || distanceTo(box, disc.center) < disc.radius;
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

struct LabelLayout::Candidate {
  Choice choice;
  PixelBox box;
  double cost = 0; ///< by itself, whatever else is on the screen
  glm::dvec2 anchor{};
  double clearance = 0;

  /// Whether it stands nearer to a point with a name than to what it names, from edge to edge or from middle
  /// to middle; a leader tells which that is.
  [[nodiscard]] bool isNearerTo(const LabelObstacles::Disc &disc) const {
    if (!disc.hasLabel || disc.center == anchor || choice.distance >= firstWithLeader)
      return false;
    const double reach = distanceTo(box, disc.center);
    const double ownReach = distanceTo(box, anchor);
    return reach < ownReach || reach - disc.radius < ownReach - clearance;
  }
};

/// All that is on the screen while labels are placed.
struct LabelLayout::Board {
  PixelSize size;
  double pixelRatio;
  const std::vector<PixelBox> &covered;
  std::vector<std::optional<Candidate>> placed; ///< by the label's number

  [[nodiscard]] bool isCovered(const PixelBox &box) const {
    return std::any_of(covered.begin(), covered.end(),
                       [&](const PixelBox &other) { return overlapArea(box, other) > 0; });
  }
};

/// Where a label may stand, and what it may come upon there: each obstacle is looked at once for a label
/// before it is for each of its places. Mostly a label stays where it was, and its other places are never
/// worked out.
class LabelLayout::Options {
public:
  /// Requires that request and board live longer.
  Options(const LabelRequest &request, const Board &board, const LabelObstacles &all)
      : m_request(request), m_board(board) {
    if (const std::optional<PixelBox> reach = reachOf(request, board.size, board.pixelRatio))
      m_obstacles = obstaclesIn(*reach, all);
  }

  [[nodiscard]] const LabelObstacles &obstacles() const { return m_obstacles; }

  /// All places, the cheapest first.
  [[nodiscard]] const std::vector<Candidate> &candidates() const {
    if (!m_candidates)
      m_candidates = m_request.stand == LabelStand::Pinned ? pinned() : beside();
    return *m_candidates;
  }

  /// The place of a choice; nothing where the label may not stand there any more. Not for what is pinned.
  [[nodiscard]] std::optional<Candidate> chosen(const Choice &choice) const {
    if (choice.anchor >= m_request.anchors.size() || !isOnScreen(anchorOf(choice).pixel, m_board.size))
      return {};
    const LabelAnchor &anchor = anchorOf(choice);
    const Way &way = waysAround()[choice.direction];
    const double gap = anchor.clearance + distances[choice.distance] * m_board.pixelRatio;
    const PixelBox wanted = boxBeside(anchor.pixel, way, gap, m_request.extent);
    const PixelBox box = movedInside(wanted, m_board.size);
    if (m_board.isCovered(box))
      return {};
    const glm::dvec2 best = anchor.toward == glm::dvec2(0) ? glm::dvec2(0) : glm::normalize(anchor.toward);
    const double cost = costOfAnchor(choice.anchor) + costOfOtherSide * (1 - glm::dot(best, way.onCircle)) +
                        costOfDistance[choice.distance] + costOfLeaving * pushOf(box, wanted);
    return Candidate{choice, box, cost, anchor.pixel, anchor.clearance};
  }

private:
  [[nodiscard]] const LabelAnchor &anchorOf(const Choice &choice) const {
    return m_request.anchors[choice.anchor];
  }

  /// What an anchor costs because others on the screen are liked better.
  [[nodiscard]] double costOfAnchor(std::size_t anchor) const {
    const auto first = m_request.anchors.begin();
    const auto better =
        std::count_if(first, first + static_cast<std::ptrdiff_t>(anchor),
                      [&](const auto &other) { return isOnScreen(other.pixel, m_board.size); });
    return costOfNextAnchor * static_cast<double>(better);
  }

  [[nodiscard]] std::vector<Candidate> pinned() const {
    for (std::size_t a = 0; a < m_request.anchors.size(); ++a) {
      const LabelAnchor &anchor = m_request.anchors[a];
      if (!isOnScreen(anchor.pixel, m_board.size))
        continue;
      const PixelBox box{anchor.pixel - m_request.extent / 2.0, anchor.pixel + m_request.extent / 2.0};
      const PixelBox inside = movedInside(box, m_board.size);
      if (pushOf(inside, box) > 0 || m_board.isCovered(inside))
        return {};
      return {{{a, 0, 0}, inside, 0, anchor.pixel, anchor.clearance}};
    }
    return {};
  }

  [[nodiscard]] std::vector<Candidate> beside() const {
    std::vector<Candidate> candidates;
    candidates.reserve(m_request.anchors.size() * directionCount * distances.size());
    for (std::size_t a = 0; a < m_request.anchors.size(); ++a)
      for (std::size_t way = 0; way < directionCount; ++way)
        for (std::size_t far = 0; far < distances.size(); ++far)
          if (const std::optional<Candidate> candidate = chosen({a, way, far}))
            candidates.push_back(*candidate);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate &a, const Candidate &b) { return a.cost < b.cost; });
    return candidates;
  }

  const LabelRequest &m_request;
  const Board &m_board;
  LabelObstacles m_obstacles;
  mutable std::optional<std::vector<Candidate>> m_candidates; ///< worked out when asked
};

double LabelLayout::costOf(const Candidate &candidate, std::size_t label, const LabelObstacles &obstacles,
                           const Board &board, double limit) {
  double cost = candidate.cost;
  const PixelBox &box = candidate.box;
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
    else if (candidate.isNearerTo(disc))
      cost += costOfMistake;
  for (const LabelObstacles::Segment &segment : obstacles.segments) {
    if (cost >= limit)
      return cost;
    const double inside = lengthInside(box, segment.from, segment.to);
    if (inside <= 0)
      continue;
    const double part = std::min(1.0, inside / std::min(extent.x, extent.y));
    cost += segment.isThick ? costOfThickLine * (1 + part)
                            : costOfThinLine * part + (part == 1 ? costOfStrike : 0);
  }
  return cost;
}

std::optional<LabelLayout::Candidate> LabelLayout::keptFor(std::size_t label, const std::string &id,
                                                           const Options &options, const Board &board) const {
  const auto previous = m_choices.find(id);
  if (previous == m_choices.end() || previous->second.distance >= firstWithLeader)
    return {};
  const std::optional<Candidate> kept = options.chosen(previous->second);
  if (!kept || kept->cost >= costOfTouching)
    return {};
  const double limit = std::numeric_limits<double>::infinity();
  return costOf(*kept, label, options.obstacles(), board, limit) > kept->cost ? std::nullopt : kept;
}

std::optional<LabelLayout::Candidate> LabelLayout::bestFor(std::size_t label, const std::string &id,
                                                           const Options &options, const Board &board) const {
  if (const std::optional<Candidate> kept = keptFor(label, id, options, board))
    return kept;
  const auto previous = m_choices.find(id);
  const Candidate *cheapest = nullptr;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Candidate &candidate : options.candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    const bool isChange = previous != m_choices.end() && previous->second != candidate.choice;
    const double change = isChange ? costOfChange : 0;
    const double cost = costOf(candidate, label, options.obstacles(), board, lowest - change) + change;
    if (cost < lowest) {
      lowest = cost;
      cheapest = &candidate;
    }
  }
  return cheapest ? std::optional(*cheapest) : std::nullopt;
}

void LabelLayout::placeTogether(std::size_t first, std::size_t second,
                                const std::vector<LabelRequest> &requests,
                                const std::vector<Options> &options, Board &board) const {
  const double limit = std::numeric_limits<double>::infinity();
  const auto costOfBoth = [&] {
    return costOf(*board.placed[first], first, options[first].obstacles(), board, limit) +
           costOf(*board.placed[second], second, options[second].obstacles(), board, limit);
  };
  auto best = std::pair(*board.placed[first], *board.placed[second]);
  double lowest = costOfBoth();
  for (const Candidate &candidate : options[first].candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    board.placed[first] = candidate;
    board.placed[second].reset();
    if (costOf(candidate, first, options[first].obstacles(), board, lowest) >= lowest)
      continue;
    board.placed[second] = bestFor(second, requests[second].id, options[second], board);
    if (const double cost = costOfBoth(); cost < lowest) {
      lowest = cost;
      best = {candidate, *board.placed[second]};
    }
  }
  std::tie(board.placed[first], board.placed[second]) = best;
}

void LabelLayout::untangle(std::size_t first, const std::vector<std::size_t> &labels,
                           const std::vector<LabelRequest> &requests, const std::vector<Options> &options,
                           Board &board) const {
  for (const std::size_t second : labels)
    if (second != first && board.placed[first] && board.placed[second] &&
        overlapArea(board.placed[first]->box, board.placed[second]->box) > 0)
      placeTogether(first, second, requests, options, board);
}

void LabelLayout::placeBeside(const std::vector<LabelRequest> &requests, const std::vector<Options> &options,
                              Board &board) const {
  std::vector<std::size_t> labels;
  for (std::size_t label = 0; label < requests.size(); ++label)
    if (requests[label].stand == LabelStand::Beside)
      labels.push_back(label);
  for (const std::size_t label : labels)
    if (const auto previous = m_choices.find(requests[label].id); previous != m_choices.end())
      board.placed[label] = options[label].chosen(previous->second);
  for (int pass = 0; pass < passes; ++pass) {
    for (const std::size_t label : labels)
      board.placed[label] = bestFor(label, requests[label].id, options[label], board);
    if (labels.size() <= mostUntangled)
      for (const std::size_t label : labels)
        untangle(label, labels, requests, options, board);
  }
}

std::vector<PlacedLabel> LabelLayout::place(const std::vector<LabelRequest> &requests,
                                            const LabelObstacles &obstacles, PixelSize size,
                                            double pixelRatio) {
  Board board{size, pixelRatio, obstacles.covered, std::vector<std::optional<Candidate>>(requests.size())};
  const auto with = [](LabelObstacles some, const std::vector<LabelObstacles::Segment> &more) {
    some.segments.insert(some.segments.end(), more.begin(), more.end());
    return some;
  };
  const LabelObstacles withTicks = with(obstacles, obstacles.ticks);
  const LabelObstacles withTools = with(withTicks, obstacles.tools);
  const auto obstaclesFor = [&](LabelStand stand) -> const LabelObstacles & {
    return stand == LabelStand::Pinned ? obstacles : stand == LabelStand::Beside ? withTicks : withTools;
  };
  std::vector<Options> options;
  options.reserve(requests.size());
  for (const LabelRequest &request : requests)
    options.emplace_back(request, board, obstaclesFor(request.stand));

  const auto forEach = [&](LabelStand stand, const auto &visit) {
    for (std::size_t label = 0; label < requests.size(); ++label)
      if (requests[label].stand == stand)
        visit(label);
  };
  const auto canBeRead = [&](std::size_t label, const Candidate &there) {
    const double limit = there.cost + costOfThickLine;
    return costOf(there, label, options[label].obstacles(), board, limit) < limit;
  };
  const auto pin = [&](std::size_t label) {
    board.placed[label].reset();
    for (const Candidate &only : options[label].candidates())
      if (canBeRead(label, only))
        board.placed[label] = only;
  };
  const auto settlePassing = [&](std::size_t label) {
    board.placed[label] = bestFor(label, requests[label].id, options[label], board);
    if (board.placed[label] && !canBeRead(label, *board.placed[label]))
      board.placed[label].reset();
  };
  // What is pinned cannot move away, so the others do; where they cannot, it is left out.
  forEach(LabelStand::Pinned, pin);
  placeBeside(requests, options, board);
  forEach(LabelStand::Pinned, pin);
  forEach(LabelStand::Passing, settlePassing);
  forEach(LabelStand::Pinned, pin);
  return taken(requests, board);
}

std::vector<PlacedLabel> LabelLayout::taken(const std::vector<LabelRequest> &requests, const Board &board) {
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
