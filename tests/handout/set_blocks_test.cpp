// Blocks set in type, one below the other.
#include "tests/handout/handouts.h"
#include "widgets/handout/markdown_blocks.h"
#include "widgets/handout/set_blocks.h"

#include <algorithm>

namespace halfspace {
namespace {

/// What stands in elements of a role, by the pieces of the column.
std::vector<std::size_t> thingsInEachPiece(const std::string &words, const std::string &role) {
  const Macros macros;
  const HandoutBlocks blocks =
      handoutBlocks(withNames(*readMarkdown(words)),
                    {math::fonts(), macros, [](const std::string &) { return std::optional<Color>(); }});
  const HandoutLook look = handoutLook(HandoutPaper::A4, 1);
  ReadingOrder order;
  const std::size_t document = order.add("Document", {});
  const auto pieces = setBlocks(blocks, look.columnWidth(), look, handoutFonts(), order, document);
  std::vector<std::size_t> counts;
  for (const Chunk &piece : pieces)
    counts.push_back(static_cast<std::size_t>(
        std::count_if(piece.things.begin(), piece.things.end(), [&](const SetThing &thing) {
          return thing.element && order.elements()[*thing.element].role == role;
        })));
  return counts;
}

using Counts = std::vector<std::size_t>;

TEST(SetBlocks, MarksTheFirstLineOfEachItem) {
  EXPECT_EQ(thingsInEachPiece("- one\n\n  more\n- two\n", "Lbl"), (Counts{1, 0, 1}));
}

TEST(SetBlocks, MarksAnItemThatBeginsWithAFormula) {
  EXPECT_EQ(thingsInEachPiece("- $$x = 1$$\n\n  more\n- two\n", "Lbl"), (Counts{1, 0, 1}));
}

TEST(SetBlocks, MarksBothItems_WhereOneBeginsWithAnother) {
  EXPECT_EQ(thingsInEachPiece("- - one\n  - two\n", "Lbl"), (Counts{2, 1}));
}

} // namespace
} // namespace halfspace
