#include "widgets/picture/shapes/mark_mesh.h"

#include "widgets/picture/shapes/ball_sizes.h"
#include "widgets/picture/shapes/mark_outline.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace halfspace {
namespace {

// Radii and lengths in scene units at scale 1.
constexpr double segmentRadius = 0.07;
constexpr double rayRadius = 0.05;
constexpr double polygonEdgeRadius = 0.05;
constexpr double patchEdgeRadius = 0.045;
constexpr double angleRadius = 0.04;
constexpr double sphereRadius = 0.03;

/// What goes on fades this far before the end of what is drawn at scale 1, but in no more than a part of its
/// length, to a part of its strength.
constexpr double fadeLength = 3;
constexpr double mostFaded = 0.3;
constexpr double strengthAtEnd = 0.12;

/// More points than this are drawn as coarse balls.
constexpr int mostFineBalls = 150;

/// About what a mark has: more in a ball or a dashed line, fewer in a tube.
constexpr std::size_t usualCorners = 400;

constexpr double highlightWidth = 1.55;
/// A ball is thick as it is: much thicker, it would cover what lies beside it.
constexpr double highlightBallWidth = 1.2;
constexpr double highlightInk = 0.22;
/// Dashes tell a ghost from the rest as well: paler than this it would be lost behind a plane.
constexpr double ghostPaleness = 0.3;
constexpr double patchBorderDepth = 0.35;

double widthOf(Role role) {
  switch (role) {
  case Role::Given:
  case Role::Result:
  case Role::Warning:
    return 1;
  case Role::Derived:
    return 0.8;
  case Role::Helper:
  case Role::Ghost:
    return 0.75;
  }
  return 1;
}

double highlightOf(const Mark &mark) {
  return std::holds_alternative<PointMark>(mark) ? highlightBallWidth : highlightWidth;
}

/// Each arrow that lies in longer ones is drawn so much thicker: its shaft is seen around theirs, their tips
/// are seen beyond it.
constexpr double sleeveWidth = 0.7;
/// Of arrows that are the same to the eye, each is so much thicker than the one inside it, even where its
/// role makes it thinner: surfaces in one place would flicker.
constexpr double twinWidth = 0.4;
/// Heads would still lie in one cone: each ends so many radii of a shaft before that of the one around it,
/// but all of them within a part of their length.
constexpr double twinSetback = 1.5;
constexpr double mostSetback = 0.1;
/// Directions that differ by less than this (the sine of the angle), and lengths by less than this part, are
/// one to the eye, in whatever way they were rounded.
constexpr double sameToTheEye = 1e-6;

/// Whether two arrows start in the same place and point the same way.
bool goTogether(const ArrowMark &one, const ArrowMark &other) {
  const Place first = shownVector(one);
  const Place second = shownVector(other);
  const double lengths = glm::length(first) * glm::length(second);
  return one.from == other.from && glm::dot(first, second) > 0 &&
         glm::length(glm::cross(first, second)) <= sameToTheEye * lengths;
}

/// By how much an arrow is longer than another, as a part of its length.
double lead(const ArrowMark &arrow, const ArrowMark &other) {
  const double length = glm::length(shownVector(arrow));
  return (length - glm::length(shownVector(other))) / length;
}

/// Whether an arrow lies in another, which goes on beyond its tip.
bool liesIn(const ArrowMark &arrow, const ArrowMark &other) {
  return goTogether(arrow, other) && lead(other, arrow) > sameToTheEye;
}

/// Whether an arrow is drawn around another that is the same to the eye: a dashed one around a whole one,
/// which is seen in its gaps.
bool covers(const ArrowMark &arrow, const ArrowMark &other) {
  const auto rank = [](const ArrowMark &one) { return std::pair(!rhythmOf(one, 1).empty(), one.id); };
  return goTogether(arrow, other) && std::abs(lead(arrow, other)) <= sameToTheEye &&
         rank(other) < rank(arrow);
}

bool isCoveredBy(const ArrowMark &arrow, const ArrowMark &other) { return covers(other, arrow); }

/// The arrows of a figure by where they start.
class ArrowsByStart {
public:
  explicit ArrowsByStart(const Figure &figure) {
    for (const Mark &mark : figure.marks)
      if (const auto *arrow = std::get_if<ArrowMark>(&mark))
        m_arrows.emplace(keyOf(*arrow), arrow);
  }

  /// How many of them stand to an arrow as `relation` says.
  double count(const ArrowMark &arrow, bool (*relation)(const ArrowMark &, const ArrowMark &)) const {
    const auto [first, last] = m_arrows.equal_range(keyOf(arrow));
    return static_cast<double>(
        std::count_if(first, last, [&](const auto &other) { return relation(arrow, *other.second); }));
  }

private:
  using Key = std::array<double, 3>;
  static Key keyOf(const ArrowMark &arrow) { return {arrow.from.x, arrow.from.y, arrow.from.z}; }

