// Rays.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A ray by its start and its direction, which keeps its length.
struct RayObject {
  static constexpr std::string_view kind = "ray";
  static auto coordinatesOf(auto &self) { return std::tie(self.origin, self.direction); }

  ExactVec3 origin{};
  ExactVec3 direction{};
  bool operator==(const RayObject &) const = default;
};

/// The ray's letters, with their values.
struct RayTerms {
  Term Q;
  Term r;
};

[[nodiscard]] RayTerms termsOf(const Given<RayObject> &ray);

} // namespace halfspace
