// Lines.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A line by a point of it and a direction.
struct LineObject {
  static constexpr std::string_view kind = "line";
  static auto coordinatesOf(auto &self) { return std::tie(self.point, self.direction); }

  ExactVec3 point{};
  ExactVec3 direction{};
  bool operator==(const LineObject &) const = default;
};

/// The line's letters, with their values.
struct LineTerms {
  Term A;
  Term v;
};

[[nodiscard]] LineTerms termsOf(const Given<LineObject> &line);

} // namespace halfspace
