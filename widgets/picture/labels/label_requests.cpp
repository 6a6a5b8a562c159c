#include "widgets/picture/labels/label_requests.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/labels/number_text.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace halfspace {
namespace {

/// What balls and arrow heads cover around an anchor, in design pixels.
constexpr double lineClearance = 5;
constexpr double tipRadius = 8;
constexpr double tipClearance = 9;
constexpr double gizmoClearance = 26;
constexpr double knobClearance = 16;
constexpr double dropNumberClearance = 12;

/// Where along a line its label may stand, the best place first.
constexpr std::array besideLineParts{0.5, 0.65, 0.35, 0.8};

constexpr std::array besideArrowParts{0.5, 0.7, 0.3};

/// Where along an arc, the best place first.
constexpr std::array alongArcParts{0.5, 0.3, 0.7};

/// Where along an arrow's head discs are as thick as it is, as parts of the way from its tip to its base.
constexpr std::array alongHeadParts{0.5, 1.0};

/// Beside a point a label is best to the upper right.
constexpr glm::dvec2 upperRight{1, -0.8};

glm::dvec2 squareTo(glm::dvec2 along) {
  const glm::dvec2 side(along.y, -along.x);
  return side.y > 0 || (side.y == 0 && side.x < 0) ? -side : side;
}

/// Collects the anchors of one mark, those behind the eye left out.
class Anchors {
public:
  /// What stands there is so many times as thick as usual.
  Anchors(const View &view, double thickness) : m_view(view), m_thickness(thickness) {}

  void add(Place at, glm::dvec2 toward, double clearance) {
    if (const auto pixel = pixelOf(at))
      m_anchors.push_back({*pixel, toward, clearance * m_thickness * m_view.pixelRatio});
  }

  /// Beside a line, at a part of its length.
  void addBeside(Place from, Place to, double part) {
    const auto start = pixelOf(from);
    const auto end = pixelOf(to);
    if (start && end)
      add(glm::mix(from, to, part), squareTo(*end - *start), lineClearance);
  }

  /// Beyond the tip of an arrow, in its direction.
  void addTip(Place from, Place tip) {
    const auto start = pixelOf(from);
    const auto end = pixelOf(tip);
    if (start && end && *start != *end)
      add(tip, glm::normalize(*end - *start) + glm::dvec2(0, -0.4), tipClearance);
  }

  /// Beside a place, on the side where another one is.
  void addTowards(Place at, Place side, double clearance) {
    const auto start = pixelOf(at);
    const auto end = pixelOf(side);
    if (start && end)
      add(at, *end - *start, clearance);
  }

  /// Beside the corners of a patch, the highest on the screen first.
  void addCorners(const std::vector<Place> &corners) {
    const std::size_t first = m_anchors.size();
    for (const Place &corner : corners)
      add(corner, {1, -0.3}, tipClearance);
    std::sort(m_anchors.begin() + static_cast<std::ptrdiff_t>(first), m_anchors.end(),
              [](const LabelAnchor &a, const LabelAnchor &b) { return a.pixel.y < b.pixel.y; });
  }

  [[nodiscard]] std::vector<LabelAnchor> take() { return std::move(m_anchors); }

private:
  [[nodiscard]] std::optional<glm::dvec2> pixelOf(Place at) const {
    const auto pixel = m_view.camera.project(at, m_view.size);
    return pixel ? std::optional(glm::dvec2(*pixel)) : std::nullopt;
  }

  const View &m_view;
  double m_thickness;
  std::vector<LabelAnchor> m_anchors;
};

/// What a point's ball covers around its middle, in design pixels.
double clearanceOf(const PointMark &point) { return ballRadius(point) * designHeight / designUnits; }

Place middleOf(const std::vector<Place> &places) {
  return std::accumulate(places.begin(), places.end(), Place(0)) / static_cast<double>(places.size());
}

/// How far the middle of a face is from its border; 0 where it lies outside.
double roomAround(glm::dvec2 middle, const std::vector<glm::dvec2> &corners) {
  if (!isInside(middle, corners))
    return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(middle, corners[i], corners[(i + 1) % corners.size()]));
  return nearest;
}

