// Polygons.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A polygon by its corners, in their order around.
struct PolygonObject {
  static constexpr std::string_view kind = "polygon";
  static auto coordinatesOf(auto &self) { return std::tie(self.corners); }

  std::vector<ExactVec3> corners{};
  bool operator==(const PolygonObject &) const = default;
};

// It has as many coordinates as corners.
template <> Object::Object(const PolygonObject &polygon);
template <> std::optional<PolygonObject> objectAs<PolygonObject>(const Object &object);

/// The letters of the corners, with their values.
[[nodiscard]] std::vector<Term> cornerTermsOf(const Given<PolygonObject> &polygon);

} // namespace halfspace
