// The edges of a solid, each of which two faces share: they run along it in opposite directions.
#pragma once

#include "geometry/location.h"
#include "lessons/construction/parts/plucker_edges.h"
#include "lessons/object/solid.h"

namespace halfspace {

struct SolidEdge : EdgeTerms {
  std::uint32_t from, to;
  std::uint32_t face;     ///< that runs along it in its direction
  std::uint32_t opposite; ///< that runs along it in the other direction

  [[nodiscard]] bool isOf(std::size_t some) const { return face == some || opposite == some; }
};

/// All edges with their letters, and their products with a line.
[[nodiscard]] std::vector<SolidEdge> edgesOf(const Naming &naming, const Given<SolidObject> &solid,
                                             const Line<Rational> &line);

/// An edge as a face runs along it: with a minus where that is against its direction.
struct FaceSide {
  Term e, p;
};

/// The sides of a face in their order around it.
[[nodiscard]] std::vector<FaceSide> sidesOf(const SolidMesh<Rational> &mesh, std::size_t face,
                                            const std::vector<SolidEdge> &edges);

/// How many edges the faces have one by one.
[[nodiscard]] int sideCount(const SolidMesh<Rational> &mesh);

/// The part of a face that the line crosses of a convex solid.
[[nodiscard]] FacePart partOf(std::size_t face, const std::vector<SolidEdge> &edges);

} // namespace halfspace
