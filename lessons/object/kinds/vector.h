// Vectors, drawn from a point.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A vector and the point that it is drawn from. People call it by the object's name: v.
struct VectorObject {
  static constexpr std::string_view kind = "vector";
  static auto coordinatesOf(auto &self) { return std::tie(self.start, self.vector); }

  ExactVec3 start{};
  ExactVec3 vector{};
  bool operator==(const VectorObject &) const = default;
};

/// A vector goes by its own name.
[[nodiscard]] Term termOf(const Given<VectorObject> &vector);

} // namespace halfspace
