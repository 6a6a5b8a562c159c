#include "widgets/picture/labels/label_layout.h"

#include "widgets/picture/labels/written_row.h"
#include "widgets/picture/screen_shapes.h"

#include <algorithm>
#include <iterator>
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
/// Of another line as near as what is named: less than a leader, which would tell.
constexpr double costOfNearerLine = 12;
/// Of another label at its side: both together read as one.
constexpr double costOfReadTogether = 7;
// … of leaders, by what they go through: another label, a point that has one, another leader …
constexpr double costOfStruckLabel = 60;
constexpr double costOfStruckPoint = 30;
constexpr double costOfCrossedLeaders = 30;
// … then what makes it hard to read: more than what is liked less. An overlap counts besides by the part of
// the label that it takes.
constexpr double costOfTouching = 240;
constexpr double costOfOverlap = 280;
constexpr double costOfPoint = 240;
constexpr double costOfMistake = 120;
constexpr double costOfThickLine = 220;

/// Labels are gone through until none moves any more, and this often at most: from the second time on each
/// sees where all others are.
constexpr int mostPasses = 6;
/// Among more labels no two are placed together: there is no room to be found in such a crowd, and the search
/// for it would take longer than the picture.
constexpr std::size_t mostUntangled = 100;
/// So many places of a label are tried with the others making room for it.
constexpr std::size_t mostRooms = 16;
/// They do that only where all together are better by so much: half of a label that is taken for another's.
constexpr double leastGain = costOfMistake / 2;

/// Whether the leader of a label, if it has one, goes through another's box.
bool strikes(const LabelCandidate &label, const LabelCandidate &other) {
  if (!label.choice.needsLeader())
    return false;
  const LabelObstacles::Segment leader = leaderTo(label.box, label.anchor);
  return lengthInside(other.box, leader.from, leader.to) > 0;
}

bool haveCrossedLeaders(const LabelCandidate &one, const LabelCandidate &other) {
  if (!one.choice.needsLeader() || !other.choice.needsLeader())
    return false;
  const LabelObstacles::Segment first = leaderTo(one.box, one.anchor);
  const LabelObstacles::Segment second = leaderTo(other.box, other.anchor);
  return doCross(first.from, first.to, second.from, second.to);
}

bool areInEachOthersWay(const LabelCandidate &one, const LabelCandidate &other) {
  return overlapArea(one.box, other.box) > 0 || strikes(one, other) || strikes(other, one);
}

/// Whether all of them can be on the screen at once. Else most would lie on others wherever they are.
bool findRoom(const std::vector<LabelRequest> &requests, const std::vector<std::size_t> &labels,
              PixelSize size) {
  double area = 0;
  for (const std::size_t label : labels)
    area += requests[label].extent.x * requests[label].extent.y;
  return area < static_cast<double>(size.width) * size.height;
}

double costBeside(const LabelCandidate &candidate, const LabelCandidate &other) {
  const glm::dvec2 extent = candidate.box.extent();
  double cost = (strikes(candidate, other) ? costOfStruckLabel : 0) +
                (strikes(other, candidate) ? costOfStruckLabel : 0) +
                (haveCrossedLeaders(candidate, other) ? costOfCrossedLeaders : 0);
  if (const double overlap = overlapArea(candidate.box, other.box); overlap > 0)
    cost += costOfTouching + costOfOverlap * overlap / (extent.x * extent.y);
  else if (overlapArea(candidate.room, other.room) > 0)
    cost += costOfReadTogether;
  return cost;
}

/// Of a leader that goes through points that have labels of their own.
double costOfLeader(const LabelCandidate &candidate, const LabelObstacles &obstacles) {
  if (!candidate.choice.needsLeader())
    return 0;
  const LabelObstacles::Segment leader = leaderTo(candidate.box, candidate.anchor);
  const auto struck =
      std::count_if(obstacles.discs.begin(), obstacles.discs.end(), [&](const LabelObstacles::Disc &disc) {
        return disc.owner != nobody && disc.center != candidate.anchor &&
               distanceToSegment(disc.center, leader.from, leader.to) < disc.radius;
      });
  return costOfStruckPoint * static_cast<double>(struck);
}

/// The pinned labels, those of one row together and in its order.
std::vector<std::vector<std::size_t>> pinnedRows(const std::vector<LabelRequest> &requests) {
  std::vector<std::vector<std::size_t>> rows;
  std::map<std::size_t, std::size_t> byNumber;
  for (std::size_t label = 0; label < requests.size(); ++label) {
    if (requests[label].stand != LabelStand::Pinned)
      continue;
    const std::size_t number = requests[label].row.number;
    const auto [known, isNew] = byNumber.try_emplace(number, rows.size());
    if (isNew || number == 0)
      rows.push_back({label});
    else
      rows[known->second].push_back(label);
  }
  return rows;
}

/// Of all that is placed.
std::vector<LabelChoice> choicesOf(const std::vector<std::optional<LabelCandidate>> &placed) {
  std::vector<LabelChoice> choices;
  std::transform(
      placed.begin(), placed.end(), std::back_inserter(choices),
      [](const std::optional<LabelCandidate> &label) { return label ? label->choice : LabelChoice(); });
  return choices;
}

} // namespace