/// The middle of a face, which covers what is around it; nothing where some of it is behind the eye.
std::optional<LabelAnchor> middleAnchor(const std::vector<Place> &corners, const View &view) {
  const auto middle = view.camera.project(middleOf(corners), view.size);
  const auto pixels = projectAll(view.camera, view.size, corners);
  if (!middle || !pixels)
    return {};
  const std::vector<glm::dvec2> border(pixels->begin(), pixels->end());
  const glm::dvec2 pixel(*middle);
  return LabelAnchor{pixel, {0, 0}, roomAround(pixel, border)};
}

/// The one place of a mark that what somebody does to its label is measured from: of a face its middle, as
/// the corner that is liked best is another from elsewhere; of all others where its label is liked best.
std::optional<LabelAnchor> ownAnchorOf(const MarkOutline &outline, const std::vector<LabelAnchor> &anchors,
                                       const View &view) {
  if (outline.kind == MarkOutline::Kind::Face && !outline.path.empty())
    return middleAnchor(outline.path, view);
  return anchors.empty() ? std::nullopt : std::optional(anchors.front());
}

std::vector<LabelAnchor> anchorsOf(const Mark &mark, const MarkOutline &outline, const Theme &theme,
                                   const View &view) {
  if (outline.path.empty())
    return {};
  const std::vector<Place> &path = outline.path;
  Anchors anchors(view, theme.lineScale);
  const auto besideLine = [&] {
    for (const double part : besideLineParts)
      anchors.addBeside(path.front(), path.back(), part);
  };
  std::visit(Overloaded{
                 [&](const PointMark &point) { anchors.add(point.at, upperRight, clearanceOf(point)); },
                 [&](const SegmentMark &) { besideLine(); },
                 [&](const RayMark &) { besideLine(); },
                 [&](const LineMark &) { besideLine(); },
                 [&](const ArrowMark &) {
                   anchors.addTip(path.front(), path.back());
                   for (const double part : besideArrowParts)
                     anchors.addBeside(path.front(), path.back(), part);
                 },
                 [&](const PlanePatchMark &) { anchors.addCorners(path); },
                 [&](const PolygonMark &) {
                   anchors.add(middleOf(path), {0, 0}, 0);
                 },
                 [&](const SphereMark &sphere) {
                   anchors.addTip(sphere.center, sphere.center + Place(0, 0, sphere.radius));
                   anchors.addTip(sphere.center, sphere.center + Place(0, sphere.radius, 0));
                 },
                 [&](const MeshMark &) {
                   anchors.add(middleOf(path), {0, 0}, 0);
                 },
                 [&](const ArcMark &arc) {
                   for (const double part : alongArcParts)
                     anchors.addTip(arc.center, path[static_cast<std::size_t>(part * double(path.size()))]);
                 },
                 [&](const RightAngleMark &corner) { anchors.addTip(corner.at, path[1]); },
             },
             mark);
  return anchors.take();
}

/// A mark without a letter may have a number alone beside it.
bool isLabelled(const Mark &mark) { return !baseOf(mark).label.empty() || !baseOf(mark).numbers.empty(); }

/// What is written beside a mark: its letter, with what is known of it.
std::string textOf(const Mark &mark, const ShownParts &shown) {
  const MarkBase &base = baseOf(mark);
  const bool hasCoordinates = shown.coordinates && !base.label.empty();
  return base.label + (hasCoordinates ? base.coordinates : "") + base.numbers;
}

/// The numbers of the marks whose labels are written.
std::vector<std::size_t> labelledMarks(const SceneContent &content) {
  if (!content.shown.labels)
    return {};
  const auto standsOut = [&](std::size_t mark) {
    return content.highlighted.contains(baseOf(content.figure.marks[mark]).id);
  };
  std::vector<std::size_t> marks;
  for (std::size_t mark = 0; mark < content.figure.marks.size(); ++mark)
    if (isLabelled(content.figure.marks[mark]))
      marks.push_back(mark);
  if (marks.size() > mostMarkLabels) {
    std::stable_partition(marks.begin(), marks.end(), standsOut);
    marks.resize(mostMarkLabels);
  }
  return marks;
}

