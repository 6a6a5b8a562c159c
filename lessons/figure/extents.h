// How far the marks are drawn that have no ends of their own.
#pragma once

#include "lessons/figure/figure.h"

#include <map>

namespace halfspace {

/// By the marks' ids: of a patch along both its sides; of a line or a ray the first alone counts.
using Extents = std::map<std::string, std::pair<Extent, Extent>>;

/// How far the patches, lines and rays of a figure are drawn.
[[nodiscard]] Extents extentsOf(const Figure &figure);

/// The figure with these of its marks drawn so far: patches whatever they cover, lines and rays unless what
/// lies on them would be beyond their ends.
[[nodiscard]] Figure heldAt(Figure figure, const Extents &extents);

/// On the way from one to the other, which has some of the same marks: at 0 as at first, at 1 as in the end.
/// Marks that only one of them has are left out.
[[nodiscard]] Extents between(const Extents &from, const Extents &to, double part);

} // namespace halfspace
