#include "lessons/object/corners.h"

#include "lessons/object/kind.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Where a corner stands among the corners; their number for what is none.
std::size_t orderOf(const Object &object, std::size_t corner) {
  const auto corners = cornersOf(object);
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
}

} // namespace

std::vector<std::size_t> cornersOf(const Object &object) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < object.size(); ++i)
    if (object.kind().leavableVertices > 0 && coordinatesOf(object)[i].role == CoordinateRole::Position)
      corners.push_back(i);
  return corners;
}

bool canAddCornerAfter(const Object &object, std::size_t corner) {
  return object.size() < object.kind().coordinates.size() &&
         orderOf(object, corner) < cornersOf(object).size();
}

bool canRemoveCorner(const Object &object, std::size_t corner) {
  return object.size() > object.kind().fewestCoordinates() &&
         orderOf(object, corner) < cornersOf(object).size();
}

Object withCornerAfter(Object object, std::size_t corner) {
  const auto before = cornersOf(object);
  const std::size_t order = orderOf(object, corner);
  const ExactVec3 middle = (object[corner] + object[before[(order + 1) % before.size()]]) / Rational(2);
  object.addVertex();
  const auto corners = cornersOf(object);
  for (std::size_t i = corners.size() - 1; i > order + 1; --i)
    object[corners[i]] = object[corners[i - 1]];
  object[corners[order + 1]] = middle;
  return object;
}

Object withoutCorner(Object object, std::size_t corner) {
  const auto corners = cornersOf(object);
  for (std::size_t i = orderOf(object, corner); i + 1 < corners.size(); ++i)
    object[corners[i]] = object[corners[i + 1]];
  object.removeLastVertex();
  return object;
}

} // namespace halfspace
