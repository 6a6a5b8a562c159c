// Numbers, to be changed within bounds in steps.
#pragma once

#include "lessons/object/object.h"

namespace halfspace {

/// A number between two bounds; a step of 0 is none.
struct NumberObject {
  static constexpr std::string_view kind = "number";
  static auto coordinatesOf(auto &self) { return std::tie(self.value, self.from, self.to, self.step); }

  Rational value{};
  Rational from{};
  Rational to{};
  Rational step{};
  bool operator==(const NumberObject &) const = default;
};

} // namespace halfspace
