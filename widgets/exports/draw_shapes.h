// From a picture's shapes to a drawing.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/paper_look.h"
#include "widgets/picture/shapes/shape_list.h"

namespace halfspace {

/// The drawing of a list that was composed: all of it but the tools of the hand. What is before what is found
/// by depth. Title and description are for the caller to say.
[[nodiscard]] Drawing drawingOf(const ShapeList &list, const PaperLook &look);

} // namespace halfspace
