// Boxes along the axes.
#pragma once

#include "lessons/object/given.h"

#include <array>

namespace halfspace {

/// A box along the axes by its lowest corner and three lengths, which may be 0.
struct BoxObject {
  static constexpr std::string_view kind = "box";
  static auto coordinatesOf(auto &self) { return std::tie(self.lowest, self.a, self.b, self.c); }

  ExactVec3 lowest{};
  Rational a{};
  Rational b{};
  Rational c{};
  bool operator==(const BoxObject &) const = default;

  [[nodiscard]] ExactVec3 highest() const { return lowest + ExactVec3(a, b, c); }
};

/// The box's letters, with their values. The lengths are no marks of their own in the picture.
struct BoxTerms {
  Term P0;
  std::array<Term, 3> lengths;
};

[[nodiscard]] BoxTerms termsOf(const Given<BoxObject> &box);

} // namespace halfspace
