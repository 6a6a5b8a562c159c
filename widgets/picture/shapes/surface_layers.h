// How many surfaces lie one behind another, and which are drawn where these are very many.
#pragma once

#include "geometry/triangle_mesh.h"
#include "lessons/figure/figure.h"

#include <optional>
#include <set>
#include <string>

namespace halfspace {

/// Through 20 of the palest faces that are usual, of an opacity of 0.24, comes 1 in 240 of the light: nobody
/// sees how many lie behind, and so many are left where every other one goes. Without a graphics card each
/// that fills a usual window takes some 35 ms a frame with its shadow: all of them stay below two seconds.
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

/// One triangle in so many is drawn of a mesh with so many layers, which leaves at most `mostMeshLayers`: all
/// (1), or a power of two.
[[nodiscard]] std::size_t strideFor(std::size_t meshLayers);

/// The figure with at most `mostFaceLayers` faces one behind another, and all that stand out; nothing where
/// no more lie there. Of those that lie one behind another every other one goes, once or more often, so that
/// a hand that moves something seldom changes which; whatever else there is stays. The edges of a face go
/// with it: very many of them one behind another cost as much.
[[nodiscard]] std::optional<Figure> thinned(const Figure &figure, const std::set<std::string> &highlighted);

/// What is told of a picture that leaves some out (`ShapeList::leavesOutSurfaces`).
[[nodiscard]] std::string overfullWords();

} // namespace halfspace
