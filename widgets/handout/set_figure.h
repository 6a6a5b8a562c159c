// Figures with their captions.
#pragma once

#include "widgets/handout/handout_block.h"
#include "widgets/handout/set_paragraph.h"

namespace halfspace {

/// A figure as one piece that floats, in the middle of the plan's width. `plan` is for the caption, but for
/// its element; `plan.element` is what both stand in.
[[nodiscard]] Chunk setFigure(const FigureBlock &figure, const ParagraphPlan &plan, const HandoutFonts &fonts,
                              ReadingOrder &order);

} // namespace halfspace
