// A figure: a list of marks of a small closed set. It says what is drawn, never how: colours, widths and
// pixels belong to the visitors (the 3D scene, exports, the description in words).
#pragma once

#include <glm/vec3.hpp>

#include <string>
#include <variant>
#include <vector>

namespace halfspace {

using Place = glm::dvec3; ///< a place or a vector of the drawing, in scene units

/// The part a mark plays. It decides width, dash and paleness.
enum class Role { Given, Derived, Helper, Result, Warning, Ghost };

/// What a mark belongs to. It decides the colour, in the figure and in the formulas alike.
enum class Subject { Neutral, Plane, Point, Ray, Triangle, EdgeU, EdgeV, Measure };

/// What all marks have.
struct MarkBase {
  /// Unique in the figure and stable from one evaluation to the next. A mark `a-foot` accompanies the mark `a`: a step
  /// that shows one shows the other.
  std::string id;
  Role role = Role::Given;
  Subject subject = Subject::Neutral;
  std::string label; ///< LaTeX written beside the mark; empty for none
};

struct PointMark : MarkBase {
  Place at{};
};

/// A straight piece between two points. Helpers and ghosts are dashed.
struct SegmentMark : MarkBase {
  Place from{};
  Place to{};
};

/// The thin line of a ray from its start; its direction is an arrow of its own. It is drawn up to t = reach.
struct RayMark : MarkBase {
  Place origin{};
  Place direction{};
  double reach = 0;
};

struct ArrowMark : MarkBase {
  Place from{};
  Place vector{};
};

/// A rectangle of a plane around `center`, large enough to hold the points of the plane that matter.
struct PlanePatchMark : MarkBase {
  Place center{};
  Place normal{};
  std::vector<Place> covers;
};

/// A filled polygon, planar and convex, with its outline.
struct PolygonMark : MarkBase {
  std::vector<Place> corners;
};

/// The arc of an angle at `center` from the direction `from` to the direction `to` (neither need be unit).
struct ArcMark : MarkBase {
  Place center{};
  Place from{};
  Place to{};
};

/// The corner mark of a right angle at `at`, between two directions (neither need be unit).
struct RightAngleMark : MarkBase {
  Place at{};
  Place first{};
  Place second{};
};

using Mark = std::variant<PointMark, SegmentMark, RayMark, ArrowMark, PlanePatchMark, PolygonMark, ArcMark,
                          RightAngleMark>;

struct Figure {
  std::vector<Mark> marks;
};

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

/// The id of the mark that a mark accompanies: `a` for `a-foot`; its own for all others.
[[nodiscard]] inline std::string leadingId(const MarkBase &mark) { return mark.id.substr(0, mark.id.find('-')); }

/// The mark with this id, or null.
[[nodiscard]] inline const Mark *findMark(const Figure &figure, std::string_view id) {
  for (const Mark &mark : figure.marks)
    if (baseOf(mark).id == id)
      return &mark;
  return nullptr;
}

/// A patch is at least this long on each side, in scene units …
inline constexpr double minimumPatchSide = 14;
/// … goes on this far behind a covered point …
inline constexpr double patchMargin = 1;
/// … and ends this far from its centre, so that a far point does not make it fill the picture.
inline constexpr double maximumPatchReach = 24;

/// The corners, in order around it, of the rectangle that a patch is drawn as: one pair of sides horizontal,
/// reaching beyond the covered points (their feet on the plane) as far as the bounds above let it. Empty for
/// a zero normal.
[[nodiscard]] std::vector<Place> cornersOf(const PlanePatchMark &patch);

} // namespace halfspace
