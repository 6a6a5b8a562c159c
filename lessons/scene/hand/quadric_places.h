// Where a hand can come to rest on a curve: its places of fractions.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/object/quadric.h"

namespace halfspace {

/// The multiples of a step, counted from a place.
struct SnapGrid {
  ExactVec3 base;
  Rational step;

  [[nodiscard]] Rational nearest(const ExactVec3 &place, int axis) const {
    return base[axis] + roundToMultiple(Rational(place[axis] - base[axis]), step);
  }
};

/// The places of a flat where a coordinate has this value; nothing where it has none.
[[nodiscard]] std::optional<Flat> withCoordinate(const Flat &flat, int axis, const Rational &value);

/// Of what a surface and a flat, a line or a plane, have in common the place that is about the nearest to one
/// of the flat; rounded, as it has roots. Nothing where they do not meet near there, and for other flats.
[[nodiscard]] std::optional<Place> nearestOn(const Quadric &surface, const Flat &flat, const ExactVec3 &to);

/// Places of fractions that a surface and a flat, a line or a plane, have in common: those with a coordinate
/// on the grid around `near`, and others around it whose denominators grow with how fine they lie.
///
/// Such a curve has no place of fractions, or ever so many (a circle of radius √3 around the origin has
/// none). From one, each line with a rational slope leads to exactly one other. The first is looked for on
/// the lines of the grid and on finer ones; a curve that has none there is taken to have none.
[[nodiscard]] std::vector<ExactVec3> exactPlacesOn(const Quadric &surface, const Flat &flat,
                                                   const ExactVec3 &near, const SnapGrid &grid);

} // namespace halfspace
