// Where the lines of paragraphs end.
#include "widgets/handout/break_paragraph.h"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

using Starts = std::vector<std::size_t>;

std::vector<BreakItem> wordsOf(const std::vector<double> &widths) {
  std::vector<BreakItem> items;
  for (const double width : widths)
    items.push_back({width, 1});
  return items;
}

/// Of the items [begin, end) with their spaces.
double widthOf(const std::vector<BreakItem> &items, std::size_t begin, std::size_t end, double spaces = 1) {
  double width = 0;
  for (std::size_t i = begin; i < end; ++i)
    width += items[i].width + (i > begin ? items[i].space * spaces : 0);
  return width;
}

TEST(LineStarts, OfNothing_AreNone) { EXPECT_EQ(lineStarts({}, 10, LineEnds::Ragged), Starts()); }

TEST(LineStarts, OfWhatFits_AreOne) {
  EXPECT_EQ(lineStarts(wordsOf({3, 3, 2}), 10, LineEnds::Ragged), Starts{0});
  EXPECT_EQ(lineStarts(wordsOf({3, 3, 2}), 10, LineEnds::Justified), Starts{0});
}

TEST(LineStarts, MakeLinesEven_WhereFillingThemOneByOneWouldNot) {
  // One by one: 5 4 | 3 | 9, with a line that is nearly empty.
  EXPECT_EQ(lineStarts(wordsOf({5, 4, 3, 9}), 11, LineEnds::Ragged), (Starts{0, 1, 3}));
}

TEST(LineStarts, AreWhereTheyMustBe) {
  std::vector<BreakItem> items = wordsOf({1, 1, 1, 1});
  items[2].mustBegin = true;
  EXPECT_EQ(lineStarts(items, 10, LineEnds::Justified), (Starts{0, 2}));
}

TEST(LineStarts, AreNeverWhereTheyMayNotBe_EvenIfTheLineIsTooWide) {
  std::vector<BreakItem> items = wordsOf({6, 6, 6});
  items[1].mayBegin = false;
  EXPECT_EQ(lineStarts(items, 10, LineEnds::Ragged), (Starts{0, 2}));
}

TEST(LineStarts, OfAnItemThatIsTooWide_PutItIntoALineOfItsOwn) {
  EXPECT_EQ(lineStarts(wordsOf({2, 30, 2}), 10, LineEnds::Ragged), (Starts{0, 1, 2}));
}

TEST(LineStarts, OfRandomParagraphs_KeepTheirWidth) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> widths(0.5, 9);
  for (int round = 0; round < 200; ++round) {
    std::vector<BreakItem> items;
    for (int i = 0; i < 60; ++i)
      items.push_back({widths(random), 1, i % 7 != 3});
    for (const LineEnds ends : {LineEnds::Ragged, LineEnds::Justified}) {
      const double spaces = ends == LineEnds::Justified ? 1 - mostShrinking : 1;
      Starts starts = lineStarts(items, 24, ends);
      ASSERT_EQ(starts.front(), 0U);
      starts.push_back(items.size());
      for (std::size_t line = 0; line + 1 < starts.size(); ++line) {
        EXPECT_LT(starts[line], starts[line + 1]);
        EXPECT_TRUE(items[starts[line]].mayBegin);
        EXPECT_LE(widthOf(items, starts[line], starts[line + 1], spaces), 24 + 1e-6);
      }
    }
  }
}

} // namespace
} // namespace halfspace
