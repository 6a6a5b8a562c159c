#include "widgets/picture/shapes/tool_shapes.h"

#include "lessons/scene/scene.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

// All in design pixels.
constexpr double thinRadius = 1.0;
constexpr double toolRadius = 1.5;
constexpr double modeReach = 30;
constexpr double modeStart = 14;
constexpr double dropDash = 6;
constexpr double dropGap = 4.2;
constexpr double dropRadius = 1.1;
constexpr double footRadius = 5;

constexpr int discCorners = 36;

constexpr std::array<Place, 3> axes{Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}};

/// A line around corners.
LineShape ring(std::vector<Place> corners, double radius) { return {std::move(corners), radius, {}, true}; }

/// A circle around an axis ≠ 0.
LineShape circle(Place center, Place axis, double radius, double lineRadius) {
  return ring(circleAround(center, glm::normalize(axis), radius, discCorners), lineRadius);
}

/// Two arrows from a place, one each way along a direction.
void addDoubleArrow(std::vector<Shape> &shapes, Place at, Place direction, double start, double end,
                    double radius, Color color) {
  if (direction == Place(0))
    return;
  const Place along = glm::normalize(direction);
  for (const double way : {1.0, -1.0})
    shapes.push_back(
        {{}, color, ArrowShape{at + along * (way * start), along * (way * (end - start)), radius}});
}

void addGizmoPart(std::vector<Shape> &shapes, const GizmoPartShape &shape, bool isHot, const Theme &theme,
                  double unit) {
  const Color color = isHot ? theme.accent : theme.mutedInk;
  const double width = (isHot ? hotWidth : 1) * unit;
  if (shape.isSquare()) {
    shapes.push_back({{}, mix(color, theme.backgroundTop, 0.6), FaceShape{shape.outline}});
    shapes.push_back({{}, color, ring(shape.outline, thinRadius * width)});
  } else {
    shapes.push_back(
        {{}, color, ArrowShape{shape.outline[0], shape.outline[1] - shape.outline[0], toolRadius * width}});
  }
}

/// The way the handle moves now, drawn on the handle itself.
void addMode(std::vector<Shape> &shapes, const Gizmo &gizmo, const Theme &theme, double unit) {
  const auto along = [&](Place direction) {
    addDoubleArrow(shapes, gizmo.at, direction, modeStart * unit, modeReach * unit, toolRadius * unit,
                   theme.accent);
  };
  const auto around = [&](Place axis) {
    shapes.push_back({{}, theme.accent, circle(gizmo.at, axis, modeRingRadius * unit, toolRadius * unit)});
  };
  switch (gizmo.mode) {
  case Gizmo::Mode::None:
    return;
  case Gizmo::Mode::Horizontal:
    return around(axes[2]);
  case Gizmo::Mode::AlongX:
    return along(axes[0]);
  case Gizmo::Mode::AlongY:
    return along(axes[1]);
  case Gizmo::Mode::Vertical:
  case Gizmo::Mode::AlongZ:
    return along(axes[2]);
  case Gizmo::Mode::InPlane:
    return around(gizmo.normal);
  case Gizmo::Mode::AlongAxis:
    return along(gizmo.axis.value_or(Place(0)));
  }
}

void addGizmo(std::vector<Shape> &shapes, const Gizmo &gizmo, const Theme &theme, const View &view) {
  const double unit = view.unitsPerDesignPixel(gizmo.at);
  if (unit <= 0)
    return;
  for (const GizmoPartShape &shape : gizmoParts(gizmo, view.camera, view.size, view.pixelRatio))
    addGizmoPart(shapes, shape, gizmo.hot == shape.part, theme, unit);
  if (gizmo.mode != Gizmo::Mode::None)
    addMode(shapes, gizmo, theme, unit);
  else if (gizmo.axis)
    addDoubleArrow(shapes, gizmo.at, *gizmo.axis, modeStart * unit, modeReach * unit, toolRadius * unit,
                   theme.mutedInk);
}

/// The hue that the whole object has, where it has one of its own.
Hue knobHue(const Knob &knob, const Figure &figure) {
  const Mark *whole = findMark(figure, ownerOf(knob.id));
  const Hue usual = hueOf(knob.subject);
  return whole ? baseOf(*whole).look.hue.value_or(usual) : usual;
}

void addKnob(std::vector<Shape> &shapes, const Knob &knob, Hue hue, const Theme &theme, const View &view) {
  const double unit = view.unitsPerDesignPixel(knob.at) * (knob.hot ? hotWidth : 1);
  const Color color = knob.hot ? theme.accent : theme.colorOf(hue);
  if (unit <= 0)
    return;
  shapes.push_back({{}, color, BallShape{knob.at, knobBall * unit}});
  for (const Place &direction : knobDirections(knob, view.camera))
    addDoubleArrow(shapes, knob.at, direction, 0, knobReach * unit, knobRadius * unit, color);
}

void addDropLine(std::vector<Shape> &shapes, const DropLine &line, bool toAxes, const Theme &theme,
                 const View &view) {
  const Place foot(line.from.x, line.from.y, 0);
  const double unit = view.unitsPerDesignPixel(foot);
  if (unit <= 0)
    return;
  const auto dashes = [&](Place from, Place to) {
    shapes.push_back(
        {{}, theme.mutedInk, LineShape{{from, to}, dropRadius * unit, {dropDash * unit, dropGap * unit}}});
  };
  dashes(line.from, foot);
  if (toAxes) {
    dashes(foot, {foot.x, 0, 0});
    dashes(foot, {0, foot.y, 0});
  }
  shapes.push_back({{}, theme.mutedInk, circle(foot, axes[2], footRadius * unit, dropRadius * unit)});
}

} // namespace

std::vector<Shape> toolsOf(const SceneContent &content, const Theme &theme, const View &view) {
  std::vector<Shape> shapes;
  if (content.dropLine)
    addDropLine(shapes, *content.dropLine, content.showsAxes(), theme, view);
  for (const Knob &knob : content.knobs)
    addKnob(shapes, knob, knobHue(knob, content.figure), theme, view);
  if (content.gizmo)
    addGizmo(shapes, *content.gizmo, theme, view);
  return shapes;
}

} // namespace halfspace
