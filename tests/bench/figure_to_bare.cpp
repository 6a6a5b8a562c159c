#include "tests/bench/figure_to_bare.h"

#include "geometry/triangle_mesh.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/labels/label_requests.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/translucent_faces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

namespace halfspace::bench {
namespace {

// As thick as the program draws them, in scene units at scale 1.
constexpr double ballRadius = 0.23;
constexpr double arrowRadius = 0.11;
constexpr double lineRadius = 0.06;
constexpr double thinRadius = 0.045;
constexpr double axisRadius = 0.055;
constexpr double dropDash = 0.42;
constexpr double dropGap = 0.29;
constexpr double gizmoLength = 64; ///< in pixels
constexpr double gizmoRadius = 1.6;

glm::dvec3 rgb(Color color) { return glm::dvec3(color.red, color.green, color.blue) / 255.0; }

std::vector<Path> dashes(const Path &path, const Rhythm &rhythm) {
  std::vector<Path> pieces;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = glm::distance(path[i - 1], path[i]);
    double at = 0;
    for (std::size_t k = 0; at < length; at += rhythm[k], k = (k + 1) % rhythm.size())
      if (k % 2 == 0)
        pieces.push_back({glm::mix(path[i - 1], path[i], at / length),
                          glm::mix(path[i - 1], path[i], std::min(1.0, (at + rhythm[k]) / length))});
  }
  return pieces;
}

BareThing solidOf(const Mark &mark, Path path, const Theme &theme, double scale) {
  const MarkBase &base = baseOf(mark);
  const glm::dvec3 color = rgb(solidColor(base, theme, false));
  if (const auto *point = std::get_if<PointMark>(&mark)) {
    const bool isFree = base.subject == Subject::Point && base.role == Role::Given;
    return BareBall{point->at, (isFree ? freePointRadius : ballRadius) * scale, color};
  }
  if (const auto *arrow = std::get_if<ArrowMark>(&mark))
    return BareArrow{arrow->from, arrow->vector, arrowRadius * scale, color};
  const bool isFace =
      std::holds_alternative<PlanePatchMark>(mark) || std::holds_alternative<PolygonMark>(mark);
  if (isFace)
    path.push_back(path.front());
  const bool isThin =
      isFace || std::holds_alternative<ArcMark>(mark) || std::holds_alternative<RightAngleMark>(mark);
  const double radius = (isThin ? thinRadius : lineRadius) * scale;
  const Rhythm rhythm = rhythmOf(base, scale);
  return BareTubes{rhythm.empty() ? std::vector<Path>{std::move(path)} : dashes(path, rhythm), radius, color};
}

/// The same triangles are handed over once.
BareMesh meshOf(const MeshMark &mark, const Theme &theme) {
  using Copies = std::map<std::shared_ptr<const TriangleMesh>, BareMesh>;
  static Copies copies;
  BareMesh &copy = copies[mark.mesh];
  if (!copy.corners) {
    copy.corners =
        std::make_shared<std::vector<glm::dvec3>>(mark.mesh->corners.begin(), mark.mesh->corners.end());
    auto triangles = std::make_shared<std::vector<glm::uvec3>>();
    for (const auto &[a, b, c] : mark.mesh->triangles)
      triangles->emplace_back(a, b, c);
    copy.triangles = std::move(triangles);
  }
  BareMesh mesh = copy;
  mesh.placement = glm::dmat4(mark.axes);
  mesh.placement[3] = glm::dvec4(mark.place, 1);
  mesh.color = rgb(solidColor(mark, theme, false));
  return mesh;
}

void addGround(BarePicture &picture, const SceneContent &content, const Theme &theme, const View &view,
               double scale) {
  BareGrid grid{{}, rgb(theme.grid)};
  for (const Grid::Line &line : gridAround(view.camera).lines)
    grid.lines.push_back({line.points.front(), line.points.back()});
  picture.things[" grid"] = std::move(grid);
  const AxesReach reach = axesFor({});
  for (int axis = 0; axis < 3; ++axis) {
    Place vector(0);
    vector[axis] = reach.high[axis];
    picture.things[" axis " + std::to_string(axis)] =
        BareArrow{{}, vector, axisRadius * scale, rgb(theme.axis)};
  }
  if (content.dropLine) {
    const Place from = content.dropLine->from;
    picture.things[" drop line"] =
        BareTubes{dashes({from, {from.x, from.y, 0}}, {dropDash * scale, dropGap * scale}),
                  thinRadius * scale, rgb(theme.accent)};
  }
}

void addTools(BarePicture &picture, const SceneContent &content, const Theme &theme, const View &view) {
  const auto addArrow = [&](const std::string &name, Place at, Place direction, Color color) {
    const double unit = view.unitsPerDesignPixel(at);
    picture.things[name] = BareArrow{at, direction * gizmoLength * unit, gizmoRadius * unit, rgb(color)};
  };
  if (content.gizmo)
    for (int axis = 0; axis < 3; ++axis) {
      Place direction(0);
      direction[axis] = 1;
      addArrow(" gizmo " + std::to_string(axis), content.gizmo->at, direction, theme.accent);
    }
  for (const Knob &knob : content.knobs)
    addArrow(" knob " + knob.id, knob.at, knob.axis ? glm::normalize(*knob.axis) / 2.0 : Place(0, 0, 0.5),
             theme.colorOf(knob.subject));
}

void addLabels(BarePicture &picture, const SceneContent &content, const Theme &theme, const View &view,
               const LabelSetter &set, const LabelPainter &paint, double scale) {
  const auto axes = axisLabels(axesFor({}), view.camera, 0, scale);
  for (const WrittenLabel &text : writtenLabels(content, axes, theme, view)) {
    const auto image = paint(set(text.latex), text.style);
    if (image && image->width > 0 && !text.anchors.empty())
      picture.labels.push_back(
          {{image->width, image->height, image->rgba.data(), image},
           {text.anchors.front().pixel.x, view.size.height - text.anchors.front().pixel.y}});
  }
}

} // namespace

BarePicture bareOf(const SceneContent &content, const Theme &theme, const View &view, const LabelSetter &set,
                   const LabelPainter &paint) {
  const double scale = designScale(view.camera, view.size, view.pixelRatio);
  BarePicture picture;
  addGround(picture, content, theme, view, scale);
  for (const Mark &mark : content.figure.marks) {
    if (const auto *mesh = std::get_if<MeshMark>(&mark)) {
      picture.things[mesh->id] = meshOf(*mesh, theme);
      continue; // its outline is its box, which is not drawn
    }
    const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
    if (!outline.path.empty())
      picture.things[baseOf(mark).id] = solidOf(mark, outline.path, theme, scale);
  }
  int face = 0;
  for (const Face &polygon : facesOf(content.figure, {}, theme))
    picture.things["face " + std::to_string(face++)] =
        BareFace{polygon.corners, rgb(polygon.color), polygon.opacity};
  addTools(picture, content, theme, view);
  addLabels(picture, content, theme, view, set, paint, scale);
  return picture;
}

} // namespace halfspace::bench
