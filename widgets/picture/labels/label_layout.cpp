#include "widgets/picture/labels/label_layout.h"

#include "widgets/picture/screen_shapes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace halfspace {
namespace {

// What makes a place worse beside what is there. First what is a matter of liking …
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

/// Labels are gone through this often: from the second time on each sees where all others are.
constexpr int passes = 3;
/// Among more labels no two are placed together: there is no room to be found in such a crowd, and the search
/// for it would take longer than the picture.
constexpr std::size_t mostUntangled = 100;

} // namespace

double LabelLayout::costOf(const LabelCandidate &candidate, std::size_t label,
                           const LabelObstacles &obstacles, const Placed &placed, double limit) {
  double cost = candidate.cost;
  const PixelBox &box = candidate.box;
  const glm::dvec2 extent = box.extent();
  for (std::size_t other = 0; other < placed.size(); ++other) {
    if (other == label || !placed[other])
      continue;
    if (cost >= limit)
      return cost;
    const double overlap = overlapArea(box, placed[other]->box);
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

std::optional<LabelCandidate> LabelLayout::keptFor(std::size_t label, const std::string &id,
                                                   const LabelOptions &options, const Placed &placed) const {
  const auto previous = m_choices.find(id);
  if (previous == m_choices.end() || previous->second.needsLeader())
    return {};
  const std::optional<LabelCandidate> kept = options.chosen(previous->second);
  if (!kept || kept->cost >= costOfTouching)
    return {};
  const double limit = std::numeric_limits<double>::infinity();
  return costOf(*kept, label, options.obstacles(), placed, limit) > kept->cost ? std::nullopt : kept;
}

std::optional<LabelCandidate> LabelLayout::bestFor(std::size_t label, const std::string &id,
                                                   const LabelOptions &options, const Placed &placed) const {
  if (const std::optional<LabelCandidate> kept = keptFor(label, id, options, placed))
    return kept;
  const auto previous = m_choices.find(id);
  const LabelCandidate *cheapest = nullptr;
  double lowest = std::numeric_limits<double>::infinity();
  for (const LabelCandidate &candidate : options.candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    const bool isChange = previous != m_choices.end() && previous->second != candidate.choice;
    const double change = isChange ? costOfChange : 0;
    const double cost = costOf(candidate, label, options.obstacles(), placed, lowest - change) + change;
    if (cost < lowest) {
      lowest = cost;
      cheapest = &candidate;
    }
  }
  return cheapest ? std::optional(*cheapest) : std::nullopt;
}

void LabelLayout::placeTogether(std::size_t first, std::size_t second,
                                const std::vector<LabelRequest> &requests,
                                const std::vector<LabelOptions> &options, Placed &placed) const {
  const double limit = std::numeric_limits<double>::infinity();
  const auto costOfBoth = [&] {
    return costOf(*placed[first], first, options[first].obstacles(), placed, limit) +
           costOf(*placed[second], second, options[second].obstacles(), placed, limit);
  };
  auto best = std::pair(*placed[first], *placed[second]);
  double lowest = costOfBoth();
  for (const LabelCandidate &candidate : options[first].candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    placed[first] = candidate;
    placed[second].reset();
    if (costOf(candidate, first, options[first].obstacles(), placed, lowest) >= lowest)
      continue;
    placed[second] = bestFor(second, requests[second].id, options[second], placed);
    if (const double cost = costOfBoth(); cost < lowest) {
      lowest = cost;
      best = {candidate, *placed[second]};
    }
  }
  std::tie(placed[first], placed[second]) = best;
}

void LabelLayout::untangle(std::size_t first, const std::vector<std::size_t> &labels,
                           const std::vector<LabelRequest> &requests,
                           const std::vector<LabelOptions> &options, Placed &placed) const {
  for (const std::size_t second : labels)
    if (second != first && placed[first] && placed[second] &&
        overlapArea(placed[first]->box, placed[second]->box) > 0)
      placeTogether(first, second, requests, options, placed);
}

void LabelLayout::placeBeside(const std::vector<LabelRequest> &requests,
                              const std::vector<LabelOptions> &options, Placed &placed) const {
  std::vector<std::size_t> labels;
  for (std::size_t label = 0; label < requests.size(); ++label)
    if (requests[label].stand == LabelStand::Beside)
      labels.push_back(label);
  for (const std::size_t label : labels)
    if (const auto previous = m_choices.find(requests[label].id); previous != m_choices.end())
      placed[label] = options[label].chosen(previous->second);
  for (int pass = 0; pass < passes; ++pass) {
    for (const std::size_t label : labels)
      placed[label] = bestFor(label, requests[label].id, options[label], placed);
    if (labels.size() <= mostUntangled)
      for (const std::size_t label : labels)
        untangle(label, labels, requests, options, placed);
  }
}

std::vector<PlacedLabel> LabelLayout::place(const std::vector<LabelRequest> &requests,
                                            const LabelObstacles &obstacles, PixelSize size,
                                            double pixelRatio) {
  const LabelScreen screen{size, pixelRatio, obstacles.covered};
  Placed placed(requests.size());
  const auto with = [](LabelObstacles some, const std::vector<LabelObstacles::Segment> &more) {
    some.segments.insert(some.segments.end(), more.begin(), more.end());
    return some;
  };
  const LabelObstacles withTicks = with(obstacles, obstacles.ticks);
  const LabelObstacles withTools = with(withTicks, obstacles.tools);
  const auto obstaclesFor = [&](LabelStand stand) -> const LabelObstacles & {
    return stand == LabelStand::Pinned ? obstacles : stand == LabelStand::Beside ? withTicks : withTools;
  };
  std::vector<LabelOptions> options;
  options.reserve(requests.size());
  for (const LabelRequest &request : requests)
    options.emplace_back(request, screen, obstaclesFor(request.stand));

  const auto forEach = [&](LabelStand stand, const auto &visit) {
    for (std::size_t label = 0; label < requests.size(); ++label)
      if (requests[label].stand == stand)
        visit(label);
  };
  const auto canBeRead = [&](std::size_t label, const LabelCandidate &there) {
    const double limit = there.cost + costOfThickLine;
    return costOf(there, label, options[label].obstacles(), placed, limit) < limit;
  };
  const auto pin = [&](std::size_t label) {
    placed[label].reset();
    for (const LabelCandidate &only : options[label].candidates())
      if (canBeRead(label, only))
        placed[label] = only;
  };
  const auto settlePassing = [&](std::size_t label) {
    placed[label] = bestFor(label, requests[label].id, options[label], placed);
    if (placed[label] && !canBeRead(label, *placed[label]))
      placed[label].reset();
  };
  // What is pinned cannot move away, so the others do; where they cannot, it is left out.
  forEach(LabelStand::Pinned, pin);
  placeBeside(requests, options, placed);
  forEach(LabelStand::Pinned, pin);
  forEach(LabelStand::Passing, settlePassing);
  forEach(LabelStand::Pinned, pin);
  return taken(requests, placed);
}

std::vector<PlacedLabel> LabelLayout::taken(const std::vector<LabelRequest> &requests, const Placed &placed) {
  std::vector<PlacedLabel> result;
  m_choices.clear();
  for (std::size_t label = 0; label < requests.size(); ++label) {
    if (!placed[label])
      continue;
    const LabelCandidate &chosen = *placed[label];
    m_choices[requests[label].id] = chosen.choice;
    result.push_back({requests[label].id, chosen.box.low, chosen.box.extent(),
                      requests[label].anchors[chosen.choice.anchor].pixel, chosen.choice.needsLeader()});
  }
  return result;
}

} // namespace halfspace
