// Screens that are divided into pixels.
#pragma once

#include "lessons/object/given.h"

namespace halfspace {

/// A screen by a corner and its edges from there, divided into w × h pixels: whole numbers from 1 to
/// `mostPixels`. Its kind settles them so, and no scene takes others: what looks at screens relies on it.
struct ScreenObject {
  static constexpr std::string_view kind = "screen";
  static constexpr int mostPixels = 64;
  static auto coordinatesOf(auto &self) { return std::tie(self.corner, self.u, self.v, self.w, self.h); }

  ExactVec3 corner{};
  ExactVec3 u{};
  ExactVec3 v{};
  Rational w = 1; ///< pixels along u
  Rational h = 1; ///< pixels along v
  bool operator==(const ScreenObject &) const = default;

  /// After so many pixels along u and along v.
  [[nodiscard]] ExactVec3 at(const Rational &across, const Rational &down) const {
    return corner + u * Rational(across / w) + v * Rational(down / h);
  }
};

/// The screen's letters, with their values. The numbers of pixels are no marks of their own in the picture.
struct ScreenTerms {
  Term P0;
  Term u;
  Term v;
  Term w;
  Term h;
};

[[nodiscard]] ScreenTerms termsOf(const Given<ScreenObject> &screen);

} // namespace halfspace
