// Where the numbers of a working come from, back to the coordinates of the scene.
#pragma once

#include "lessons/construction/working.h"
#include "lessons/scene/scene.h"

#include <set>

namespace halfspace {

/// Whether it can be asked where a term comes from: a number that was calculated, or is a coordinate.
[[nodiscard]] bool isTraceable(const Term &term);

/// What a number was made of.
struct Provenance {
  std::set<std::string> lines;                 ///< the ids of the worked lines that say how
  std::set<std::string> marks;                 ///< the ids of the marks that were used
  std::vector<CoordinateSource> coordinates{}; ///< each once; a coordinate of three numbers is a whole one
  bool operator==(const Provenance &) const = default;
};

/// Follows a number of a line through what was calculated. A term that stands first in a line of the same
/// entry, as f(Q), n·n or u, is told by that line, and what the line says of it in symbols is followed in
/// turn. The point that another entry made is followed through the lines of that entry.
[[nodiscard]] Provenance provenanceOf(const Term &number, const std::string &lineId, const Working &working);

/// The scene's coordinate that is meant; nothing where it is not a free object's.
[[nodiscard]] std::optional<CoordinateId> coordinateOf(const Scene &scene, const CoordinateSource &source);

} // namespace halfspace
