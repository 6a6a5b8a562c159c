// Triangles.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A triangle by its corners.
struct TriangleObject {
  static constexpr std::string_view kind = "triangle";
  static auto coordinatesOf(auto &self) { return std::tie(self.p0, self.p1, self.p2); }

  ExactVec3 p0{};
  ExactVec3 p1{};
  ExactVec3 p2{};
  bool operator==(const TriangleObject &) const = default;
};

/// The triangle's letters, with their values.
struct TriangleTerms {
  Term P0;
  Term P1;
  Term P2;
};

[[nodiscard]] TriangleTerms termsOf(const Given<TriangleObject> &triangle);

} // namespace halfspace
