// How many surfaces lie one behind another, and which are drawn where these are very many.
#pragma once

#include "geometry/triangle_mesh.h"
#include "lessons/figure/figure.h"

#include <set>
#include <string>

namespace halfspace {

/// Through 20 of the palest faces that are usual, of an opacity of 0.24, comes 1 in 240 of the light: nobody
/// sees how many lie behind. As one face in 2, 4, 8 … is drawn, so many are left. Without a graphics card
/// each that fills a usual window takes some 35 ms a frame with its shadow: all of them stay below two
/// seconds.
inline constexpr std::size_t mostFaceLayers = 40;

/// A triangle of a mesh costs half of that, but each that is missing is a hole: only meshes that are no
/// surface of anything have more.
inline constexpr std::size_t mostMeshLayers = 80;

/// How many of a figure's translucent faces lie one behind another, looked at from where there are most: a
/// measure for how often a picture fills its pixels at worst, the same from every side. Each of some lines
/// through their middles is asked how many it crosses. Where there are few, all are taken to.
[[nodiscard]] std::size_t faceLayersOf(const Figure &figure);

/// Likewise of a mesh's triangles.
[[nodiscard]] std::size_t meshLayersOf(const TriangleMesh &mesh);

/// One surface in so many is drawn to leave at most `most` layers: all (1), or a power of two, so that a hand
/// that moves something seldom changes it.
[[nodiscard]] std::size_t strideFor(std::size_t layers, std::size_t most);

/// The figure with one of its faces in `stride`, and all that stand out; whatever else it has stays. The
/// edges of a face go with it: very many of them one behind another cost as much.
[[nodiscard]] Figure thinned(Figure figure, std::size_t stride, const std::set<std::string> &highlighted);

/// Whether a picture of this figure leaves out surfaces; it then says `thinningWords`.
[[nodiscard]] bool isThinned(const Figure &figure);
[[nodiscard]] std::string thinningWords();

} // namespace halfspace
