// Spheres.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A sphere by its centre and its radius, which may be 0: then it is a single point.
struct SphereObject {
  static constexpr std::string_view kind = "sphere";
  static auto coordinatesOf(auto &self) { return std::tie(self.center, self.radius); }

  ExactVec3 center{};
  Rational radius{};
  bool operator==(const SphereObject &) const = default;
};

/// The sphere's letters, with their values. In the figure the radius is the sphere itself.
struct SphereTerms {
  Term c;
  Term R;
};

[[nodiscard]] SphereTerms termsOf(const Given<SphereObject> &sphere);

} // namespace halfspace