std::vector<Place> closed(std::vector<Place> corners) {
  corners.push_back(corners.front());
  return corners;
}

/// Beyond the tip of an axis, whose name gives way to what is already there.
std::vector<LabelAnchor> axisNameAnchors(Place tip, const Theme &theme, const View &view) {
  Anchors anchors(view, theme.lineScale);
  anchors.addTip(Place(0), tip);
  anchors.add(tip, upperRight, tipClearance);
  return anchors.take();
}

/// Collects what labels should not cover, what is behind the eye left out.
class Obstacles {
public:
  Obstacles(const ShownParts &shown, const Theme &theme, const View &view)
      : m_shown(shown), m_theme(theme), m_view(view),
        m_scale(designScale(view.camera, view.size, view.pixelRatio)) {}

  /// The radius is in design pixels.
  void addDisc(Place at, double radius, LabelOwner owner = nobody) {
    if (const auto pixel = m_view.camera.project(at, m_view.size))
      m_found.discs.push_back({glm::dvec2(*pixel), radius * m_view.pixelRatio, owner});
  }

  void addMark(const Mark &mark, std::size_t number) {
    const MarkOutline outline = outlineOf(mark, rightAngleSize * m_scale);
    if (outline.path.empty())
      return;
    const auto *arrow = std::get_if<ArrowMark>(&mark);
    const LabelOwner owner = m_shown.labels && isLabelled(mark) ? number : nobody;
    switch (outline.kind) {
    case MarkOutline::Kind::Point:
      addDisc(outline.path.front(), clearanceOf(std::get<PointMark>(mark)) * m_theme.lineScale, owner);
      break;
    case MarkOutline::Kind::Line:
      addPath(outline.path, arrow != nullptr, m_found.segments, owner);
      break;
    case MarkOutline::Kind::Face:
      addPath(closed(outline.path), false, m_found.segments);
      break;
    case MarkOutline::Kind::Body: // its box has edges that nobody sees
      break;
    }
    if (arrow)
      addHead(*arrow, outline.path.back());
  }

  void addAxes(const AxesReach &axes) {
    for (const auto &[low, high] : axisEnds(axes))
      addPath({low, high}, true, m_found.segments);
    for (const auto &[low, high] : axisTicks(axes, m_view.camera, m_scale))
      addPath({low, high}, true, m_found.ticks);
  }

  void addTool(const std::vector<Place> &outline) { addPath(outline, false, m_found.tools); }

  [[nodiscard]] LabelObstacles take() {
    m_found.covered = m_view.covered;
    return std::move(m_found);
  }

private:
  using Segments = std::vector<LabelObstacles::Segment>;

  void addPath(const std::vector<Place> &path, bool isThick, Segments &segments,
               LabelOwner owner = nobody) const {
    std::optional<glm::dvec3> previous;
    for (const Place &place : path) {
      const auto pixel = m_view.camera.project(place, m_view.size);
      if (pixel && previous)
        segments.push_back({glm::dvec2(*previous), glm::dvec2(*pixel), isThick, owner});
      previous = pixel;
    }
  }

  /// The cone of an arrow's head, from its tip to its base.
  void addHead(const ArrowMark &arrow, Place tip) {
    const Place way = shownVector(arrow);
    const double length = glm::length(way);
    const ArrowHead head = headOfArrow(length, arrowRadius * thicknessOf(arrow, m_theme, m_scale));
    for (const double part : alongHeadParts) {
      const Place at = tip - way * (part * head.length / length);
      if (const double unit = m_view.unitsPerDesignPixel(at); unit > 0)
        addDisc(at, part * head.radius / unit);
    }
    addDisc(tip, tipRadius * m_theme.lineScale);
  }