  std::multimap<Key, const ArrowMark *> m_arrows;
};

/// What the width of a mark is multiplied by, so that it is seen where it lies in others.
double sleeveOf(const Mark &mark, const ArrowsByStart &arrows) {
  const auto *arrow = std::get_if<ArrowMark>(&mark);
  return arrow ? 1 + sleeveWidth * arrows.count(*arrow, liesIn) + twinWidth * arrows.count(*arrow, covers)
               : 1;
}

/// How far before its tip an arrow ends, so that its head lies in those of all around it that are the same to
/// the eye.
double setbackOf(const ArrowMark &arrow, const ArrowsByStart &arrows, double thickness) {
  const double around = arrows.count(arrow, isCoveredBy);
  if (around == 0)
    return 0;
  const double all = around + arrows.count(arrow, covers);
  return around *
         std::min(twinSetback * arrowRadius * thickness, mostSetback * glm::length(shownVector(arrow)) / all);
}

BallDetail ballDetailFor(const Figure &figure) {
  const auto points = std::count_if(figure.marks.begin(), figure.marks.end(),
                                    [](const Mark &mark) { return std::holds_alternative<PointMark>(mark); });
  return points <= mostFineBalls ? BallDetail::Fine : BallDetail::Coarse;
}

/// The length of a dash at scale 1, in scene units, and what a rhythm has in lengths of a dash.
constexpr double dashLength = 0.42;
const Rhythm shortDashes{1, 0.7};
/// The first of its kind is drawn in whole lines, those behind it each in another rhythm, as far as they go.
const std::array<Rhythm, 4> rhythmsOfRanks{
    {{}, {2.5, 0.5}, {2.5, 0.5, 0.5, 0.5}, {2.5, 0.5, 0.5, 0.5, 0.5, 0.5}}};
/// So many objects can each have a hue and a rhythm together that no other has. Those behind them cannot be
/// told apart, so their dashes would cost time for nothing.
constexpr std::size_t toldApart = std::tuple_size_v<decltype(rhythmsOfRanks)> * hueCount;

Rhythm ownRhythm(const Look &look) {
  return look.rank < toldApart ? rhythmsOfRanks.at(look.rank % rhythmsOfRanks.size()) : Rhythm();
}

/// How one mark is drawn.
struct Brush {
  Color color;
  double width; ///< what radii are multiplied by
  Rhythm rhythm;
  double setback = 0; ///< of an arrow's tip
  double fade = 0;    ///< how far what goes on fades …
  Color ground{};     ///< … into this
};

void addLine(Mesh &mesh, std::span<const Place> path, double radius, const Brush &brush) {
  if (brush.rhythm.empty())
    addTube(mesh, path, radius * brush.width, brush.color);
  else
    for (std::size_t i = 1; i < path.size(); ++i)
      addDashes(mesh, path[i - 1], path[i], radius * brush.width, brush.rhythm, brush.color);
}

/// A line that goes on beyond its end, or beyond both: it fades there, as a clear end would seem to be where
/// it stops, or where it meets what is seen behind it.
void addEndless(Mesh &mesh, const Place &from, const Place &to, bool both, double radius,
                const Brush &brush) {
  const double length = glm::distance(from, to);
  if (!(length > 0))
    return;
  const double faded = std::min(brush.fade, mostFaded * length);
  const Place along = (to - from) / length;
  const std::size_t first = mesh.positions.size();
  if (brush.rhythm.empty())
    addLine(mesh, std::array{from, from + along * faded, to - along * faded, to}, radius, brush);
  else
    addLine(mesh, std::array{from, to}, radius, brush);
  for (std::size_t i = first; i < mesh.positions.size(); ++i) {
    const double way = glm::dot(Place(mesh.positions[i]) - from, along);
    const double left = both ? std::min(way, length - way) : length - way;
    mesh.colors[i] =
        mix(brush.ground, brush.color, std::lerp(strengthAtEnd, 1.0, std::clamp(left / faded, 0.0, 1.0)));
  }
}

void addBorder(Mesh &mesh, std::vector<Place> corners, double radius, const Brush &brush) {
  if (!brush.rhythm.empty() && !corners.empty()) {
    corners.push_back(corners.front());
    addLine(mesh, corners, radius, brush);
  } else {
    addRing(mesh, corners, radius * brush.width, brush.color);
  }
}

Color patchBorderColor(const PlanePatchMark &patch, const Brush &brush, const Theme &theme) {
  const bool isPlain =
      patch.subject == Subject::Plane && patch.role != Role::Warning && patch.role != Role::Ghost;
  return isPlain ? mix(theme.patchFaceOf(hueOf(patch)), brush.color, patchBorderDepth) : brush.color;
}

/// How the points of a figure are drawn.
struct Balls {
  BallSizes sizes;
  BallDetail detail;
};

void addMark(Mesh &mesh, const Mark &mark, const Brush &brush, const Balls &balls, const Theme &theme,
             double scale) {
  const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
  if (outline.path.empty())
    return;
  const double radius = strokeRadius(mark);
  const auto line = [&] { addLine(mesh, outline.path, radius, brush); };
  const auto endless = [&](bool both) {
    addEndless(mesh, outline.path.front(), outline.path.back(), both, radius, brush);
  };
  std::visit(
      Overloaded{
          [&](const PointMark &point) {
            addBall(mesh, point.at, balls.sizes.radiusOf(point, brush.width), brush.color, balls.detail);
          },
          [&](const SegmentMark &) { line(); },
          [&](const RayMark &) { endless(false); },
          [&](const LineMark &) { endless(true); },
          [&](const ArrowMark &arrow) {
            const Place way = shownVector(arrow);
            const double length = glm::length(way);
            const double shown = length > 0 ? 1 - brush.setback / length : 0;
            addArrow(mesh, arrow.from, way * shown, radius * brush.width, brush.color, brush.rhythm);
          },
          [&](const PlanePatchMark &patch) {
            const Brush border{patchBorderColor(patch, brush, theme), brush.width, brush.rhythm};
            addBorder(mesh, outline.path, radius, border);
          },
          [&](const PolygonMark &) { addBorder(mesh, outline.path, radius, brush); },
          [&](const SphereMark &) { line(); },
          [](const MeshMark &) {}, // a surface of its own, without lines
          [&](const ArcMark &) { addTube(mesh, outline.path, radius * brush.width, brush.color); },
          [&](const RightAngleMark &) { addTube(mesh, outline.path, radius * brush.width, brush.color); },
      },
      mark);
}

} // namespace