double LabelLayout::costOf(const LabelCandidate &candidate, std::size_t label, const LabelOptions &options,
                           const Placed &placed, double limit) {
  double cost = candidate.cost;
  const PixelBox &box = candidate.box;
  for (std::size_t other = 0; other < placed.size(); ++other) {
    if (other == label || !placed[other])
      continue;
    if (cost >= limit)
      return cost;
    cost += costBeside(candidate, *placed[other]);
  }
  const LabelObstacles &obstacles = options.obstacles();
  cost += costOfLeader(candidate, obstacles);
  const double toOwn = options.reachToOwn(candidate);
  for (const LabelObstacles::Disc &disc : obstacles.discs)
    if (distanceTo(box, disc.center) < disc.radius)
      cost += costOfPoint;
    else if (options.isTakenForThatOf(disc, candidate, toOwn))
      cost += costOfMistake;
  const double side = std::min(box.extent().x, box.extent().y);
  for (const LabelObstacles::Segment &segment : obstacles.segments) {
    if (cost >= limit)
      return cost;
    if (const double inside = lengthInside(box, segment.from, segment.to); inside > 0) {
      const double part = std::min(1.0, inside / side);
      cost += segment.isThick ? costOfThickLine * (1 + part)
                              : costOfThinLine * part + (part == 1 ? costOfStrike : 0);
    }
    if (options.isTakenForThatOf(segment, candidate, toOwn))
      cost += costOfNearerLine;
  }
  return cost;
}

std::optional<LabelCandidate> LabelLayout::keptFor(std::size_t label, const std::string &id,
                                                   const LabelOptions &options, const Placed &placed) const {
  const auto previous = m_choices.find(id);
  if (previous == m_choices.end() || previous->second.needsLeader())
    return {};
  const std::optional<LabelCandidate> kept = options.chosen(previous->second);
  if (!kept || kept->cost >= costOfMistake)
    return {};
  const double limit = std::numeric_limits<double>::infinity();
  return costOf(*kept, label, options, placed, limit) > kept->cost ? std::nullopt : kept;
}

std::optional<LabelChoice> LabelLayout::currentChoice(const std::string &id,
                                                      const std::optional<LabelCandidate> &placed) const {
  if (placed)
    return placed->choice;
  const auto previous = m_choices.find(id);
  return previous == m_choices.end() ? std::nullopt : std::optional(previous->second);
}

std::optional<LabelCandidate> LabelLayout::bestFor(std::size_t label, const std::string &id,
                                                   const LabelOptions &options, const Placed &placed) const {
  if (const std::optional<LabelCandidate> kept = keptFor(label, id, options, placed))
    return kept;
  const std::optional<LabelChoice> current = currentChoice(id, placed[label]);
  const LabelCandidate *cheapest = nullptr;
  double lowest = std::numeric_limits<double>::infinity();
  for (const LabelCandidate &candidate : options.candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    const double change = current && *current != candidate.choice ? costOfChange : 0;
    const double cost = costOf(candidate, label, options, placed, lowest - change) + change;
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
    return costOf(*placed[first], first, options[first], placed, limit) +
           costOf(*placed[second], second, options[second], placed, limit);
  };
  const LabelCandidate current = *placed[second]; // which it changes only for something better
  auto best = std::pair(*placed[first], current);
  double lowest = costOfBoth();
  for (const LabelCandidate &candidate : options[first].candidates()) {
    if (candidate.cost >= lowest)
      break; // they are sorted: those after it cost even more
    placed[first] = candidate;
    placed[second].reset();
    if (costOf(candidate, first, options[first], placed, lowest) >= lowest)
      continue;
    placed[second] = current;
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
        areInEachOthersWay(*placed[first], *placed[second]))
      placeTogether(first, second, requests, options, placed);
}

double LabelLayout::costOfAll(const std::vector<std::size_t> &labels,
                              const std::vector<LabelOptions> &options, const Placed &placed, double limit) {
  double cost = 0;
  for (const std::size_t label : labels)
    if (placed[label] && cost < limit)
      cost += costOf(*placed[label], label, options[label], placed, limit - cost);
  return cost;
}

LabelLayout::Placed LabelLayout::withRoomFor(const LabelCandidate &candidate, std::size_t first,
                                             const std::vector<std::size_t> &labels,
                                             const std::vector<LabelRequest> &requests,
                                             const std::vector<LabelOptions> &options, Placed placed) const {
  placed[first] = candidate;
  std::vector<std::pair<std::size_t, LabelCandidate>> moved;
  for (const std::size_t label : labels)
    if (label != first && placed[label] && areInEachOthersWay(candidate, *placed[label])) {
      moved.emplace_back(label, *placed[label]);
      placed[label].reset();
    }
  for (const auto &[label, current] : moved) {
    placed[label] = current; // which it changes only for something better
    placed[label] = bestFor(label, requests[label].id, options[label], placed);
  }
  return placed;
}

