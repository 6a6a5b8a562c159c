// Slabs: the space between two parallel planes, with the planes. A box along the axes is what three of them
// have in common.
#pragma once

#include "geometry/intersect_ray_box.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/construction/parts/components.h"
#include "lessons/construction/working.h"
#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/ray.h"

#include <array>
#include <string>
#include <vector>

namespace halfspace {

/// A slab across an axis, as a ray's line meets it.
struct Slab {
  std::size_t axis;
  SlabCrossing<Rational> crossing;
  Term low, high;         ///< x₀ and x₀ + a: where the planes are
  Term start, step;       ///< Q_x and r_x, of the ray
  Term in, out;           ///< in_x and out_x: numbers of steps
  Term inPoint, outPoint; ///< A_x and B_x: the points there

  [[nodiscard]] std::string axisName() const { return axisNames.at(axis); }
  [[nodiscard]] bool isCrossed() const { return crossing.which == SlabCase::Crossed; }
  [[nodiscard]] bool isForwards() const; ///< the plane `low` comes first
  [[nodiscard]] bool isFlat() const;
  [[nodiscard]] bool hasStart() const;
  /// The planes in the order in which the ray's line goes through them.
  [[nodiscard]] const Term &near() const { return isForwards() ? low : high; }
  [[nodiscard]] const Term &far() const { return isForwards() ? high : low; }
  /// A plane in plain words: x = 2.
  [[nodiscard]] std::string nameOf(const Term &plane) const;
};

[[nodiscard]] std::array<Slab, 3> slabsOf(const Naming &naming, const Given<BoxObject> &box,
                                          const Given<RayObject> &ray, const RayBox<Rational> &meet);

/// Where the line goes into a slab that it crosses, and where it comes out.
[[nodiscard]] WorkingLine wayInLine(const Slab &slab);
[[nodiscard]] WorkingLine wayOutLine(const Slab &slab);
/// Whether the start is in the slab.
[[nodiscard]] WorkingLine startLine(const Slab &slab);

/// Both planes of a slab, a little larger than the box, as the mark `slab-x`; and the points where the line
/// goes in and comes out, as `in-x` and `out-x`.
void drawSlab(Figure &figure, const Naming &naming, const Slab &slab, const Given<BoxObject> &box,
              const Given<RayObject> &ray);

/// How the line stands to a slab.
[[nodiscard]] Word wordOf(SlabCase which);

} // namespace halfspace