double strokeRadius(const Mark &mark) {
  return std::visit(
      Overloaded{[](const PointMark &) { return 0.0; }, [](const SegmentMark &) { return segmentRadius; },
                 [](const RayMark &) { return rayRadius; }, [](const LineMark &) { return rayRadius; },
                 [](const ArrowMark &) { return arrowRadius; },
                 [](const PlanePatchMark &) { return patchEdgeRadius; },
                 [](const PolygonMark &) { return polygonEdgeRadius; },
                 [](const SphereMark &) { return sphereRadius; }, [](const MeshMark &) { return 0.0; },
                 [](const ArcMark &) { return angleRadius; },
                 [](const RightAngleMark &) { return angleRadius; }},
      mark);
}

double ballRadius(const PointMark &point) {
  if (point.passes)
    return flyingRadius;
  const bool isFree = point.subject == Subject::Point && point.role == Role::Given;
  return isFree ? freePointRadius : pointRadius;
}

double thicknessOf(const MarkBase &mark, const Theme &theme, double scale) {
  return scale * theme.lineScale * widthOf(mark.role);
}

Rhythm rhythmOf(const MarkBase &mark, double scale) {
  const bool isAside = mark.role == Role::Helper || mark.role == Role::Ghost;
  Rhythm rhythm = isAside ? shortDashes : ownRhythm(mark.look);
  for (double &length : rhythm)
    length *= dashLength * scale;
  return rhythm;
}

Color solidColor(const MarkBase &mark, const Theme &theme, bool highlighted) {
  Color color = mark.role == Role::Warning ? theme.warning : theme.colorOf(hueOf(mark));
  if (mark.role == Role::Ghost)
    color = mix(color, theme.backgroundBottom, ghostPaleness);
  return highlighted ? mix(color, theme.ink, highlightInk) : color;
}

Mesh meshOf(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme, double scale,
            const Arrival &arrival) {
  Mesh mesh;
  makeRoom(mesh, figure.marks.size() * usualCorners);
  const Balls balls{BallSizes(figure), ballDetailFor(figure)};
  const ArrowsByStart arrows(figure);
  for (const Mark &mark : figure.marks) {
    const MarkBase &base = baseOf(mark);
    const bool standsOut = highlighted.contains(base.id);
    const double presence = arrival.presenceOf(base);
    if (presence <= 0)
      continue;
    const double width = thicknessOf(base, theme, scale) * (standsOut ? highlightOf(mark) : 1) *
                         sleeveOf(mark, arrows) * presence;
    const auto *arrow = std::get_if<ArrowMark>(&mark);
    const double setback = arrow ? setbackOf(*arrow, arrows, thicknessOf(base, theme, scale)) : 0;
    const Brush brush{mix(theme.backgroundBottom, solidColor(base, theme, standsOut), presence),
                      width,
                      rhythmOf(base, scale),
                      setback,
                      fadeLength * scale,
                      theme.backgroundBottom};
    addMark(mesh, mark, brush, balls, theme, scale);
  }
  return mesh;
}

} // namespace halfspace
