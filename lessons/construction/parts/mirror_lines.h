// What constructions of a mirror write of the direction in which it sends a ray.
#pragma once

#include "lessons/construction/naming.h"
#include "lessons/construction/working.h"

#include <string>

namespace halfspace {

/// r, the normal n ≠ 0 of the mirror, and what becomes of r there.
struct MirroredDirection {
  Term r;
  Term n;
  Term turned;
};

/// r′ = r − 2((r·n)/(n·n)) n. The naming's letters say what {r} and {n} are called.
[[nodiscard]] WorkingLine mirroredLine(const MirroredDirection &at, const Naming &naming,
                                       std::string sentence);
/// r·r and r′·r′, which are the same.
[[nodiscard]] WorkingLine sameLengthLine(const MirroredDirection &at);

} // namespace halfspace
