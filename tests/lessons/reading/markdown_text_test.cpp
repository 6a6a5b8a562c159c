#include "lessons/reading/markdown_text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(MarkdownText, OfWordsInCode_HasThemAsWrittenAndAsRead) {
  const MarkdownText text = "So *it* is: $x$.";
  EXPECT_EQ(text.written(), "So *it* is: $x$.");
  EXPECT_FALSE(text.problem());
  EXPECT_EQ(text.markdown().blocks, readMarkdown(text.written())->blocks);
  ASSERT_EQ(text.markdown().formulas.size(), 1U);
  EXPECT_EQ(writtenIn(text.markdown().formulas.front()), "x");
}

TEST(MarkdownText, Copied_SharesWhatWasRead) {
  const MarkdownText text = "words";
  const MarkdownText copy = text;
  EXPECT_EQ(&copy.markdown(), &text.markdown());
}

TEST(MarkdownText, WithoutWords_IsEmpty) {
  const MarkdownText text;
  EXPECT_TRUE(text.isEmpty());
  EXPECT_TRUE(text.markdown().blocks.empty());
  EXPECT_FALSE(text.problem());
  EXPECT_TRUE(MarkdownText("").isEmpty());
}

TEST(MarkdownText, ThatCannotBeRead_TellsWhy_AndStandsAsItIsWrittenOnOneLine) {
  const std::string deep = std::string(maxMarkdownDepth + 1, '>') + " *a*\n\n $x$ ";
  const MarkdownText text = deep;
  EXPECT_EQ(text.written(), deep);
  ASSERT_TRUE(text.problem());
  EXPECT_EQ(text.problem()->sentence, readMarkdown(deep).problem().sentence);
  ASSERT_EQ(text.markdown().blocks.size(), 1U);
  ASSERT_EQ(text.markdown().blocks.front().spans.size(), 1U);
  EXPECT_EQ(text.markdown().blocks.front().spans.front().text,
            std::string(maxMarkdownDepth + 1, '>') + " *a* $x$");
  EXPECT_TRUE(text.markdown().formulas.empty());
}

} // namespace
} // namespace halfspace
