// Worked lines set in type.
#pragma once

#include "widgets/formula/math_tree.h"
#include "widgets/working/shown_lines.h"
#include "widgets/working/working_layout.h"

#include <functional>

namespace halfspace {

/// The lines with the pictures of what they show. Those that look as they did `before` are taken from there.
/// `roomOfGap`: of the field in place of what is left out of the line with this id.
[[nodiscard]] std::vector<TypesetLine>
typesetLines(const Typesetter &typesetter, const ShownLines &shown,
             const std::function<math::Room(const std::string &lineId)> &roomOfGap,
             const std::vector<TypesetLine> &before);

} // namespace halfspace
