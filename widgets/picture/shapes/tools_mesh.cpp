#include "widgets/picture/shapes/tools_mesh.h"

#include "widgets/picture/shapes/gizmo_shape.h"

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

/// Around an axis ≠ 0.
std::vector<Place> circle(Place center, Place axis, double radius) {
  return circleAround(center, glm::normalize(axis), radius, discCorners);
}

/// Two arrows from a place, one each way along a direction.
void addDoubleArrow(Mesh &mesh, Place at, Place direction, double start, double end, double radius,
                    Color color) {
  if (direction == Place(0))
    return;
  const Place along = glm::normalize(direction);
  for (const double way : {1.0, -1.0})
    addArrow(mesh, at + along * (way * start), along * (way * (end - start)), radius, color);
}

void addGizmoPart(Mesh &mesh, const GizmoPartShape &shape, bool isHot, const Theme &theme, double unit) {
  const Color color = isHot ? theme.accent : theme.mutedInk;
  const double width = (isHot ? hotWidth : 1) * unit;
  if (shape.isSquare()) {
    addFlat(mesh, shape.outline, mix(color, theme.backgroundTop, 0.6));
    addRing(mesh, shape.outline, thinRadius * width, color);
  } else {
    addArrow(mesh, shape.outline[0], shape.outline[1] - shape.outline[0], toolRadius * width, color);
  }
}

/// The way the handle moves now, drawn on the handle itself.
void addMode(Mesh &mesh, const Gizmo &gizmo, const Theme &theme, double unit) {
  const auto along = [&](Place direction) {
    addDoubleArrow(mesh, gizmo.at, direction, modeStart * unit, modeReach * unit, toolRadius * unit,
                   theme.accent);
  };
  switch (gizmo.mode) {
  case Gizmo::Mode::None:
    return;
  case Gizmo::Mode::Horizontal:
    return addRing(mesh, circle(gizmo.at, axes[2], modeRingRadius * unit), toolRadius * unit, theme.accent);
  case Gizmo::Mode::AlongX:
    return along(axes[0]);
  case Gizmo::Mode::AlongY:
    return along(axes[1]);
  case Gizmo::Mode::Vertical:
  case Gizmo::Mode::AlongZ:
    return along(axes[2]);
  case Gizmo::Mode::InPlane:
    return addRing(mesh, circle(gizmo.at, gizmo.normal, modeRingRadius * unit), toolRadius * unit,
                   theme.accent);
  case Gizmo::Mode::AlongAxis:
    return along(gizmo.axis.value_or(Place(0)));
  }
}

void addGizmo(Mesh &mesh, const Gizmo &gizmo, const Theme &theme, const View &view) {
  const double unit = view.unitsPerDesignPixel(gizmo.at);
  if (unit <= 0)
    return;
  for (const GizmoPartShape &shape : gizmoParts(gizmo, view.camera, view.size, view.pixelRatio))
    addGizmoPart(mesh, shape, gizmo.hot == shape.part, theme, unit);
  if (gizmo.mode != Gizmo::Mode::None)
    addMode(mesh, gizmo, theme, unit);
  else if (gizmo.axis)
    addDoubleArrow(mesh, gizmo.at, *gizmo.axis, modeStart * unit, modeReach * unit, toolRadius * unit,
                   theme.mutedInk);
}

/// The hue that the whole object has, where it has one of its own.
Hue knobHue(const Knob &knob, const Figure &figure) {
  const Mark *whole = findMark(figure, knob.id.substr(0, knob.id.find('.')));
  const Hue usual = hueOf(knob.subject);
  return whole ? baseOf(*whole).look.hue.value_or(usual) : usual;
}

void addKnob(Mesh &mesh, const Knob &knob, Hue hue, const Theme &theme, const View &view) {
  const double unit = view.unitsPerDesignPixel(knob.at) * (knob.hot ? hotWidth : 1);
  const Color color = knob.hot ? theme.accent : theme.colorOf(hue);
  if (unit <= 0)
    return;
  addBall(mesh, knob.at, knobBall * unit, color);
  for (const Place &direction : knobDirections(knob, view.camera))
    addDoubleArrow(mesh, knob.at, direction, 0, knobReach * unit, knobRadius * unit, color);
}

void addDropLine(Mesh &mesh, const DropLine &line, bool toAxes, const Theme &theme, const View &view) {
  const Place foot(line.from.x, line.from.y, 0);
  const double unit = view.unitsPerDesignPixel(foot);
  if (unit <= 0)
    return;
  const auto dashes = [&](Place from, Place to) {
    addDashes(mesh, from, to, dropRadius * unit, {dropDash * unit, dropGap * unit}, theme.mutedInk);
  };
  dashes(line.from, foot);
  if (toAxes) {
    dashes(foot, {foot.x, 0, 0});
    dashes(foot, {0, foot.y, 0});
  }
  addRing(mesh, circle(foot, axes[2], footRadius * unit), dropRadius * unit, theme.mutedInk);
}

} // namespace

Mesh toolsMesh(const SceneContent &content, const Theme &theme, const View &view) {
  Mesh mesh;
  if (content.dropLine)
    addDropLine(mesh, *content.dropLine, content.stage.hasAxes(), theme, view);
  for (const Knob &knob : content.knobs)
    addKnob(mesh, knob, knobHue(knob, content.figure), theme, view);
  if (content.gizmo)
    addGizmo(mesh, *content.gizmo, theme, view);
  return mesh;
}

} // namespace halfspace
