#include "widgets/exports/page_path.h"

#include "widgets/exports/page_number.h"
#include "widgets/exports/page_polygon.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace halfspace {
namespace {

/// Pieces of a curve turn by less than this from one to the next (its cosine): 20 degrees.
constexpr double leastCurveCosine = 0.94;

/// Spots nearer to each other than this are one.
constexpr double oneSpot = leastWritten;

/// What turns by less than this (its sine) goes straight on.
constexpr double straightSine = 1e-3;

/// A curve goes on in one piece until it has turned by so much (its cosine): 22 degrees.
constexpr double mostTurnedCosine = 0.927;

/// The control points of a quarter of a circle, in radii.
const double quarterControl = 4.0 / 3 * (std::numbers::sqrt2 - 1);

bool turnsLikeACurve(glm::dvec2 in, glm::dvec2 out) {
  return glm::dot(in, out) > leastCurveCosine * glm::length(in) * glm::length(out);
}

std::vector<glm::dvec2> withoutRepeats(const std::vector<glm::dvec2> &spots) {
  std::vector<glm::dvec2> kept;
  for (const glm::dvec2 &spot : spots)
    if (kept.empty() || glm::distance(spot, kept.back()) > oneSpot)
      kept.push_back(spot);
  if (kept.size() > 1)
    kept.back() = spots.back();
  return kept;
}

/// Without those between others on one straight line.
std::vector<glm::dvec2> withoutStraight(const std::vector<glm::dvec2> &spots) {
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (i > 0 && i + 1 < spots.size()) {
      const glm::dvec2 in = spots[i] - kept.back();
      const glm::dvec2 out = spots[i + 1] - spots[i];
      if (glm::dot(in, out) > 0 &&
          std::abs(crossOf(in, out)) < straightSine * glm::length(in) * glm::length(out))
        continue;
    }
    kept.push_back(spots[i]);
  }
  return kept;
}

/// The direction in which a path goes through a spot that lies between two others, if it is no corner there.
std::optional<glm::dvec2> directionThrough(glm::dvec2 before, glm::dvec2 spot, glm::dvec2 after) {
  const glm::dvec2 in = spot - before;
  const glm::dvec2 out = after - spot;
  if (!turnsLikeACurve(in, out))
    return {};
  // That of the circle through the three.
  const glm::dvec2 way = in * glm::dot(out, out) + out * glm::dot(in, in);
  return way / glm::length(way);
}

/// The direction at the end of a piece whose other end has one: as a circle has it.
glm::dvec2 mirrored(glm::dvec2 direction, glm::dvec2 chord) {
  const glm::dvec2 along = chord / glm::length(chord);
  return along * (2 * glm::dot(direction, along)) - direction;
}

/// Which spots a curve needs: its ends, its corners, and others so often that nothing is lost between them.
std::vector<std::size_t> neededSpots(const std::vector<std::optional<glm::dvec2>> &directions) {
  std::vector<std::size_t> needed{0};
  for (std::size_t i = 1; i < directions.size(); ++i) {
    const auto &last = directions[needed.back()];
    const std::size_t next = i + 1;
    if (next == directions.size() || !last || !directions[i] || !directions[next] ||
        glm::dot(*last, *directions[next]) < mostTurnedCosine)
      needed.push_back(i);
  }
  return needed;
}

void addPiece(PagePath &path, glm::dvec2 from, glm::dvec2 to, std::optional<glm::dvec2> leaves,
              std::optional<glm::dvec2> arrives) {
  if (!leaves && !arrives)
    return path.lineTo(to);
  const glm::dvec2 chord = to - from;
  const glm::dvec2 out = leaves ? *leaves : mirrored(*arrives, chord);
  const glm::dvec2 in = arrives ? *arrives : mirrored(*leaves, chord);
  const double reach = glm::length(chord) / 3;
  path.curveTo(from + out * reach, to - in * reach, to);
}

} // namespace

PagePath straightPath(const std::vector<glm::dvec2> &spots, bool isClosed) {
  PagePath path;
  for (const glm::dvec2 &spot : withoutRepeats(spots))
    path.steps.empty() ? path.moveTo(spot) : path.lineTo(spot);
  if (isClosed && !path.steps.empty())
    path.close();
  return path;
}

PagePath smoothPath(const std::vector<glm::dvec2> &all, bool isClosed) {
  std::vector<glm::dvec2> spots = withoutStraight(withoutRepeats(all));
  if (isClosed && spots.size() > 1 && glm::distance(spots.front(), spots.back()) <= oneSpot)
    spots.pop_back();
  const std::size_t count = spots.size();
  if (count < 3)
    return straightPath(spots, isClosed);
  std::vector<std::optional<glm::dvec2>> directions(count);
  for (std::size_t i = 0; i < count; ++i)
    if (isClosed || (i > 0 && i + 1 < count))
      directions[i] = directionThrough(spots[(i + count - 1) % count], spots[i], spots[(i + 1) % count]);
  const std::vector<std::size_t> needed = neededSpots(directions);
  PagePath path;
  path.moveTo(spots.front());
  for (std::size_t i = 1; i < needed.size(); ++i)
    addPiece(path, spots[needed[i - 1]], spots[needed[i]], directions[needed[i - 1]], directions[needed[i]]);
  if (isClosed) {
    addPiece(path, spots.back(), spots.front(), directions.back(), directions.front());
    path.close();
  }
  return path;
}

PagePath circlePath(glm::dvec2 center, double radius) {
  constexpr std::array<glm::dvec2, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  PagePath path;
  path.moveTo(center + ways[0] * radius);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const glm::dvec2 from = ways.at(i);
    const glm::dvec2 to = ways.at((i + 1) % ways.size());
    path.curveTo(center + (from + to * quarterControl) * radius,
                 center + (to + from * quarterControl) * radius, center + to * radius);
  }
  path.close();
  return path;
}

} // namespace halfspace
