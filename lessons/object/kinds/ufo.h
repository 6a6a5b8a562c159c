// Flying saucers, as in the demonstration of note PG 7.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// Something that flies evenly and fires: where it is at frame 0, how far it flies in a hundred frames, where
/// its barrel points, by an arrow of whatever length, and how long the barrel is.
struct UfoObject {
  static constexpr std::string_view kind = "ufo";
  static auto coordinatesOf(auto &self) {
    return std::tie(self.start, self.velocity, self.barrel, self.barrelLength);
  }

  ExactVec3 start{};
  ExactVec3 velocity{};
  ExactVec3 barrel{};
  Rational barrelLength{}; ///< note PG 7 has 20
  bool operator==(const UfoObject &) const = default;
};

/// Its letters, with their values.
struct UfoTerms {
  Term S;
  Term c;
  Term g;
  Term l;
};

[[nodiscard]] UfoTerms termsOf(const Given<UfoObject> &ufo);

} // namespace halfspace
