// Tetrahedra.
#pragma once

#include "lessons/object/given.h"

#include <array>

namespace halfspace {

/// A tetrahedron by its corners.
struct TetrahedronObject {
  static constexpr std::string_view kind = "tetrahedron";
  static auto coordinatesOf(auto &self) { return std::tie(self.p0, self.p1, self.p2, self.p3); }

  ExactVec3 p0{};
  ExactVec3 p1{};
  ExactVec3 p2{};
  ExactVec3 p3{};
  bool operator==(const TetrahedronObject &) const = default;
};

/// The letters of the corners, with their values.
[[nodiscard]] std::array<Term, 4> cornerTermsOf(const Given<TetrahedronObject> &tetrahedron);

} // namespace halfspace