  const ShownParts &m_shown;
  const Theme &m_theme;
  const View &m_view;
  double m_scale;
  LabelObstacles m_found;
};

} // namespace

std::vector<WrittenLabel> writtenLabels(const SceneContent &content, const std::vector<AxisLabel> &axes,
                                        const Theme &theme, const View &view) {
  std::vector<WrittenLabel> texts;
  const double pixels = view.pixelRatio * theme.textScale;
  const double scale = designScale(view.camera, view.size, view.pixelRatio);
  const auto style = [&](Color ink, double size) { return LabelStyle{ink, theme.halo, size * pixels}; };
  const auto at = [&](Place place) {
    Anchors anchors(view, theme.lineScale);
    anchors.add(place, {0, 0}, 0);
    return anchors.take();
  };

  for (const AxisLabel &label : axes)
    if (label.isName)
      texts.push_back({"axis " + label.latex, label.latex, style(theme.ink, markTextSize),
                       axisNameAnchors(label.at, theme, view)});
    else
      texts.push_back({"tick " + std::to_string(texts.size()), label.latex,
                       style(theme.mutedInk, tickTextSize), at(label.at), LabelStand::Pinned, false, 1,
                       nobody, LabelRow{1 + static_cast<std::size_t>(label.axis), label.tick}});
  for (const std::size_t number : labelledMarks(content)) {
    const Mark &mark = content.figure.marks[number];
    const MarkBase &base = baseOf(mark);
    const Color ink = base.role == Role::Warning ? theme.warning : theme.inkOf(hueOf(base));
    const auto byHand = content.labels.find(base.id);
    const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
    WrittenLabel text{base.id, textOf(mark, content.shown), style(ink, markTextSize),
                      anchorsOf(mark, outline, theme, view),
                      base.passes ? LabelStand::Passing : LabelStand::Beside};
    text.isMark = true;
    text.owner = number;
    text.opacity = content.arrival.presenceOf(base);
    text.own = ownAnchorOf(outline, text.anchors, view);
    if (byHand != content.labels.end() && text.own)
      text.spot = byHand->second.spot;
    texts.push_back(std::move(text));
  }
  if (content.dropLine && content.showsAxes())
    for (const int axis : {0, 1}) {
      const double coordinate = content.dropLine->from[axis];
      const AxisLabel label = axisNumber(axis, coordinate, view.camera, content.stage.exponent, scale);
      Place onAxis(0);
      onAxis[axis] = coordinate;
      Anchors anchors(view, theme.lineScale);
      anchors.addTowards(onAxis, label.at, dropNumberClearance);
      texts.push_back({"drop " + std::to_string(axis), label.latex, style(theme.accent, tickTextSize),
                       anchors.take(), LabelStand::Passing});
    }
  if (content.gizmo && !content.gizmo->note.empty()) {
    Anchors anchors(view, theme.lineScale);
    anchors.add(content.gizmo->at, {-1, 0.6}, gizmoClearance);
    texts.push_back({"gizmo note", content.gizmo->note, style(theme.accent, markTextSize), anchors.take(),
                     LabelStand::Passing});
  }
  return texts;
}

LabelObstacles obstaclesOf(const SceneContent &content, const std::optional<AxesReach> &axes,
                           const Theme &theme, const View &view) {
  Obstacles obstacles(content.shown, theme, view);
  for (std::size_t number = 0; number < content.figure.marks.size(); ++number)
    if (const Mark &mark = content.figure.marks[number]; !baseOf(mark).passes)
      obstacles.addMark(mark, number);
  for (const Knob &knob : content.knobs)
    obstacles.addDisc(knob.at, knobClearance);
  if (axes)
    obstacles.addAxes(*axes);
  if (content.gizmo)
    for (const GizmoPartShape &part : gizmoParts(*content.gizmo, view.camera, view.size, view.pixelRatio))
      obstacles.addTool(part.outline);
  return obstacles.take();
}

} // namespace halfspace
