#include "lessons/scene/hand/snapping.h"

#include "lessons/object/coordinate_limits.h"
#include "lessons/object/drawing.h"
#include "lessons/scene/hand/quadric_places.h"

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

/// Grid places this many steps around one are tried.
constexpr int gridReach = 2;

/// One way to satisfy a target.
struct Candidate {
  ExactVec3 at;
  Rational offGrid = 1; ///< the longest denominator of its coordinates counted in steps; 1 on the grid
  double pixels = 0;    ///< from where the pointer wants it
};

int dominantAxis(const ExactVec3 &vector) {
  int dominant = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(vector[i]) > abs(vector[dominant]))
      dominant = i;
  return dominant;
}

/// Finds where one handle comes to rest.
class Snapper {
public:
  explicit Snapper(const SnapRequest &request)
      : m_request(request),
        m_bound(request.handle.host ? findObject(request.scene.scene, request.handle.object) : nullptr),
        m_wanted(wantedPlace()), m_grid(gridPlace()) {}

  SnappedPlace find() const {
    SnappedPlace best{m_grid, ""};
    if (m_request.step <= finestStep)
      return best;
    const double gridPixels = gridPixelsIfAlone();
    std::size_t bestDimension = 4;
    double bestPixels = 0;
    for (const SnapTarget &target : m_request.targets) {
      const std::size_t dimension = target.dimension();
      const auto common = Flat::intersection(m_request.freedom, target.places);
      if (dimension > bestDimension || !common || (m_bound && !target.surface && isEverywhere(*common)))
        continue;
      const double pixels = pixelsTo(*common, target);
      if (!(pixels <= m_request.catchPixels) || (dimension == bestDimension && pixels >= bestPixels))
        continue;
      const auto rest = restOn(*common, target);
      if (rest && (pixels <= gridPixels || offGrid(*rest) == 1)) {
        best = {*rest, target.name};
        bestDimension = dimension;
        bestPixels = pixels;
      }
    }
    return best;
  }

private:
  ExactVec3 wantedPlace() const {
    ExactVec3 wanted;
    for (int i = 0; i < 3; ++i)
      wanted[i] = roundToMultiple(m_request.raw[i], finestStep);
    return m_request.freedom.nearest(wanted);
  }

  /// The place whose value has this coordinate rounded to the grid.
  Rational onGrid(const ExactVec3 &place, int axis) const {
    return SnapGrid{m_request.handle.base, m_request.step}.nearest(place, axis);
  }

  ExactVec3 gridPlace() const {
    if (m_bound)
      return *placeOn(movedToGrid(*m_bound, m_request.handle, m_wanted, m_request.step),
                      *m_request.handle.host);
    const Flat &freedom = m_request.freedom;
    if (freedom.dimension() == 1 && isSlanted(freedom.direction()))
      return withAxisOnGrid(m_wanted, freedom.direction(), dominantAxis(freedom.direction()));
    if (freedom.dimension() == 2 && freedom.moves(0) && freedom.moves(1) && freedom.moves(2))
      return gridPlaceInSlantedPlane();
    ExactVec3 place = m_request.handle.at;
    for (int axis = 0; axis < 3; ++axis)
      if (freedom.moves(axis))
        place[axis] = onGrid(m_wanted, axis);
    return place;
  }

  /// A place of the grid that lies in the plane, if one is around; else one with two coordinates on the grid.
  ExactVec3 gridPlaceInSlantedPlane() const {
    ExactVec3 rounded;
    for (int axis = 0; axis < 3; ++axis)
      rounded[axis] = onGrid(m_wanted, axis);
    std::vector<ExactVec3> places = gridAround(rounded);
    for (const auto &[first, second] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
      const auto line = withCoordinate(m_request.freedom, first, rounded[first]);
      const auto place = line ? withCoordinate(*line, second, rounded[second]) : std::nullopt;
      if (places.empty() && place && place->dimension() == 0)
        places.push_back(place->nearest(rounded));
    }
    return *std::min_element(places.begin(), places.end(), [this](const ExactVec3 &a, const ExactVec3 &b) {
      return pixelsTo(a) < pixelsTo(b);
    });
  }

  static bool isSlanted(const ExactVec3 &direction) {
    return (direction.x != 0) + (direction.y != 0) + (direction.z != 0) > 1;
  }

  /// The place of the line through `place` where one coordinate is on the grid.
  ExactVec3 withAxisOnGrid(const ExactVec3 &place, const ExactVec3 &direction, int axis) const {
    return place + direction * Rational((onGrid(place, axis) - place[axis]) / direction[axis]);
  }

  /// Whether the handle cannot leave it, as a point on a line that line.
  bool isEverywhere(const Flat &common) const { return common.dimension() == m_request.freedom.dimension(); }

  double pixelsTo(const ExactVec3 &at) const { return m_request.pixelsApart(place(at), m_request.raw); }

