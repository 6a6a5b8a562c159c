#include "widgets/picture/labels/written_row.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// Numbers in a row from left to right, so many pixels apart, 30 wide.
std::vector<RowNumber> rowOf(int first, int last, double apart) {
  std::vector<RowNumber> row;
  for (int place = first; place <= last; ++place)
    if (place != 0)
      row.push_back({place, {{place * apart, 0}, {place * apart + 30, 10}}});
  return row;
}

std::vector<int> writtenIn(const std::vector<RowNumber> &row) {
  std::vector<int> places;
  const std::vector<bool> written = writtenOf(row);
  for (std::size_t i = 0; i < row.size(); ++i)
    if (written[i])
      places.push_back(row[i].place);
  return places;
}

using Places = std::vector<int>;

TEST(WrittenRow, WithRoomForAll_HasAll) {
  EXPECT_EQ(writtenIn(rowOf(-2, 3, 40)), (Places{-2, -1, 1, 2, 3}));
  EXPECT_EQ(writtenIn({}), Places());
}

TEST(WrittenRow, WithoutRoom_IsThinnedOutEvenly) {
  EXPECT_EQ(writtenIn(rowOf(1, 9, 20)), (Places{2, 4, 6, 8}));
  EXPECT_EQ(writtenIn(rowOf(-12, 12, 8)), (Places{-10, -5, 5, 10}));
  EXPECT_EQ(writtenIn(rowOf(1, 40, 4)), (Places{10, 20, 30, 40}));
}

TEST(WrittenRow, OfWhichOneCannotBeRead_IsThinnedOutFurther_WhereThatLeavesAScale) {
  std::vector<RowNumber> row = rowOf(1, 8, 40);
  row[2].canBeRead = false;
  EXPECT_EQ(writtenIn(row), (Places{2, 4, 6, 8}));
  row[5].canBeRead = false;
  EXPECT_EQ(writtenIn(row), (Places{1, 2, 4, 5, 7, 8})) << "else it has gaps";
}

TEST(WrittenRow, OfOneThatCannotBeRead_IsEmpty) {
  std::vector<RowNumber> row = rowOf(1, 1, 40);
  row[0].canBeRead = false;
  EXPECT_EQ(writtenIn(row), Places());
}

TEST(WrittenRow, OfNumbersInOnePlace_HasThoseOfTheLargestStepAtMost) {
  EXPECT_LE(writtenIn(rowOf(1, 30, 0)).size(), 1U) << "an axis that is seen from its end";
}

} // namespace
} // namespace halfspace
