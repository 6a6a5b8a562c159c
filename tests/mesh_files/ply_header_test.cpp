#include "widgets/mesh_files/ply_header.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::string sentenceOf(std::string_view head) {
  const auto header = readPlyHeader(head);
  return header ? "" : header.problem().sentence;
}

TEST(PlyHeader, OfABinaryFileTellsItsCountsAndItsLeastContent) {
  const std::string head = "ply\nformat binary_little_endian 1.0\ncomment 3 things\nobj_info of a test\n"
                           "element vertex 8\nproperty float x\nproperty float y\nproperty double z\n"
                           "element face 6\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                           "end_header\n";
  const auto header = readPlyHeader(head + "more");
  ASSERT_TRUE(header) << header.problem().text();
  EXPECT_EQ(header->bytes, head.size());
  EXPECT_EQ(header->countOf("vertex"), 8U);
  EXPECT_EQ(header->countOf("face"), 6U);
  EXPECT_EQ(header->leastContent, 8U * 16 + 6U * (1 + 3 * 4 + 1));
}

TEST(PlyHeader, OfATextFileCountsADigitAndItsEndForEachNumber) {
  const auto header =
      readPlyHeader("ply\r\nformat ascii 1.0\r\nelement vertex 5\r\nproperty float x\r\n"
                    "element face 2\r\nproperty list uchar int vertex_index\r\nend_header\r\n");
  ASSERT_TRUE(header) << header.problem().text();
  EXPECT_EQ(header->leastContent, 5U * 2 + 2U * 8);
}

TEST(PlyHeader, WithCountsBeyondAllNumbersStaysABound) {
  const auto header = readPlyHeader("ply\nformat ascii 1.0\nelement vertex 99999999999999999999999999\n"
                                    "property double x\nelement face 18446744073709551615\n"
                                    "property list int double vertex_indices\nend_header\n");
  ASSERT_TRUE(header) << header.problem().text();
  EXPECT_GT(header->leastContent, 1ULL << 40U);
  EXPECT_LE(header->leastContent, mostLeastContent);
}

TEST(PlyHeader, ThatIsDamagedSaysWhere) {
  EXPECT_NE(sentenceOf("ply\nformat ascii 1.0\nelement vertex 5\n").find("end_header"), std::string::npos);
  EXPECT_NE(sentenceOf("ply\nelement vertex 5\nend_header\n").find("format"), std::string::npos);
  for (const char *line :
       {"element vertex -1", "element vertex", "element vertex 1x", "property", "property real x",
        "property list uchar int", "format", "format utf8 1.0", "vertex 3", "property float x"}) {
    const auto header = readPlyHeader("ply\nformat ascii 1.0\n" + std::string(line) + "\nend_header\n");
    ASSERT_FALSE(header) << line;
    EXPECT_EQ(header.problem().line, 3) << line;
    EXPECT_NE(header.problem().sentence.find(line), std::string::npos) << header.problem().sentence;
  }
}

TEST(PlyHeader, TellsWhatEachElementIsMadeOfInItsOrder) {
  const auto header = readPlyHeader("ply\nformat binary_big_endian 1.0\nelement face 1\n"
                                    "property list uchar int vertex_indices\nelement vertex 3\n"
                                    "property double x\nproperty list int8 ushort others\nend_header\n");
  ASSERT_TRUE(header) << header.problem().text();
  EXPECT_EQ(header->form, PlyForm::HighestByteFirst);
  ASSERT_EQ(header->elements.size(), 2U);
  EXPECT_EQ(header->elements[0].name, "face");
  EXPECT_TRUE(isListOfCorners(header->elements[0].properties.at(0)));
  const auto &corner = header->elements[1].properties;
  ASSERT_EQ(corner.size(), 2U);
  EXPECT_EQ(corner[0].name, "x");
  EXPECT_EQ(corner[0].number.bytes, 8U);
  EXPECT_FALSE(corner[0].count);
  EXPECT_EQ(corner[1].number.bytes, 2U);
  EXPECT_EQ(corner[1].count->kind, PlyNumber::Kind::Signed);
}

TEST(PlyHeader, ThatNamesAnElementTwiceIsRefused) {
  EXPECT_NE(sentenceOf("ply\nformat ascii 1.0\nelement face 1\nelement face 2\nend_header\n").find("face 2"),
            std::string::npos);
}

} // namespace
} // namespace halfspace