  /// Infinite where the target's surface is not met.
  double pixelsTo(const Flat &common, const SnapTarget &target) const {
    if (!target.surface)
      return pixelsTo(common.nearest(m_wanted));
    const auto nearest = nearestOn(*target.surface, common, m_wanted);
    return nearest ? m_request.pixelsApart(*nearest, m_request.raw) : std::numeric_limits<double>::infinity();
  }

  /// How far a grid place is that no other is near to: the hand means it, and not a place with fractions
  /// farther away. Infinite where many are within the catch.
  double gridPixelsIfAlone() const {
    const Place grid = place(m_grid);
    for (int axis = 0; axis < 3; ++axis) {
      Place next = grid;
      next[axis] += toDouble(m_request.step);
      if (m_request.freedom.moves(axis) && !(m_request.pixelsApart(grid, next) > m_request.catchPixels))
        return std::numeric_limits<double>::infinity();
    }
    return pixelsTo(m_grid);
  }

  /// Of the places that satisfy the target the one with the shortest numbers; among equally short ones the
  /// nearest.
  std::optional<ExactVec3> restOn(const Flat &common, const SnapTarget &target) const {
    // Sliding on the target may move as far as the grid alone would.
    const double reach = m_request.catchPixels + pixelsTo(m_grid);
    std::vector<Candidate> candidates;
    for (const ExactVec3 &at : placesToTry(common, target))
      if (const double pixels = pixelsTo(at); pixels <= reach && isOffered(at))
        candidates.push_back({at, offGrid(at), pixels});
    std::sort(candidates.begin(), candidates.end(), [](const Candidate &a, const Candidate &b) {
      return a.offGrid < b.offGrid || (a.offGrid == b.offGrid && a.pixels < b.pixels);
    });
    // Whether one counts may take the evaluation of a scene: the best are asked first.
    const auto best = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate &candidate) {
      return !target.counts || target.counts(candidate.at);
    });
    return best == candidates.end() ? std::nullopt : std::optional(best->at);
  }

  /// A single place as it is; on a line where its coordinates are on the grid; on a curve its places of
  /// fractions; and grid places that happen to fit.
  std::vector<ExactVec3> placesToTry(const Flat &common, const SnapTarget &target) const {
    if (target.surface)
      return exactPlacesOn(*target.surface, common, m_wanted, {m_request.handle.base, m_request.step});
    const ExactVec3 foot = common.nearest(m_wanted);
    if (common.dimension() == 0)
      return {foot};
    std::vector<ExactVec3> places;
    if (common.dimension() == 1) {
      const ExactVec3 direction = common.direction();
      for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
          places.push_back(withAxisOnGrid(foot, direction, axis));
    }
    for (const ExactVec3 &at : gridAround(m_grid))
      if (common.contains(at))
        places.push_back(at);
    return places;
  }

  /// The grid places around one, within the freedom.
  std::vector<ExactVec3> gridAround(const ExactVec3 &middle) const {
    const auto reach = [this](int axis) { return m_request.freedom.moves(axis) ? gridReach : 0; };
    std::vector<ExactVec3> places;
    for (int x = -reach(0); x <= reach(0); ++x)
      for (int y = -reach(1); y <= reach(1); ++y)
        for (int z = -reach(2); z <= reach(2); ++z) {
          const ExactVec3 place = middle + ExactVec3(x, y, z) * m_request.step;
          if (m_request.freedom.contains(place))
            places.push_back(place);
        }
    return places;
  }

  /// The longest denominator of the coordinates that move, counted in steps.
  Rational offGrid(const ExactVec3 &at) const {
    Rational longest = 1;
    for (int axis = 0; axis < 3; ++axis)
      if (m_request.freedom.moves(axis))
        longest = std::max(longest,
                           Rational((at[axis] - m_request.handle.base[axis]) / m_request.step).denominator());
    return longest;
  }

  /// Whether the coordinates that move stay short and within bounds.
  bool isOffered(const ExactVec3 &at) const {
    if (m_bound)
      return isOnHost(at);
    for (int axis = 0; axis < 3; ++axis) {
      const Rational value = at[axis] - m_request.handle.base[axis];
      if (m_request.freedom.moves(axis) && (isTooLong(value) || refuseCoordinate(value)))
        return false;
    }
    return true;
  }

  /// Whether the handle's bound object can lie there, with freedoms that stay short and within bounds.
  bool isOnHost(const ExactVec3 &at) const {
    const Object moved = movedTo(*m_bound, m_request.handle, at);
    if (placeOn(moved, *m_request.handle.host) != at || refusedCoordinateOf(moved))
      return false;
    for (std::size_t i = 0; i < moved.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (isTooLong(moved[i][axis]))
          return false;
    return true;
  }

  static bool isTooLong(const Rational &value) {
    return toText(value.denominator()).size() > longestSnapDenominator;
  }

  const SnapRequest &m_request;
  const Object *m_bound; ///< the handle's object where it lies on another; else null
  ExactVec3 m_wanted;
  ExactVec3 m_grid;
};

} // namespace

SnappedPlace snap(const SnapRequest &request) { return Snapper(request).find(); }

} // namespace halfspace
