// The blocks of a handout set in type, for a column.
#pragma once

#include "widgets/handout/handout_block.h"
#include "widgets/handout/handout_look.h"
#include "widgets/handout/set_paragraph.h"

namespace halfspace {

/// Pieces of a column of a width, from top to bottom. `document` is the element that they stand in.
[[nodiscard]] std::vector<Chunk> setBlocks(const HandoutBlocks &blocks, double width, const HandoutLook &look,
                                           const HandoutFonts &fonts, ReadingOrder &order,
                                           std::size_t document);

} // namespace halfspace
