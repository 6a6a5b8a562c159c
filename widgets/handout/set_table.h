// Tables set in rows.
#pragma once

#include "widgets/handout/handout_block.h"
#include "widgets/handout/set_paragraph.h"

namespace halfspace {

/// The rows of a table, at most as wide as the plan says; `plan.element` is what it stands in. A row is not
/// broken, and the first one, where it names the columns, keeps with the next.
[[nodiscard]] std::vector<Chunk> setTable(const TableBlock &table, const ParagraphPlan &plan,
                                          const HandoutFonts &fonts, ReadingOrder &order);

} // namespace halfspace
