#include "widgets/picture/hand/flat_drag.h"

#include "lessons/scene/hand/snapping.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace halfspace {
namespace {

/// Where a place of space is seen.
std::optional<glm::dvec2> pixelOf(const Place &place, const FlatFrame &frame, const View &view) {
  const auto pixel = view.camera.project(onPage(place, frame), view.size);
  return pixel ? std::optional(glm::dvec2(*pixel)) : std::nullopt;
}

/// Where a handle may go without leaving the page; nothing where it cannot, or only to where it is.
std::optional<Flat> freedomOnPage(const Handle &handle, const FlatFrame &frame) {
  const bool isFree = handle.motion == Handle::Motion::Coordinate;
  if (!isFree && (handle.motion != Handle::Motion::OnHost || (!handle.hasAxis() && isZero(handle.normal))))
    return {}; // a knob, which stands in the scene alone; or it moves on a sphere, or not at all
  Flat freedom;
  if (handle.hasAxis())
    freedom = Flat::line(handle.at, handle.axis);
  else if (!isZero(handle.normal))
    freedom = Flat::plane(handle.at, handle.normal);
  const auto onPage = Flat::intersection(freedom, Flat::plane(handle.at, frame.normal));
  return onPage && onPage->dimension() > 0 ? onPage : std::nullopt;
}

} // namespace

const Handle *handleOnPage(glm::dvec2 pixel, const std::vector<Handle> &handles, const std::string &upwards,
                           const FlatFrame &frame, const View &view, double margin) {
  const Handle *nearest = nullptr;
  double least = margin;
  for (const Handle &handle : handles) {
    const auto at = pixelOf(toDouble(handle.at), frame, view);
    // Of two in one place the later one, as in the scene.
    if (!at || handle.id == upwards || glm::distance(*at, pixel) > least || !freedomOnPage(handle, frame))
      continue;
    nearest = &handle;
    least = glm::distance(*at, pixel);
  }
  return nearest;
}

FlatDrag::FlatDrag(PlacedScene scene, Handle handle, FlatFrame frame, glm::dvec2 pressed,
                   std::vector<SnapTarget> asked)
    : m_scene(std::move(scene)), m_handle(std::move(handle)), m_frame(std::move(frame)), m_pressed(pressed),
      m_targets(std::move(asked)) {
  for (SnapTarget &target : snapTargets(m_scene, m_handle))
    m_targets.push_back(std::move(target));
}

std::optional<DragMove> FlatDrag::moveTo(glm::dvec2 pixel, const Rational &step, const View &view) const {
  const Object *object = findObject(m_scene.scene, m_handle.object);
  const auto freedom = freedomOnPage(m_handle, m_frame);
  if (!object || !freedom)
    return {};
  const auto pageAt = [&](glm::dvec2 at) { return view.camera.sightThrough(at, view.size).origin; };
  const Place way = pageAt(pixel) - pageAt(m_pressed);
  const Place raw = toDouble(m_handle.at) + m_frame.right * way.y + m_frame.up * way.z;
  const auto pixelsApart = [&](const Place &a, const Place &b) {
    const auto first = pixelOf(a, m_frame, view);
    const auto second = pixelOf(b, m_frame, view);
    return first && second ? glm::distance(*first, *second) : std::numeric_limits<double>::infinity();
  };
  const SnappedPlace snapped = snap({m_scene, m_handle, m_targets, glm::clamp(raw, -dragBox, dragBox),
                                     *freedom, step, pixelsApart, catchDistance * view.pixelRatio});
  return DragMove{movedTo(*object, m_handle, snapped.at), snapped.caughtBy};
}

} // namespace halfspace
