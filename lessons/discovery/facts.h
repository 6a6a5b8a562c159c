// What can hold of objects in space.
#pragma once

#include "lessons/discovery/spatial_object.h"
#include "lessons/sentence.h"

#include <span>
#include <utility>

namespace halfspace {

/// Whether an object of a form can stand in one of the places of a fact.
using FormSet = unsigned;
[[nodiscard]] constexpr FormSet only(Form form) { return 1U << static_cast<unsigned>(form); }

using SpatialObjects = std::span<const SpatialObject>;

/// Something that can hold of two to four objects: equations between their coordinates. Where another fact
/// says more, as that a line lies in the plane to which it is parallel, this one does not hold.
struct Fact {
  std::vector<FormSet> places; ///< of the objects a, b, c, d
  /// Pairs of places that can be exchanged: the first object is selected before the second.
  std::vector<std::pair<std::size_t, std::size_t>> inOrder;
  bool (*holds)(SpatialObjects objects);
  /// With {a}, {b}, {c}, {d} for the names, and {ab}, {cd} for those of two points together.
  Sentence sentence;
};

/// All of them, in the order in which they are told.
[[nodiscard]] const std::vector<Fact> &facts();

} // namespace halfspace
