// The marks of figures: a small closed set. A mark says what is drawn, never how: colours, widths and pixels
// belong to the visitors (the 3D scene, exports, the description in words).
#pragma once

#include "lessons/figure/look.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace halfspace {

struct TriangleMesh;
class HitSearch;

using Place = glm::dvec3; ///< a place or a vector of the drawing, in scene units

[[nodiscard]] inline bool isFinite(const Place &p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// The part a mark plays. It decides width, dash and paleness.
enum class Role { Given, Derived, Helper, Result, Warning, Ghost };

/// What a mark belongs to. It decides the colour, in the figure and in the formulas alike, unless its look
/// does.
enum class Subject { Neutral, Plane, Point, Ray, Triangle, EdgeU, EdgeV, Measure };

/// The hue of what nothing else is told from.
[[nodiscard]] Hue hueOf(Subject subject);

/// What all marks have.
struct MarkBase {
  /// Unique in the figure and stable from one evaluation to the next: `E.n`, `distance.F`. A mark
  /// `distance.F/angle` accompanies the mark `distance.F`: a step that shows one shows the other.
  std::string id;
  Role role = Role::Given;
  Subject subject = Subject::Neutral;
  std::string label{};   ///< LaTeX written beside the mark; empty for none
  std::string numbers{}; ///< LaTeX that goes on behind the label, and stays away while numbers are hidden
  bool passes = false;   ///< it flies by: labels of others make no room for it
  Look look{};           ///< that of the one object that it speaks of
  /// LaTeX that goes on behind the label where coordinates are written: `{(11,15,8)}`; stays away while
  /// numbers are hidden.
  std::string coordinates{};
  bool operator==(const MarkBase &) const = default;
};

/// The ids of several marks that are shown as one, counted from 0: `box`, then `box/1`, `box/2`.
[[nodiscard]] std::string partOf(const std::string &mark, std::size_t number);

/// How far something is drawn both ways along a direction, in units of the picture.
struct Extent {
  double low = 0;
  double high = 0;
  bool operator==(const Extent &) const = default;
};

struct PointMark : MarkBase {
  Place at{};
  bool operator==(const PointMark &) const = default;
};

/// A straight piece between two points. Helpers and ghosts are dashed.
struct SegmentMark : MarkBase {
  Place from{};
  Place to{};
  bool operator==(const SegmentMark &) const = default;
};

/// The thin line of a ray from its start; its direction, which is not zero, is an arrow of its own.
struct RayMark : MarkBase {
  Place origin{};
  Place direction{};
  std::optional<Place> meets{}; ///< what it meets ahead
  std::optional<Extent> held{}; ///< as far as it is drawn, unless it meets something farther on
  bool operator==(const RayMark &) const = default;
};

/// The thin line that goes on in both directions; it is not zero.
struct LineMark : MarkBase {
  Place through{};
  Place direction{};
  std::vector<Place> covers{};  ///< places of the line that it is to be drawn up to
  std::optional<Extent> held{}; ///< as far as it is drawn, unless it covers something farther on
  /// The same line, however far it must reach.
  bool operator==(const LineMark &other) const {
    return MarkBase::operator==(other) && through == other.through && direction == other.direction;
  }
};

struct ArrowMark : MarkBase {
  Place from{};
  Place vector{};
  bool isFree = false; ///< a normal or a ray's direction: where its length cannot be shown, its direction can
  std::optional<double>
      drawnLength{}; ///< in units of the picture, where only the direction of the vector matters
  bool operator==(const ArrowMark &) const = default;
};

/// A rectangle of a plane around `center`, large enough to hold the points of the plane that matter.
struct PlanePatchMark : MarkBase {
  Place center{};
  Place normal{};
  std::vector<Place> covers;
  std::optional<std::pair<Extent, Extent>> held{}; ///< as far as it is drawn, whatever it covers
  /// The same patch of the same plane, however far it must reach.
  bool operator==(const PlanePatchMark &other) const {
    return MarkBase::operator==(other) && center == other.center && normal == other.normal;
  }
};

/// A filled polygon, planar and convex, with its outline.
struct PolygonMark : MarkBase {
  std::vector<Place> corners;
  bool operator==(const PolygonMark &) const = default;
};

/// A ball that is seen through, with three great circles.
struct SphereMark : MarkBase {
  Place center{};
  double radius = 0;
  bool operator==(const SphereMark &) const = default;
};

/// The arc of an angle at `center` from the direction `from` to the direction `to` (neither need be unit).
struct ArcMark : MarkBase {
  Place center{};
  Place from{};
  Place to{};
  bool operator==(const ArcMark &) const = default;
};

/// The corner mark of a right angle at `at`, between two directions (neither need be unit).
struct RightAngleMark : MarkBase {
  Place at{};
  Place first{};
  Place second{};
  bool operator==(const RightAngleMark &) const = default;
};

/// Very many triangles as one surface. They are never copied: a corner at c is drawn at place + axes·c.
struct MeshMark : MarkBase {
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const HitSearch> search; ///< among the mesh's triangles, to find what is under a pixel
  std::pair<Place, Place> box{};           ///< around the mesh's corners: the lowest and the highest
  Place place{};
  glm::dmat3 axes{1};
  bool operator==(const MeshMark &) const = default;
};

using Mark = std::variant<PointMark, SegmentMark, RayMark, LineMark, ArrowMark, PlanePatchMark, PolygonMark,
                          SphereMark, MeshMark, ArcMark, RightAngleMark>;

/// For std::visit with one lambda a kind: a kind without one does not compile.
template <class... Visitors> struct Overloaded : Visitors... { using Visitors::operator()...; };
template <class... Visitors> Overloaded(Visitors...) -> Overloaded<Visitors...>;

/// What all marks have, of any mark.
[[nodiscard]] inline const MarkBase &baseOf(const Mark &mark) {
  return std::visit([](const MarkBase &base) -> const MarkBase & { return base; }, mark);
}
[[nodiscard]] inline MarkBase &baseOf(Mark &mark) {
  return std::visit([](MarkBase &base) -> MarkBase & { return base; }, mark);
}

/// A mark that speaks of one object alone, in that object's look.
template <class Kind> [[nodiscard]] Kind inLook(const Look &look, Kind mark) {
  mark.look = look;
  return mark;
}

/// The hue of a mark: that of its look, else of its subject.
[[nodiscard]] inline Hue hueOf(const MarkBase &mark) { return mark.look.hue.value_or(hueOf(mark.subject)); }

/// The id of the mark that a mark accompanies: `F` for `F/angle`; its own for all others. A part of the
/// mark's id.
[[nodiscard]] inline std::string_view leadingId(const MarkBase &mark) {
  return std::string_view(mark.id).substr(0, mark.id.find('/'));
}

/// A patch is at least this long on each side, in units of the picture …
inline constexpr double minimumPatchSide = 14;
/// … goes on this far behind a covered point …
inline constexpr double patchMargin = 1;
/// … and ends this far from its centre, so that a far point does not make it fill the picture.
inline constexpr double maximumPatchReach = 24;

/// A ray runs on so far behind what it meets, in units of the picture …
inline constexpr double beyondHit = 2.5;
/// … and so far where it meets nothing.
inline constexpr double openRayLength = 16;

/// How far a ray and a line are drawn from their start or middle, and a patch from its centre: along its
/// horizontal sides and along the others. Of a zero normal as if it covered nothing.
[[nodiscard]] Extent extentOf(const RayMark &ray);
[[nodiscard]] Extent extentOf(const LineMark &line);
[[nodiscard]] std::pair<Extent, Extent> extentOf(const PlanePatchMark &patch);

/// Where the drawn line of a ray ends.
[[nodiscard]] Place endOf(const RayMark &ray);

/// A line is drawn so far both ways, in units of the picture, and so far behind what it covers.
inline constexpr double lineReach = 12;
/// The two ends of what is drawn of a line.
[[nodiscard]] std::pair<Place, Place> endsOf(const LineMark &line);

/// From the start of an arrow to the tip that is drawn.
[[nodiscard]] Place shownVector(const ArrowMark &arrow);

/// The corners, in order around it, of the rectangle that a patch is drawn as: one pair of sides horizontal,
/// reaching beyond the covered points (their feet on the plane) as far as the bounds above let it. Empty for
/// a zero normal.
[[nodiscard]] std::vector<Place> cornersOf(const PlanePatchMark &patch);

} // namespace halfspace
