#include "widgets/exports/painting.h"

#include "widgets/exports/page_polygon.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

namespace halfspace {
namespace {

/// The pen around opaque faces, in points.
constexpr double rim = 0.3;
/// What is nearer to the eye by less than this part is as near.
constexpr double asNear = 1e-7;

PixelBox boxOf(const PaintedThing &thing) {
  std::vector<glm::dvec2> spots;
  std::transform(thing.spine.begin(), thing.spine.end(), std::back_inserter(spots),
                 [](const Spot &spot) { return spot.at; });
  return grown(boxAround(spots), thing.reach);
}

struct SpotPair {
  Spot one;
  Spot other;
};

Spot mixed(const Spot &from, const Spot &to, double part) {
  return {glm::mix(from.at, to.at, part), glm::mix(from.nearness, to.nearness, part)};
}

Spot nearestOn(const Spot &from, const Spot &to, glm::dvec2 spot) {
  const glm::dvec2 along = to.at - from.at;
  const double square = glm::dot(along, along);
  return mixed(from, to, square > 0 ? glm::clamp(glm::dot(spot - from.at, along) / square, 0.0, 1.0) : 0);
}

/// Where two straight pieces cross on the page, or else come nearest to each other.
SpotPair nearestOf(const Spot &from, const Spot &to, const Spot &otherFrom, const Spot &otherTo) {
  const glm::dvec2 along = to.at - from.at;
  const glm::dvec2 otherAlong = otherTo.at - otherFrom.at;
  if (const double turn = crossOf(along, otherAlong); turn != 0) {
    const double part = crossOf(otherFrom.at - from.at, otherAlong) / turn;
    const double otherPart = crossOf(otherFrom.at - from.at, along) / turn;
    if (part >= 0 && part <= 1 && otherPart >= 0 && otherPart <= 1)
      return {mixed(from, to, part), mixed(otherFrom, otherTo, otherPart)};
  }
  const SpotPair ends[] = {{from, nearestOn(otherFrom, otherTo, from.at)},
                           {to, nearestOn(otherFrom, otherTo, to.at)},
                           {nearestOn(from, to, otherFrom.at), otherFrom},
                           {nearestOn(from, to, otherTo.at), otherTo}};
  return *std::min_element(std::begin(ends), std::end(ends), [](const SpotPair &a, const SpotPair &b) {
    return glm::distance(a.one.at, a.other.at) < glm::distance(b.one.at, b.other.at);
  });
}

/// Finds the order: a veil or a thing (which are counted on behind the veils) is painted when all that it
/// lies over are.
class PaintingOrder {
public:
  PaintingOrder(const Veils &veils, const std::vector<VeilLook> &looks,
                const std::vector<PaintedThing> &things)
      : m_veils(veils), m_looks(looks), m_things(things), m_after(veils.count() + things.size()),
        m_before(m_after.size()), m_open(veils.count() + things.size()) {
    orderVeils();
    for (std::size_t i = 0; i < things.size(); ++i) {
      for (const std::size_t veil : things[i].veils.before)
        paintFirst(veil, veils.count() + i);
      for (const std::size_t veil : things[i].veils.behind)
        paintFirst(veils.count() + i, veil);
    }
    orderThings();
  }

  [[nodiscard]] std::vector<std::size_t> find() {
    std::set<std::size_t> ready;
    std::set<std::size_t> waiting;
    for (std::size_t i = 0; i < m_open.size(); ++i)
      (m_open[i] == 0 ? ready : waiting).insert(i);
    std::vector<std::size_t> order;
    while (!ready.empty() || !waiting.empty()) {
      const std::size_t next = ready.empty() ? firstOfRing(waiting) : chosen(ready, order);
      ready.erase(next);
      waiting.erase(next);
      order.push_back(next);
      for (const std::size_t after : m_after[next])
        if (--m_open[after] == 0 && waiting.erase(after) > 0)
          ready.insert(after);
    }
    return order;
  }

private:
  void paintFirst(std::size_t lower, std::size_t upper) {
    m_after[lower].push_back(upper);
    m_before[upper].push_back(lower);
    ++m_open[upper];
  }

  void orderVeils() {
    const bool areFew = m_veils.count() <= mostComparedVeils;
    for (std::size_t i = 0; i < m_veils.count(); ++i)
      for (std::size_t j = i + 1; j < m_veils.count() && (areFew || j == i + 1); ++j)
        if (!areFew || m_veils.overlap(i, j))
          paintFirst(i, j);
  }

  void orderThings() {
    std::vector<PixelBox> boxes;
    for (const PaintedThing &thing : m_things)
      boxes.push_back(boxOf(thing));
    std::vector<std::size_t> fromLeft(m_things.size());
    std::iota(fromLeft.begin(), fromLeft.end(), 0);
    std::stable_sort(fromLeft.begin(), fromLeft.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].low.x < boxes[b].low.x; });
    for (std::size_t i = 0; i < fromLeft.size(); ++i)
      for (std::size_t j = i + 1;
           j < fromLeft.size() && boxes[fromLeft[j]].low.x <= boxes[fromLeft[i]].high.x; ++j)
        if (meet(boxes[fromLeft[i]], boxes[fromLeft[j]]))
          orderTwo(std::min(fromLeft[i], fromLeft[j]), std::max(fromLeft[i], fromLeft[j]));
  }

