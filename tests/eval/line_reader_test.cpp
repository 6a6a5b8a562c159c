#include "eval/line_reader.h"

#include "eval/json_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace halfspace {
namespace {

std::vector<std::string> linesOf(std::istream &stream) {
  LineReader reader(stream, [] {});
  std::vector<std::string> lines;
  while (const auto line = reader.next())
    lines.emplace_back(*line);
  EXPECT_FALSE(reader.failed());
  return lines;
}

std::vector<std::string> linesOf(const std::string &text) {
  std::istringstream stream(text);
  return linesOf(stream);
}

using Lines = std::vector<std::string>;

const std::string mark = "\xEF\xBB\xBF";

TEST(LineReader, EitherEnd_IsTakenOffAndTheLastLineNeedsNone) {
  EXPECT_EQ(linesOf("a\nb\r\nc"), (Lines{"a", "b", "c"}));
  EXPECT_EQ(linesOf("a\nb\n"), (Lines{"a", "b"}));
  EXPECT_EQ(linesOf("a\r\n"), (Lines{"a"}));
  EXPECT_EQ(linesOf(""), Lines());
}

TEST(LineReader, CarriageReturnsElsewhere_Stay) {
  EXPECT_EQ(linesOf("a\rb\r\r\nc\r\r"), (Lines{"a\rb\r", "c\r"}));
}

TEST(LineReader, CarriageReturnAtTheVeryEnd_IsTheFrontHalfOfAnEnd) {
  EXPECT_EQ(linesOf("a\r"), (Lines{"a"}));
  EXPECT_EQ(linesOf("a\n\r"), (Lines{"a"}));
  EXPECT_EQ(linesOf("a\r\n\r"), (Lines{"a"}));
  EXPECT_EQ(linesOf("\r"), Lines());
  EXPECT_EQ(linesOf(" \t\r"), Lines());
  EXPECT_EQ(linesOf(mark + "\r"), Lines());
}

TEST(LineReader, BlankLines_AreSkipped) {
  EXPECT_EQ(linesOf("\n\r\n \t \n\t\r\na\n\n  b \n \t"), (Lines{"a", "  b "}));
}

TEST(LineReader, ByteOrderMark_IsPassedOverBeforeTheFirstLineAlone) {
  EXPECT_EQ(linesOf(mark + "a\n" + mark + "b"), (Lines{"a", mark + "b"}));
  EXPECT_EQ(linesOf(mark + "\n" + mark + "b"), (Lines{mark + "b"})) << "the first line was blank";
  EXPECT_EQ(linesOf(mark), Lines());
  EXPECT_EQ(linesOf(mark + mark + "a"), (Lines{mark + "a"}));
}

TEST(LineReader, ZeroBytes_AreBytesLikeOthers) {
  const std::string text("a\0b\n\0\n", 6);
  EXPECT_EQ(linesOf(text), (Lines{std::string("a\0b", 3), std::string("\0", 1)}));
}

/// Some bytes in front, so many of another, and some behind, without holding them all.
class LongText : public std::streambuf {
public:
  LongText(std::string front, char filler, std::size_t count, std::string behind)
      : m_front(std::move(front)), m_behind(std::move(behind)), m_filler(1U << 16U, filler), m_left(count) {}

private:
  int_type underflow() override {
    std::string &part = part_();
    if (part.empty())
      return traits_type::eof();
    std::size_t size = part.size();
    if (&part == &m_filler) {
      size = std::min(size, m_left);
      m_left -= size;
    }
    setg(part.data(), part.data(), part.data() + size);
    return traits_type::to_int_type(part.front());
  }

  std::string &part_() {
    if (!std::exchange(m_frontGiven, true) && !m_front.empty())
      return m_front;
    if (m_left > 0)
      return m_filler;
    return std::exchange(m_behindGiven, true) ? m_nothing : m_behind;
  }

