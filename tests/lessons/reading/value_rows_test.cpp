#include "lessons/reading/value_rows.h"

#include "lessons/reading/document.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::string problemOf(std::string_view text) {
  const auto rows = readValueRows(text, "a.csv");
  return rows ? "none" : rows.problem().text();
}

/// Each row's values in the order of the columns, with | between them.
std::vector<std::string> spelled(std::string_view text) {
  const auto rows = readValueRows(text, "a.csv");
  EXPECT_TRUE(rows) << rows.problem().text();
  std::vector<std::string> lines;
  for (std::size_t row = 0; rows && row < rows->rows.size(); ++row) {
    lines.emplace_back();
    for (std::size_t column = 0; column < rows->columns.size(); ++column)
      lines.back() += (column == 0 ? "" : "|") + rows->valueIn(row, column);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(ValueRows, OfACsvFile_AreItsRowsBelowTheNames) {
  const auto rows = readValueRows(
      "\xEF\xBB\xBFQ,E.n,name\r\n\"11,15,8\",\"0,0,1\",first\r\n,\"1,0,0\",second\r\n", "a.csv");
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->columns, (Lines{"Q", "E.n", "name"})) << "without the byte order mark";
  ASSERT_EQ(rows->rows.size(), 2U);
  EXPECT_EQ(rows->valueIn(0, 0), "11,15,8");
  EXPECT_EQ(rows->rows[1].values.size(), 2U) << "what is left empty is no value";
  EXPECT_EQ(rows->rows[1].line, 3);
  EXPECT_EQ(rows->columnOf("name"), 2U);
  EXPECT_FALSE(rows->columnOf("Name"));
}

TEST(ValueRows, OfACsvFileWithSemicolons_MayHaveDecimalCommas) {
  EXPECT_EQ(spelled("t;Q\n1,5;11,15,8\n2;\"1,5; 2; -0,25\"\n3.5;1"),
            (Lines{"1.5|11,15,8", "2|1.5, 2, -0.25", "3.5|1"}));
  EXPECT_EQ(spelled("t,Q\n\"1,5\",2"), (Lines{"1,5|2"})) << "with commas between the cells it is no mark";
}

TEST(ValueRows, OfJsonLines_AreItsObjects) {
  EXPECT_EQ(spelled(R"( {"Q": [11, "15", 8.5], "t": 1e-3}

{"name": "b", "t": "-10/3", "Q": null}
)"),
            (Lines{"11,15,8.5|1e-3|", "|-10/3|b"}));
}

TEST(ValueRows, OfADamagedFile_SayLineNameAndWhatIsWrong) {
  const std::string noRows =
      "a.csv: The file has no rows of values: its first row names the coordinates, and each row "
      "below it is for a figure.";
  EXPECT_EQ(problemOf(""), noRows);
  EXPECT_EQ(problemOf("Q,t\n,\n"), noRows);
  EXPECT_EQ(problemOf("Q,,t\n1,2,3"),
            "a.csv:1: A column has no name: the first row names the coordinates, as --set does.");
  EXPECT_EQ(problemOf("Q,t,,\n1,2,,\n"), "none") << "spreadsheets write empty columns";
  EXPECT_EQ(problemOf("Q,Q\n1,2"), "a.csv:1: Q: Two columns have this name.");
  EXPECT_EQ(problemOf("Q\n1,2,3"),
            "a.csv:2: “2” stands in a column without a name. Numbers with commas between them "
            "need quotes around them.");
  EXPECT_EQ(problemOf("Q\n\n\xFF"), "a.csv:3: " + notText());
  const std::string noObject = "This line is no JSON object with a value for each name, as "
                               R"({"Q": [11, 15, 8], "t": 0.5}.)";
  EXPECT_EQ(problemOf("{\"t\":1}\n[1]"), "a.csv:2: " + noObject);
  EXPECT_EQ(problemOf("{\"t\":1"), "a.csv:1: " + noObject);
  EXPECT_EQ(problemOf("{\"t\":1,\"t\":2}"), "a.csv:1: " + noObject) << "no name twice";
  for (const char *value : {"true", "{}", "[]", "[[1]]", "[null]"})
    EXPECT_NE(problemOf("{\"t\":" + std::string(value) + "}").find("a.csv:1: "), std::string::npos) << value;
  EXPECT_EQ(problemOf("{\"t\":true}"),
            "a.csv:1: t: This is no value of a coordinate: write it as 3, \"-10/3\" or [1, 2, 3].");
}

TEST(ValueRows, BeyondTheLimits_AreRefused) {
  std::string rows = "t\n";
  for (std::size_t row = 0; row < mostRows; ++row)
    rows += "1\n";
  EXPECT_EQ(problemOf(rows), "none");
  EXPECT_EQ(problemOf(rows + "1"), "a.csv:100002: The file has too many rows: at most 100000 are read.");
  std::string objects;
  for (std::size_t column = 0; column <= mostColumns; ++column)
    objects += "{\"" + std::to_string(column) + "\":1}\n";
  EXPECT_EQ(problemOf(objects), "a.csv:201: 200: The file has too many columns: at most 200 are read.");
  EXPECT_EQ(problemOf("{\"t\":\"" + std::string(maxFieldText + 1, '1') + "\"}").substr(0, 8), "a.csv:1:");
}

} // namespace
} // namespace halfspace
