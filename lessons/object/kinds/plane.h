// Planes by a point and the normal.
#pragma once

#include "lessons/object/given.h"
#include "lessons/term/chain.h"

namespace halfspace {

/// n is not normalized, and may be zero: then there is no plane.
struct PlaneObject {
  static constexpr std::string_view kind = "plane";
  static auto coordinatesOf(auto &self) { return std::tie(self.point, self.normal); }

  ExactVec3 point{};
  ExactVec3 normal{};
  bool operator==(const PlaneObject &) const = default;
};

/// The plane's letters, with their values.
struct PlaneTerms {
  Term P0;
  Term n;
};

[[nodiscard]] PlaneTerms termsOf(const Given<PlaneObject> &plane);

/// ax + by + cz + d = 0, for the points of the plane.
[[nodiscard]] Chain equationOf(const PlaneTerms &plane);

} // namespace halfspace