  void orderTwo(std::size_t one, std::size_t other) {
    const PaintedThing &first = m_things[one];
    const PaintedThing &second = m_things[other];
    const std::size_t pieces = first.spine.size() * second.spine.size();
    if (m_compared + pieces > mostComparedPieces)
      return;
    m_compared += pieces;
    const auto met = meetingOf(first, second);
    if (!met)
      return;
    const double nearer = met->one.nearness - met->other.nearness;
    const bool areEven = std::abs(nearer) <= asNear * std::abs(met->one.nearness);
    const std::pair firstOutside(first.rank, first.reach);
    const std::pair secondOutside(second.rank, second.reach);
    if (areEven && firstOutside == secondOutside)
      return;
    const bool isFirstBelow = areEven ? firstOutside < secondOutside : nearer < 0;
    paintFirst(m_veils.count() + (isFirstBelow ? one : other),
               m_veils.count() + (isFirstBelow ? other : one));
  }

  /// Where two things lie over one another.
  static std::optional<SpotPair> meetingOf(const PaintedThing &one, const PaintedThing &other) {
    const auto at = [](const PaintedThing &thing, std::size_t i) {
      return thing.spine[std::min(i, thing.spine.size() - 1)];
    };
    std::optional<SpotPair> nearest;
    double least = one.reach + other.reach;
    for (std::size_t i = 0; i < std::max<std::size_t>(one.spine.size() - 1, 1); ++i)
      for (std::size_t j = 0; j < std::max<std::size_t>(other.spine.size() - 1, 1); ++j) {
        const SpotPair pair = nearestOf(at(one, i), at(one, i + 1), at(other, j), at(other, j + 1));
        const double distance = glm::distance(pair.one.at, pair.other.at);
        if (distance < least) {
          least = distance;
          nearest = pair;
        }
      }
    return nearest;
  }

  /// Where things lie over one another in a ring one of them comes first, before veils, which have their
  /// order.
  [[nodiscard]] std::size_t firstOfRing(const std::set<std::size_t> &waiting) const {
    std::vector<std::size_t> way{*waiting.begin()};
    for (;;) {
      const auto &lower = m_before[way.back()];
      const std::size_t next =
          *std::find_if(lower.begin(), lower.end(), [&](std::size_t each) { return waiting.contains(each); });
      const auto begin = std::find(way.begin(), way.end(), next);
      if (begin != way.end())
        return *std::max_element(begin, way.end());
      way.push_back(next);
    }
  }

  /// A veil that looks like the one just painted, as it may be a piece of the same face; or the first.
  [[nodiscard]] std::size_t chosen(const std::set<std::size_t> &ready,
                                   const std::vector<std::size_t> &order) const {
    if (!order.empty() && order.back() < m_veils.count())
      for (const std::size_t each : ready)
        if (each < m_veils.count() && m_looks[each] == m_looks[order.back()])
          return each;
    return *ready.begin();
  }

  const Veils &m_veils;
  const std::vector<VeilLook> &m_looks;
  const std::vector<PaintedThing> &m_things;
  std::vector<std::vector<std::size_t>> m_after;  ///< what is painted after each
  std::vector<std::vector<std::size_t>> m_before; ///< and before it
  std::vector<std::size_t> m_open;                ///< how many of these are still to be painted
  std::size_t m_compared = 0;
};

/// Whether two veils are pieces of one flat face.
bool areOfOneFace(const Veil &one, const Veil &other) {
  const auto *first = std::get_if<FlatVeil>(&one);
  const auto *second = std::get_if<FlatVeil>(&other);
  return first && second && first->isInOnePlaneWith(*second);
}

/// Opaque faces that touch each other would leave seams between them: each has a hair of its own colour
/// around it.
std::optional<Pen> rimOf(const Fill &fill) {
  return fill.opacity < 1 ? std::nullopt : std::optional(Pen{fill.color, rim});
}

} // namespace

std::vector<PathPart> inPaintingOrder(const Veils &veils, const std::vector<VeilLook> &looks,
                                      std::vector<PaintedThing> things) {
  std::vector<PathPart> parts;
  std::optional<std::size_t> before; ///< the veil that the last part is of
  for (const std::size_t next : PaintingOrder(veils, looks, things).find()) {
    if (next >= veils.count()) {
      before.reset();
      std::vector<PathPart> &ofThing = things[next - veils.count()].parts;
      std::move(ofThing.begin(), ofThing.end(), std::back_inserter(parts));
      continue;
    }
    const bool isFlat = std::holds_alternative<FlatVeil>(veils[next]);
    const PagePath path =
        isFlat ? straightPath(veils.cornersOf(next), true) : smoothPath(veils.cornersOf(next), true);
    if (before && looks[*before] == looks[next] && areOfOneFace(veils[*before], veils[next]))
      parts.back().path.append(path);
    else
      parts.push_back({path, looks[next].fill, rimOf(looks[next].fill), looks[next].mark});
    before = next;
  }
  return parts;
}

} // namespace halfspace
