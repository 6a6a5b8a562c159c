#include "lessons/object/handle.h"

#include "lessons/object/kind.h"

namespace halfspace {
namespace {

/// All positions of the object, moved by the same way.
Object shifted(Object object, const ExactVec3 &way) {
  const auto specs = coordinatesOf(object);
  for (std::size_t index = 0; index < specs.size(); ++index)
    if (specs[index].role == CoordinateRole::Position)
      coordinate(object, index) += way;
  return object;
}

/// The part of a way that runs along the axis, in lengths of the axis.
Rational along(const ExactVec3 &way, const ExactVec3 &axis) {
  const Rational square = dot(axis, axis);
  return square == 0 ? Rational(0) : dot(way, axis) / square;
}

} // namespace

Object movedTo(const Object &object, const Handle &handle, const ExactVec3 &place) {
  Object moved = object;
  switch (handle.motion) {
  case Handle::Motion::AlongNormal:
    return shifted(object, handle.axis * along(place - handle.at, handle.axis));
  case Handle::Motion::Whole:
    return shifted(object, place - handle.at);
  case Handle::Motion::Length: // a length is not negative
    coordinate(moved, handle.coordinate).x = abs(along(place - handle.base, handle.axis));
    break;
  case Handle::Motion::Coordinate:
    coordinate(moved, handle.coordinate) = place - handle.base;
    break;
  case Handle::Motion::OnHost:
    moved = object.kind().binding->nearest(object, *handle.host, place);
    object.kind().settle(moved);
    break;
  }
  return moved;
}

std::optional<ExactVec3> placeOn(const Object &bound, const Object &host) {
  return bound.kind().binding->placeOf(bound, host);
}

Object movedToGrid(const Object &bound, const Handle &handle, const ExactVec3 &place, const Rational &step) {
  const Kind &kind = bound.kind();
  Object moved = kind.binding->onGrid(movedTo(bound, handle, place), *handle.host, step);
  kind.settle(moved);
  return moved;
}

} // namespace halfspace
