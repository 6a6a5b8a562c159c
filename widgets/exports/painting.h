// In which order the parts of a figure in space are painted.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/veil.h"

namespace halfspace {

/// What a veil is painted with.
struct VeilLook {
  std::string mark;
  Fill fill;
  bool operator==(const VeilLook &) const = default;
};

/// Something thin, round or pointed among the veils.
struct PaintedThing {
  /// What lies over what where two come equally near: as if each had all before it inside. Of one rank the
  /// thicker lies over the other.
  enum class Rank { Line, Head, Ball };

  std::vector<PathPart> parts;
  Rank rank = Rank::Line;
  std::vector<Spot> spine; ///< it reaches around the path through these; a single one: around that
  double reach = 0;
  AmongVeils veils{};
};

/// Veils are compared one with another where there are no more than so many; more keep the order in which
/// they came.
inline constexpr std::size_t mostComparedVeils = 1500;
/// Pairs of straight pieces that are looked at for which lies over which, in some tenths of a second; beyond
/// that things keep the order in which they came.
inline constexpr std::size_t mostComparedPieces = 5'000'000;

/// Veils and things, from those farthest behind to those in front. `looks` are those of the veils, which come
/// in an order in which they can be painted. Neighbouring pieces of one face become one path, which has no
/// seams.
[[nodiscard]] std::vector<PathPart> inPaintingOrder(const Veils &veils, const std::vector<VeilLook> &looks,
                                                    std::vector<PaintedThing> things);

} // namespace halfspace
