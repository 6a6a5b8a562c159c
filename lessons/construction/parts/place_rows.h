// The values that say where a point lies in a face.
#pragma once

#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

namespace halfspace {

template <class Out> using PlaceIn = FaceLocation (*)(const Out &);

/// The edge or the corner on which it lies, by the place of that.
template <class Out> [[nodiscard]] ValueRow<Out> featureRow(When<Out> hasPlace, PlaceIn<Out> place) {
  return {named::index("feature"),
          [hasPlace, place](const Out &at) { return hasPlace(at) && place(at).feature >= 0; },
          [place](const Out &at) { return Value(place(at).feature); }};
}

/// Whether it is inside, on an edge, at a corner or outside, and on which.
template <class Out> [[nodiscard]] ValueTable<Out> placeRows(When<Out> hasPlace, PlaceIn<Out> place) {
  return {{named::word("location", {"interior", "edge", "vertex", "outside"}), hasPlace,
           [place](const Out &at) { return ToldValue(words("place"), wordOf(place(at).part)); }},
          featureRow<Out>(hasPlace, place)};
}

} // namespace halfspace
