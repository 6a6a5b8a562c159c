// What says where a point lies in a face: values, and whole sentences.
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

/// A sentence for each part of a face. What names the edge or the corner stands in places that it has alone.
struct PlaceSentences {
  Sentence inside;
  Sentence onEdge;
  Sentence atCorner;
  Sentence outside{""}; ///< none where it is not said of points outside
};
[[nodiscard]] inline const char *sentenceFor(FacePart part, const PlaceSentences &sentences) {
  switch (part) {
  case FacePart::Interior:
    return sentences.inside.english;
  case FacePart::Edge:
    return sentences.onEdge.english;
  case FacePart::Vertex:
    return sentences.atCorner.english;
  case FacePart::Outside:
    break;
  }
  return sentences.outside.english;
}

} // namespace halfspace
