// Free points.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A place in space.
struct PointObject {
  static constexpr std::string_view kind = "point";
  static auto coordinatesOf(auto &self) { return std::tie(self.at); }

  ExactVec3 at{};
  bool operator==(const PointObject &) const = default;
};

/// A point goes by its own name.
[[nodiscard]] Term termOf(const Given<PointObject> &point);

} // namespace halfspace
