#include "lessons/reading/csv_reader.h"

#include "lessons/reading/document.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Cells = std::vector<std::vector<std::string>>;

/// All rows of a text; on a problem none.
Cells cellsOf(std::string_view text) {
  CsvReader reader(text, "a.csv");
  Cells cells;
  while (true) {
    auto row = reader.next();
    if (!row)
      return {};
    if (!*row)
      return cells;
    cells.push_back((*row)->cells);
  }
}

/// The first problem of a text.
std::string problemOf(std::string_view text) {
  CsvReader reader(text, "a.csv");
  while (true) {
    const auto row = reader.next();
    if (!row)
      return row.problem().text();
    if (!*row)
      return "none";
  }
}

TEST(CsvReader, OfRows_PartsThemByWhatTheFirstIsPartedBy) {
  EXPECT_EQ(cellsOf("a,b\n1, 2 \n"), (Cells{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(cellsOf("a;b\n1,5;2"), (Cells{{"a", "b"}, {"1,5", "2"}}));
  EXPECT_EQ(cellsOf("a\tb\n1,5\t2;3"), (Cells{{"a", "b"}, {"1,5", "2;3"}}));
  EXPECT_EQ(cellsOf("a\tb\n\t2"), (Cells{{"a", "b"}, {"", "2"}})) << "a tab is no blank there";
  EXPECT_EQ(cellsOf("\"a;\",b\n1;2,3"), (Cells{{"a;", "b"}, {"1;2", "3"}}));
}

TEST(CsvReader, OfEachEndOfALine_IsTheSame) {
  const Cells cells{{"a", "b"}, {"1", ""}, {"2", "3"}};
  for (const char *end : {"\n", "\r\n", "\r"})
    for (const bool isLastEnded : {true, false})
      EXPECT_EQ(cellsOf("a,b" + std::string(end) + "1," + end + "2,3" + (isLastEnded ? end : "")), cells);
}

TEST(CsvReader, OfQuotedCells_KeepsWhatStandsBetweenTheQuotes) {
  EXPECT_EQ(cellsOf("\"a, b\" , \"say \"\"n\"\"\",\"\"\n"), (Cells{{"a, b", "say \"n\"", ""}}));
  EXPECT_EQ(cellsOf("\"two\r\nlines\",c"), (Cells{{"two\nlines", "c"}}));
  EXPECT_EQ(cellsOf("5\",6"), (Cells{{"5\"", "6"}})) << "a quote within a plain cell is one";
}

TEST(CsvReader, OfRowsWithNothingInThem_PassesOverThem) {
  EXPECT_EQ(cellsOf("a,b\n,\n\n \n1,2\n,,\n"), (Cells{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(cellsOf(""), Cells());
}

TEST(CsvReader, CountsLines_AlsoThoseWithinQuotes) {
  CsvReader reader("a\r\n\"x\n\ny\"\nb", "a.csv");
  std::vector<int> lines;
  while (const auto row = *reader.next())
    lines.push_back(row->line);
  EXPECT_EQ(lines, (std::vector<int>{1, 2, 5}));
}

TEST(CsvReader, OfADamagedTable_SaysWhereAndWhat) {
  EXPECT_EQ(problemOf("a\n\"b\nc"), "a.csv:2: The quotes that begin a cell here do not end.");
  EXPECT_EQ(problemOf("a\n\"b\"c"),
            "a.csv:2: Behind the quotes of a cell something follows that is no part of it: "
            "a quote within a cell is written twice.");
  EXPECT_EQ(problemOf(std::string(mostCsvCells, ',')),
            "a.csv:1: This row has too many cells: at most 200 are read.");
  EXPECT_EQ(problemOf(std::string(mostCsvCells - 1, ',') + "a"), "none");
  EXPECT_EQ(problemOf("a\n" + std::string(maxFieldText + 1, 'x')),
            "a.csv:2: This cell is too long: at most 4000 bytes are read.");
}

} // namespace
} // namespace halfspace
