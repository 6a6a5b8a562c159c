#include "widgets/picture/shapes/mark_shapes.h"

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
/// length.
constexpr double fadeLength = 3;
constexpr double mostFaded = 0.3;

/// More points than this are drawn as coarse balls.
constexpr int mostFineBalls = 150;

constexpr double highlightWidth = 1.55;
/// A ball is thick as it is: much thicker, it would cover what lies beside it.
constexpr double highlightBallWidth = 1.2;
constexpr double highlightInk = 0.22;
/// Dashes tell a ghost from the rest as well: paler than this it would be lost behind a plane.
constexpr double ghostPaleness = 0.3;
constexpr double patchBorderDepth = 0.35;
/// Whole surfaces in the colour of lines would be too dark: they take so much of it.
constexpr double bodyInk = 0.55;

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

bool hasVeryManyPoints(const Figure &figure) {
  return mostFineBalls < std::count_if(
                             figure.marks.begin(), figure.marks.end(),
                             [](const Mark &mark) { return std::holds_alternative<PointMark>(mark); });
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

/// Solid, dashed, dotted, where somebody has chosen: unlike the dashes of helpers and of further objects.
const std::array<Rhythm, lineStyleCount> rhythmsOfStyles{{{}, {1.6, 1.0}, {0.35, 0.6}}};

Rhythm ownRhythm(const Look &look) {
  if (look.line)
    return rhythmsOfStyles.at(static_cast<std::size_t>(*look.line));
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

LineShape lineOf(std::vector<Place> path, double radius, const Brush &brush) {
  return {std::move(path), radius * brush.width, brush.rhythm};
}

/// A line that goes on beyond its end, or beyond both: it fades there, as a clear end would seem to be where
/// it stops, or where it meets what is seen behind it. Nothing for one without length.
std::optional<LineShape> endlessLine(const std::vector<Place> &ends, bool both, double radius,
                                     const Brush &brush) {
  const double length = glm::distance(ends.front(), ends.back());
  if (!(length > 0))
    return {};
  LineShape line = lineOf({ends.front(), ends.back()}, radius, brush);
  line.fade = LineFade{brush.ground, std::min(brush.fade, mostFaded * length), both};
  return line;
}

LineShape borderOf(std::vector<Place> corners, double radius, const Brush &brush) {
  LineShape border = lineOf(std::move(corners), radius, brush);
  border.isClosed = true;
  return border;
}

Color patchBorderColor(const PlanePatchMark &patch, const Brush &brush, const Theme &theme) {
  const bool isPlain =
      patch.subject == Subject::Plane && patch.role != Role::Warning && patch.role != Role::Ghost;
  return isPlain ? mix(theme.patchFaceOf(hueOf(patch)), brush.color, patchBorderDepth) : brush.color;
}

/// How the points of a figure are drawn.
struct Balls {
  BallSizes sizes;
  bool areVeryMany;
};

/// What is solid of a mark; nothing for one without.
std::optional<ShapeForm> solidForm(const Mark &mark, const Brush &brush, const Balls &balls, double scale) {
  using Form = std::optional<ShapeForm>;
  MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
  std::vector<Place> &path = outline.path;
  if (path.empty())
    return {};
  const double radius = strokeRadius(mark);
  const auto line = [&] { return lineOf(std::move(path), radius, brush); };
  const auto border = [&] { return borderOf(std::move(path), radius, brush); };
  const auto whole = [&] { return LineShape{std::move(path), radius * brush.width}; };
  return std::visit(
      Overloaded{
          [&](const PointMark &point) -> Form {
            return BallShape{point.at, balls.sizes.radiusOf(point, brush.width), balls.areVeryMany};
          },
          [&](const SegmentMark &) -> Form { return line(); },
          [&](const RayMark &) -> Form { return endlessLine(path, false, radius, brush); },
          [&](const LineMark &) -> Form { return endlessLine(path, true, radius, brush); },
          [&](const ArrowMark &arrow) -> Form {
            const Place way = shownVector(arrow);
            const double length = glm::length(way);
            const double shown = length > 0 ? 1 - brush.setback / length : 0;
            return ArrowShape{arrow.from, way * shown, radius * brush.width, brush.rhythm};
          },
          [&](const PlanePatchMark &) -> Form { return border(); },
          [&](const PolygonMark &) -> Form { return border(); },
          [&](const SphereMark &) -> Form { return line(); },
          [](const MeshMark &) -> Form { return {}; }, // a body, without lines
          [&](const ArcMark &) -> Form { return whole(); },
          [&](const RightAngleMark &) -> Form { return whole(); },
      },
      mark);
}

Color solidColorOf(const Mark &mark, const Brush &brush, const Theme &theme) {
  const auto *patch = std::get_if<PlanePatchMark>(&mark);
  return patch ? patchBorderColor(*patch, brush, theme) : brush.color;
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

std::vector<Shape> solidsOf(const Figure &figure, const std::set<std::string> &highlighted,
                            const Theme &theme, double scale, const Arrival &arrival) {
  std::vector<Shape> solids;
  solids.reserve(figure.marks.size());
  const Balls balls{BallSizes(figure), hasVeryManyPoints(figure)};
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
    if (auto form = solidForm(mark, brush, balls, scale))
      solids.push_back({base.id, solidColorOf(mark, brush, theme), std::move(*form)});
  }
  return solids;
}

std::vector<Shape> bodiesOf(const Figure &figure, const std::set<std::string> &highlighted,
                            const Theme &theme, const Arrival &arrival) {
  std::vector<Shape> bodies;
  for (const Mark &mark : figure.marks) {
    const auto *body = std::get_if<MeshMark>(&mark);
    const double presence = body ? arrival.presenceOf(*body) : 0;
    if (presence <= 0)
      continue;
    const Color color = mix(theme.backgroundBottom, solidColor(*body, theme, highlighted.contains(body->id)),
                            bodyInk * presence);
    bodies.push_back({body->id, color, BodyShape{body->mesh, body->axes, body->place}});
  }
  return bodies;
}

} // namespace halfspace