void LabelLayout::makeRoom(std::size_t first, const std::vector<std::size_t> &labels,
                           const std::vector<LabelRequest> &requests,
                           const std::vector<LabelOptions> &options, Placed &placed) const {
  const auto isHardToRead = [&](const LabelCandidate &there, const Placed &others) {
    const double limit = there.cost + costOfMistake;
    return costOf(there, first, options[first], others, limit) >= limit;
  };
  if (!placed[first] || !isHardToRead(*placed[first], placed))
    return;
  const Placed none(placed.size());
  Placed best = placed;
  double lowest = costOfAll(labels, options, placed, std::numeric_limits<double>::infinity()) - leastGain;
  std::size_t tried = 0;
  for (const LabelCandidate &candidate : options[first].candidates()) {
    if (tried == mostRooms)
      break;
    if (isHardToRead(candidate, none))
      continue;
    ++tried;
    Placed other = withRoomFor(candidate, first, labels, requests, options, placed);
    if (const double cost = costOfAll(labels, options, other, lowest); cost < lowest) {
      lowest = cost;
      best = std::move(other);
    }
  }
  placed = std::move(best);
}

void LabelLayout::placeBeside(const std::vector<LabelRequest> &requests,
                              const std::vector<LabelOptions> &options, PixelSize size,
                              Placed &placed) const {
  std::vector<std::size_t> labels;
  for (std::size_t label = 0; label < requests.size(); ++label)
    if (requests[label].stand == LabelStand::Beside)
      labels.push_back(label);
  for (const std::size_t label : labels)
    if (const auto previous = m_choices.find(requests[label].id); previous != m_choices.end())
      placed[label] = options[label].chosen(previous->second);
  const bool isWorthUntangling = labels.size() <= mostUntangled && findRoom(requests, labels, size);
  bool haveMoved = true;
  for (int pass = 0; pass < mostPasses && haveMoved; ++pass) {
    const std::vector<LabelChoice> before = choicesOf(placed);
    for (const std::size_t label : labels)
      placed[label] = bestFor(label, requests[label].id, options[label], placed);
    if (isWorthUntangling)
      for (const std::size_t label : labels) {
        untangle(label, labels, requests, options, placed);
        makeRoom(label, labels, requests, options, placed);
      }
    haveMoved = before != choicesOf(placed);
  }
}

bool LabelLayout::canBeRead(const LabelCandidate &there, std::size_t label, const LabelOptions &options,
                            const Placed &placed) {
  const double limit = there.cost + costOfThickLine;
  return costOf(there, label, options, placed, limit) < limit;
}

void LabelLayout::pinRow(const std::vector<std::size_t> &row, const std::vector<LabelRequest> &requests,
                         const std::vector<LabelOptions> &options, Placed &placed) {
  for (const std::size_t label : row)
    placed[label].reset();
  const auto isStruck = [&](const LabelCandidate &there) {
    return std::any_of(placed.begin(), placed.end(), [&](const std::optional<LabelCandidate> &other) {
      return other && strikes(*other, there);
    });
  };
  std::vector<std::size_t> seen;
  std::vector<RowNumber> numbers;
  for (const std::size_t label : row)
    for (const LabelCandidate &only : options[label].candidates()) {
      const bool isRead = canBeRead(only, label, options[label], placed) && !isStruck(only);
      seen.push_back(label);
      numbers.push_back({requests[label].row.place, only.room, isRead});
    }
  const std::vector<bool> written = writtenOf(numbers);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (written[i])
      placed[seen[i]] = options[seen[i]].candidates().front();
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

  const std::vector<std::vector<std::size_t>> rows = pinnedRows(requests);
  const auto pin = [&] {
    for (const std::vector<std::size_t> &row : rows)
      pinRow(row, requests, options, placed);
  };
  // All others keep clear of what somebody has put somewhere.
  for (std::size_t label = 0; label < requests.size(); ++label)
    if (requests[label].stand == LabelStand::ByHand && !options[label].candidates().empty())
      placed[label] = options[label].candidates().front();
  // What is pinned cannot move away, so the others do; where they cannot, it is left out.
  pin();
  placeBeside(requests, options, size, placed);
  pin();
  for (std::size_t label = 0; label < requests.size(); ++label)
    if (requests[label].stand == LabelStand::Passing) {
      placed[label] = bestFor(label, requests[label].id, options[label], placed);
      if (placed[label] && !canBeRead(*placed[label], label, options[label], placed))
        placed[label].reset();
    }
  pin();
  return taken(requests, placed);
}

std::vector<PlacedLabel> LabelLayout::taken(const std::vector<LabelRequest> &requests, const Placed &placed) {
  std::vector<PlacedLabel> result;
  m_choices.clear();
  for (std::size_t label = 0; label < requests.size(); ++label) {
    if (!placed[label])
      continue;
    const LabelCandidate &chosen = *placed[label];
    if (requests[label].stand != LabelStand::ByHand) // put back, it begins anew
      m_choices[requests[label].id] = chosen.choice;
    result.push_back({requests[label].id, chosen.box.low, chosen.box.extent(),
                      requests[label].anchors[chosen.choice.anchor].pixel, chosen.choice.needsLeader()});
  }
  return result;
}

} // namespace halfspace