  std::string m_front;
  std::string m_behind;
  std::string m_filler;
  std::string m_nothing;
  std::size_t m_left;
  bool m_frontGiven = false;
  bool m_behindGiven = false;
};

std::vector<std::size_t> lengthsOf(LongText text) {
  std::istream stream(&text);
  LineReader reader(stream, [] {});
  std::vector<std::size_t> lengths;
  while (const auto line = reader.next())
    lengths.push_back(line->size());
  return lengths;
}

TEST(LineReader, LineOfTheLargestLength_ComesWholeWithEitherEndAndBehindAMark) {
  using Lengths = std::vector<std::size_t>;
  for (const char *end : {"\nnext", "\r\nnext"})
    EXPECT_EQ(lengthsOf({"", 'x', maxLineLength, end}), (Lengths{maxLineLength, 4}));
  EXPECT_EQ(lengthsOf({mark, 'x', maxLineLength, "\r\nnext"}), (Lengths{maxLineLength, 4}));
  EXPECT_EQ(lengthsOf({mark, 'x', maxLineLength, "\r"}), (Lengths{maxLineLength}));
}

TEST(LineReader, LongerLine_ComesAsNoMoreThanItTakesToTellAndTheNextOneFollows) {
  constexpr std::size_t little = 16;
  for (const std::size_t over : {std::size_t{1}, std::size_t{100}, maxLineLength}) {
    const auto lengths = lengthsOf({over == 1 ? mark : "", 'x', maxLineLength + over, "\r\nnext"});
    ASSERT_EQ(lengths.size(), 2U);
    EXPECT_GT(lengths[0], maxLineLength);
    EXPECT_LE(lengths[0], maxLineLength + little);
    EXPECT_EQ(lengths[1], 4U);
  }
}

TEST(LineReader, LongLineThatIsBlankOnlyAtItsFront_IsNotBlank) {
  const auto lengths = lengthsOf({"", ' ', maxLineLength + 100, "{}\nnext"});
  ASSERT_EQ(lengths.size(), 2U);
  EXPECT_GT(lengths[0], maxLineLength);
}

/// Gives so many bytes at a time, as a pipe may.
class Dripping : public std::streambuf {
public:
  Dripping(std::string text, std::size_t portion) : m_text(std::move(text)), m_portion(portion) {}

private:
  int_type underflow() override {
    if (m_at >= m_text.size())
      return traits_type::eof();
    char *from = m_text.data() + m_at;
    const std::size_t size = std::min(m_portion, m_text.size() - m_at);
    m_at += size;
    setg(from, from, from + size);
    return traits_type::to_int_type(*from);
  }

  std::string m_text;
  std::size_t m_portion;
  std::size_t m_at = 0;
};

TEST(LineReader, PortionsOfAnySize_GiveTheSameLines) {
  const std::string text = mark + "first\r\n\n \t\r\nsecond\n\rthird\r\nlast";
  const Lines expected{"first", "second", "\rthird", "last"};
  for (std::size_t portion = 1; portion <= text.size(); ++portion) {
    Dripping source(text, portion);
    std::istream stream(&source);
    EXPECT_EQ(linesOf(stream), expected) << portion;
  }
}

TEST(LineReader, BeforeMoreIsWaitedFor_SaysSo) {
  Dripping source("a\nb\nc\n", 2);
  std::istream stream(&source);
  int waits = 0;
  LineReader reader(stream, [&] { ++waits; });
  for (int lines = 1; lines <= 3; ++lines) {
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(waits, lines);
  }
  EXPECT_FALSE(reader.next());
}

/// As the standard library says that the operating system refuses.
class Refusing : public std::streambuf {
  int_type underflow() override { throw std::ios_base::failure("refused"); }
};

TEST(LineReader, SourceThatRefuses_HasFailedAndGivesNothing) {
  Refusing source;
  std::istream stream(&source);
  LineReader reader(stream, [] {});
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.failed());
  EXPECT_FALSE(reader.next());
}

} // namespace
} // namespace halfspace
