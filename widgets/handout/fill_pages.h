// Pieces of text put into the columns of pages.
#pragma once

#include "widgets/handout/handout_look.h"
#include "widgets/handout/set_thing.h"

namespace halfspace {

/// A piece with its left top corner at a place on its page.
struct PlacedChunk {
  Chunk chunk;
  glm::dvec2 at{};
};

/// Each from top to bottom, one column after the other.
using FilledPage = std::vector<PlacedChunk>;

/// What belongs in front is as wide as the first page, and the columns begin below it. Pieces that keep with
/// the next are parted only where all of them together are higher than a column. What floats stands in its
/// place where it has room there, and else at the top of the next column.
[[nodiscard]] std::vector<FilledPage> fillPages(std::vector<Chunk> front, std::vector<Chunk> body,
                                                const HandoutLook &look);

} // namespace halfspace
