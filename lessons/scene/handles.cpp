#include "lessons/scene/handles.h"

namespace halfspace {
namespace {

/// One handle for each coordinate: a position is grabbed where it is, a direction at its tip.
void addCoordinateHandles(const Entry &entry, const Object &object, std::vector<Handle> &handles) {
  const auto &specs = coordinatesOf(object);
  for (std::size_t index = 0; index < specs.size(); ++index) {
    Handle handle;
    handle.id = specs[index].name.empty() ? entry.name : entry.name + "." + std::string(specs[index].name);
    handle.object = entry.name;
    handle.coordinate = index;
    if (specs[index].role == CoordinateRole::Direction)
      handle.base = coordinate(object, 0);
    handle.at = handle.base + coordinate(object, index);
    handles.push_back(std::move(handle));
  }
}

/// The knob that moves a plane along its normal; a zero normal points nowhere, so there is none.
void addOffsetHandle(const Entry &entry, const PlaneObject &plane, std::vector<Handle> &handles) {
  if (isZero(plane.normal))
    return;
  Handle handle;
  handle.id = entry.name + ".offset";
  handle.object = entry.name;
  handle.motion = Handle::Motion::AlongNormal;
  handle.at = plane.point;
  handle.axis = plane.normal;
  handles.push_back(std::move(handle));
}

/// The knob at the centroid. Its base makes the first corner the one that is snapped: thirds would be no
/// short numbers.
void addWholeHandle(const Entry &entry, const TriangleObject &triangle, std::vector<Handle> &handles) {
  Handle handle;
  handle.id = entry.name + ".whole";
  handle.object = entry.name;
  handle.motion = Handle::Motion::Whole;
  handle.at = (triangle.p0 + triangle.p1 + triangle.p2) / Rational(3);
  handle.base = handle.at - triangle.p0;
  handles.push_back(std::move(handle));
}

/// All positions of the object, moved by the same way.
Object shifted(Object object, const ExactVec3 &way) {
  const auto &specs = coordinatesOf(object);
  for (std::size_t index = 0; index < specs.size(); ++index)
    if (specs[index].role == CoordinateRole::Position)
      coordinate(object, index) += way;
  return object;
}

/// The part of a way that runs along the axis.
ExactVec3 alongAxis(const ExactVec3 &way, const ExactVec3 &axis) {
  const Rational square = dot(axis, axis);
  return square == 0 ? ExactVec3(0) : axis * Rational(dot(way, axis) / square);
}

} // namespace

std::vector<Handle> handlesOf(const Scene &scene) {
  std::vector<Handle> handles;
  for (const Entry &entry : scene.entries) {
    const auto *object = std::get_if<Object>(&entry.content);
    if (!object)
      continue;
    addCoordinateHandles(entry, *object, handles);
    if (const auto *plane = std::get_if<PlaneObject>(object))
      addOffsetHandle(entry, *plane, handles);
    if (const auto *triangle = std::get_if<TriangleObject>(object))
      addWholeHandle(entry, *triangle, handles);
  }
  return handles;
}

Object movedTo(const Object &object, const Handle &handle, const ExactVec3 &place) {
  switch (handle.motion) {
  case Handle::Motion::AlongNormal:
    return shifted(object, alongAxis(place - handle.at, handle.axis));
  case Handle::Motion::Whole:
    return shifted(object, place - handle.at);
  case Handle::Motion::Coordinate:
    break;
  }
  Object moved = object;
  if (handle.coordinate < coordinatesOf(moved).size())
    coordinate(moved, handle.coordinate) = place - handle.base;
  return moved;
}

} // namespace halfspace
