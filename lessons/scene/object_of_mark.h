// What somebody means who points at a mark of a picture.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// The id of the object that a mark is of: `E` for `E` and for `E.n`; `distance.F` for what
/// a construction makes, its name for its other marks. Empty for a mark of no entry.
[[nodiscard]] std::string objectOfMark(const Evaluation &evaluation, std::string_view mark);

} // namespace halfspace
