#include "widgets/picture/hand/handle_drag.h"

#include "lessons/scene/hand/snapping.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// The offset knob stands so far from the plane's point, in scene units: beside the point's own handle, not
/// on it.
constexpr double offsetKnobDistance = 4.5;

/// A horizontal unit direction in the plane with this normal.
Place horizontalIn(Place normal) {
  const Place across = glm::cross(normal, Place(0, 0, 1));
  const double length = glm::length(across);
  return length == 0 ? Place(1, 0, 0) : across / length;
}

Place unitAxis(DragMode mode) {
  switch (mode) {
  case DragMode::AxisX:
  case DragMode::PlaneYZ:
    return {1, 0, 0};
  case DragMode::AxisY:
  case DragMode::PlaneZX:
    return {0, 1, 0};
  default:
    return {0, 0, 1};
  }
}

bool isPlanar(DragMode mode) {
  return mode == DragMode::Horizontal || mode == DragMode::PlaneYZ || mode == DragMode::PlaneZX;
}

/// How a handle moves that says so by itself.
std::optional<DragMode> ownMode(const Handle &handle) {
  if (handle.hasAxis())
    return DragMode::OwnAxis;
  if (!isZero(handle.normal))
    return DragMode::OwnPlane;
  return handle.center ? std::optional(DragMode::OwnSphere) : std::nullopt;
}

DragConstraint constraintOf(DragMode mode, const Handle &handle) {
  if (mode == DragMode::OwnAxis)
    return alongLine(toDouble(handle.axis));
  if (mode == DragMode::OwnPlane)
    return inPlane(toDouble(handle.normal));
  if (mode == DragMode::OwnSphere)
    return onSphere(toDouble(handle.center.value()));
  return isPlanar(mode) ? inPlane(unitAxis(mode)) : alongLine(unitAxis(mode));
}

/// The same, exactly, through where the handle was when the mode began; of a sphere, which is no flat, all of
/// space.
Flat freedomOf(DragMode mode, const Handle &handle) {
  if (mode == DragMode::OwnAxis)
    return Flat::line(handle.at, handle.axis);
  if (mode == DragMode::OwnPlane)
    return Flat::plane(handle.at, handle.normal);
  if (mode == DragMode::OwnSphere)
    return {};
  const Place axis = unitAxis(mode);
  const ExactVec3 exact{static_cast<int>(axis.x), static_cast<int>(axis.y), static_cast<int>(axis.z)};
  return isPlanar(mode) ? Flat::plane(handle.at, exact) : Flat::line(handle.at, exact);
}

Place inBox(Place place, const ExactVec3 &start) {
  const Place limit = glm::max(Place(dragBox), glm::abs(toDouble(start)));
  return glm::clamp(place, -limit, limit);
}

} // namespace

bool isOwn(DragMode mode) {
  return mode == DragMode::OwnAxis || mode == DragMode::OwnPlane || mode == DragMode::OwnSphere;
}

bool movesFreely(const Handle &handle) { return !ownMode(handle) && handle.motion != Handle::Motion::OnHost; }

std::optional<DragMode> grabMode(const Handle &handle, bool vertical, const Camera &camera) {
  const Place at = shownPlace(handle);
  const auto grabbable = [&](DragMode mode) { return isGrabbable(constraintOf(mode, handle), camera, at); };
  if (const auto own = ownMode(handle))
    return grabbable(*own) ? own : std::nullopt;
  if (handle.motion == Handle::Motion::OnHost)
    return {}; // what it lies on is a single place
  const DragMode wished = vertical ? DragMode::Vertical : DragMode::Horizontal;
  const DragMode other = vertical ? DragMode::Horizontal : DragMode::Vertical;
  return grabbable(wished) ? wished : other;
}

DragMode modeOf(Gizmo::Part part) {
  switch (part) {
  case Gizmo::Part::AxisX:
    return DragMode::AxisX;
  case Gizmo::Part::AxisY:
    return DragMode::AxisY;
  case Gizmo::Part::AxisZ:
    return DragMode::AxisZ;
  case Gizmo::Part::PlaneXY:
    return DragMode::Horizontal;
  case Gizmo::Part::PlaneYZ:
    return DragMode::PlaneYZ;
  case Gizmo::Part::PlaneZX:
    break;
  }
  return DragMode::PlaneZX;
}

Place shownPlace(const Handle &handle) {
  const Place at = toDouble(handle.at);
  if (handle.motion != Handle::Motion::AlongNormal)
    return at;
  return at + horizontalIn(toDouble(handle.axis)) * offsetKnobDistance;
}

std::optional<Knob> knobOf(const Handle &handle, bool hot) {
  switch (handle.motion) {
  case Handle::Motion::Coordinate:
  case Handle::Motion::OnHost:
    return {};
  case Handle::Motion::AlongNormal:
    return Knob{handle.id, shownPlace(handle), toDouble(handle.axis), Subject::Plane, hot};
  case Handle::Motion::Length:
    return Knob{handle.id, shownPlace(handle), toDouble(handle.axis), Subject::Triangle, hot};
  case Handle::Motion::Whole:
    break;
  }
  return Knob{handle.id, shownPlace(handle), std::nullopt, Subject::Triangle, hot};
}

HandleDrag::HandleDrag(PlacedScene scene, Handle handle, DragMode mode, glm::dvec2 pressed,
                       std::vector<SnapTarget> asked)
    : m_scene(std::move(scene)), m_handle(std::move(handle)), m_targets(std::move(asked)), m_mode(mode),
      m_anchor(m_handle), m_pressed(pressed), m_at(m_handle.at), m_pixel(pressed) {
  for (SnapTarget &target : snapTargets(m_scene, m_handle))
    m_targets.push_back(std::move(target));
}

void HandleDrag::setMode(DragMode mode) {
  m_mode = mode;
  m_anchor.at = m_at;
  m_pressed = m_pixel;
}

std::optional<DragMove> HandleDrag::moveTo(glm::dvec2 pixel, const Rational &step, const View &screen) {
  m_pixel = pixel;
  const Place start = shownPlace(m_anchor);
  const Place beside = start - toDouble(m_anchor.at);
  const auto place =
      dragged(constraintOf(m_mode, m_anchor), screen.camera, screen.size, start, m_pressed, pixel);
  const Object *object = findObject(m_scene.scene, m_handle.object);
  if (!place || !object)
    return {};
  const auto pixelsApart = [&](const Place &a, const Place &b) {
    const auto onScreenA = screen.camera.project(a, screen.size);
    const auto onScreenB = screen.camera.project(b, screen.size);
    if (!onScreenA || !onScreenB)
      return std::numeric_limits<double>::infinity();
    return glm::length(glm::dvec2(*onScreenA) - glm::dvec2(*onScreenB));
  };
  const SnappedPlace snapped =
      snap({m_scene, m_anchor, m_targets, inBox(*place - beside, m_handle.at), freedomOf(m_mode, m_anchor),
            step, pixelsApart, catchDistance * screen.pixelRatio});
  m_at = snapped.at;
  return DragMove{movedTo(*object, m_handle, m_at), snapped.caughtBy};
}

} // namespace halfspace
