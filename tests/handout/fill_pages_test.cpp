// Pieces of text in the columns of pages.
#include "widgets/handout/fill_pages.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// Columns that are 100 high.
HandoutLook lookOf(int columns) {
  HandoutLook look;
  look.page = {200, 140};
  look.side = 10;
  look.top = look.bottom = 20;
  look.columns = columns;
  look.gutter = 20;
  look.typeSize = 10;
  return look;
}

Chunk chunkOf(double height, bool keepsWithNext = false, double gap = 0) {
  Chunk chunk;
  chunk.height = height;
  chunk.keepsWithNext = keepsWithNext;
  chunk.gapAbove = gap;
  return chunk;
}

Chunk floating(double height) {
  Chunk chunk = chunkOf(height);
  chunk.floats = true;
  return chunk;
}

/// Heights of what stands on a page.
std::vector<double> heightsOn(const FilledPage &page) {
  std::vector<double> heights;
  for (const PlacedChunk &placed : page)
    heights.push_back(placed.chunk.height);
  return heights;
}

using Heights = std::vector<double>;

TEST(FillPages, PutsPiecesBelowEachOther_AndGapsAwayAtTheTop) {
  const auto pages = fillPages({}, {chunkOf(30, false, 5), chunkOf(40, false, 5)}, lookOf(1));
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_EQ(pages[0][0].at, glm::dvec2(10, 20));
  EXPECT_EQ(pages[0][1].at, glm::dvec2(10, 55));
}

TEST(FillPages, GoesOnInTheNextColumn_AndThenOnTheNextPage) {
  const auto pages = fillPages({}, {chunkOf(60), chunkOf(61), chunkOf(62)}, lookOf(2));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(heightsOn(pages[0]), (Heights{60, 61}));
  EXPECT_EQ(pages[0][1].at, glm::dvec2(110, 20));
  EXPECT_EQ(pages[1][0].at, glm::dvec2(10, 20));
}

TEST(FillPages, KeepsAHeadingWithWhatFollows) {
  const auto pages = fillPages({}, {chunkOf(80), chunkOf(10, true), chunkOf(11)}, lookOf(1));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(heightsOn(pages[0]), Heights{80});
  EXPECT_EQ(heightsOn(pages[1]), (Heights{10, 11}));
}

TEST(FillPages, PartsWhatKeepsTogether_OnlyWhereItIsHigherThanAColumn) {
  const auto pages = fillPages({}, {chunkOf(50, true), chunkOf(40, true), chunkOf(30)}, lookOf(1));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(heightsOn(pages[0]), (Heights{50, 40}));
}

TEST(FillPages, LetsTextGoBeforeAFigureThatFindsNoRoom_WhichIsNeverParted) {
  const auto pages = fillPages({}, {chunkOf(60), floating(50), chunkOf(30), chunkOf(20)}, lookOf(1));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(heightsOn(pages[0]), (Heights{60, 30}));
  EXPECT_EQ(heightsOn(pages[1]), (Heights{50, 20}));
}

TEST(FillPages, PrintsAFigureThatComesLast) {
  const auto pages = fillPages({}, {chunkOf(60), floating(50)}, lookOf(1));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(heightsOn(pages[1]), Heights{50});
}

TEST(FillPages, KeepsFiguresInTheirOrder) {
  const auto pages = fillPages({}, {chunkOf(60), floating(50), floating(20), chunkOf(10)}, lookOf(1));
  EXPECT_EQ(heightsOn(pages[0]), (Heights{60, 10}));
  EXPECT_EQ(heightsOn(pages[1]), (Heights{50, 20}));
}

TEST(FillPages, KeepsAHeadingWithWhatFollows_WhereAFigureTakesMostOfTheNextColumn) {
  const auto pages = fillPages({}, {chunkOf(85), floating(85), chunkOf(10, true), chunkOf(11)}, lookOf(1));
  ASSERT_EQ(pages.size(), 3U);
  EXPECT_EQ(heightsOn(pages[1]), Heights{85});
  EXPECT_EQ(heightsOn(pages[2]), (Heights{10, 11}));
}

TEST(FillPages, BeginsAllColumnsOfTheFirstPageBelowItsTitle) {
  const auto pages = fillPages({chunkOf(30)}, {chunkOf(40), chunkOf(50)}, lookOf(2));
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_GT(pages[0][1].at.y, 50);
  EXPECT_EQ(pages[0][1].at.y, pages[0][2].at.y);
}

} // namespace
} // namespace halfspace
