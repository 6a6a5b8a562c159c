// LaTeX as tokens, and the stream of them that macros flow into.
#include "widgets/formula/latex_tokens.h"

#include "widgets/formula/token_stream.h"

#include <gtest/gtest.h>

namespace halfspace::math {
namespace {

/// A token as it was written, with its column before it: `3:\vec`. A space is `_`.
std::string shown(const Token &token) {
  if (token.isEnd())
    return "end";
  return std::to_string(token.column) + ":" + (token.kind == Token::Kind::Space ? "_" : sourceOf(token));
}

std::string tokensOf(std::string_view latex) {
  std::string text;
  for (const Token &token : tokenize(latex))
    text += (text.empty() ? "" : " ") + shown(token);
  return text;
}

/// All that is left in a stream, macros put in.
std::string restOf(TokenStream &stream) {
  std::string text;
  while (!stream.peek().isEnd())
    text += (text.empty() ? "" : " ") + shown(stream.take());
  return text;
}

/// Where tokenizing fails; 0: it does not.
std::size_t failsAt(std::string_view latex) {
  try {
    (void)tokenize(latex);
  } catch (const ReadError &error) {
    return error.column;
  }
  return 0;
}

TEST(Tokens, OfCharactersAndCommands_KnowTheirColumns) {
  EXPECT_EQ(tokensOf("x^\\vec n"), "1:x 2:^ 3:\\vec 8:n");
  EXPECT_EQ(tokensOf("λ\\cdot𝑥\\,y"), "1:λ 2:\\cdot 7:𝑥 8:\\, 10:y") << "characters are counted, not bytes";
}

TEST(Tokens, OfWhiteSpace_AreOneSpaceAndNoneBehindANamedCommand) {
  EXPECT_EQ(tokensOf("a \t\n b"), "1:a 2:_ 6:b");
  EXPECT_EQ(tokensOf("\\vec  n"), "1:\\vec 7:n");
  EXPECT_EQ(tokensOf("\\, n"), "1:\\, 3:_ 4:n") << "a sign as a command keeps it";
}

TEST(Tokens, OfACommandBeforeADigit_EndWithItsLetters) {
  EXPECT_EQ(tokensOf("\\alpha2"), "1:\\alpha 7:2");
  EXPECT_EQ(tokensOf("\\\\a"), "1:\\\\ 3:a");
  EXPECT_EQ(tokensOf("\\{a\\}"), "1:\\{ 3:a 4:\\}");
}

TEST(Tokens, OfComments_AreNoneUpToTheNextLinesWords) {
  EXPECT_EQ(tokensOf("a% b \\c\n   d"), "1:a 12:d");
  EXPECT_EQ(tokensOf("a%"), "1:a");
  EXPECT_EQ(tokensOf("50\\%"), "1:5 2:0 3:\\%") << "a sign of its own";
}

TEST(Tokens, OfEveryLengthInUtf8_AreTheCharactersThatWereWritten) {
  for (const char32_t character :
       {U'\x7F', U'\x80', U'\x7FF', U'\x800', U'\xD7FF', U'\xE000', U'\xFFFF', U'\x10000', U'\x10FFFF'}) {
    std::string text = "a";
    appendUtf8(text, character);
    const auto tokens = tokenize(text);
    ASSERT_EQ(tokens.size(), 2U);
    EXPECT_EQ(tokens[1].character, character);
    EXPECT_EQ(sourceOf(tokens[1]), text.substr(1));
  }
}

TEST(Tokens, OfBytesThatAreNoUtf8_AreRefusedAtTheirColumn) {
  EXPECT_EQ(failsAt("λ\x80"), 2U) << "a byte that continues nothing";
  EXPECT_EQ(failsAt("\xE2\x82"), 1U) << "cut off";
  EXPECT_EQ(failsAt("ab\xC1\x81"), 3U) << "longer than it need be";
  EXPECT_EQ(failsAt("\xE0\x80\xAF"), 1U);
  EXPECT_EQ(failsAt("\xF0\x8F\xBF\xBF"), 1U);
  EXPECT_EQ(failsAt("\xED\xBF\xBF"), 1U) << "half of a pair";
  EXPECT_EQ(failsAt("\xF4\x90\x80\x80"), 1U) << "beyond Unicode";
  EXPECT_EQ(failsAt("a\\λ"), 0U) << "any character may name a command";
}

TEST(TokenStream, InMathematics_PassesOverSpaces) {
  const Macros none;
  TokenStream stream("a  b", none);
  EXPECT_EQ(shown(stream.take()), "1:a");
  EXPECT_EQ(shown(stream.peek()), "2:_");
  EXPECT_EQ(shown(stream.peekMath()), "4:b");
  EXPECT_EQ(shown(stream.takeMath()), "4:b");
  EXPECT_TRUE(stream.take().isEnd());
  EXPECT_TRUE(stream.take().isEnd()) << "however often it is asked";
}

TEST(TokenStream, AskedForACharacter_TakesOnlyThat) {
  const Macros none;
  TokenStream stream("a ]", none);
  EXPECT_FALSE(stream.takeIf(']'));
  EXPECT_TRUE(stream.takeIf('a'));
  EXPECT_TRUE(stream.takeIf(']')) << "behind a space";
  EXPECT_FALSE(stream.takeIf(']'));
}

TEST(TokenStream, BetweenBrackets_SeesThoseInBracesAsInside) {
  const Macros none;
  TokenStream stream("[a{]}b]c", none);
  std::string inside;
  for (const Token &token : stream.takeBetween('[', ']'))
    inside += sourceOf(token);
  EXPECT_EQ(inside, "a{]}b");
  EXPECT_EQ(restOf(stream), "8:c");
}

TEST(TokenStream, WithoutTheClosingBracket_NamesBothAtTheOpeningOne) {
  const Macros none;
  TokenStream stream("a[b", none);
  (void)stream.take();
  try {
    (void)stream.takeBetween('[', ']');
    ADD_FAILURE() << "it was closed";
  } catch (const ReadError &error) {
    EXPECT_EQ(error.column, 2U);
    EXPECT_EQ(error.sentence, "A `]` is missing for this `[`.");
  }
}

TEST(TokenStream, WithTokensPutBefore_GivesThemFirstInTheirOrder) {
  const Macros none;
  TokenStream stream("c", none);
  stream.prepend(tokenize("ab"));
  EXPECT_EQ(restOf(stream), "1:a 2:b 1:c");
}

TEST(TokenStream, OfAMacro_HasItsBodyAtTheColumnOfItsUse) {
  const Macros macros{{"v", {1, "\\vec{#1}"}}, {"o", {0, ""}}};
  TokenStream stream("a\\v nb", macros);
  EXPECT_EQ(restOf(stream), "1:a 2:\\vec 2:{ 5:n 2:} 6:b");
  TokenStream empty("\\o\\o", macros);
  EXPECT_TRUE(empty.peek().isEnd());
}

TEST(TokenStream, OfAMacrosArguments_PutsInAsManyAsThereAre) {
  const Macros macros{{"f", {2, "#2#1#3#"}}};
  TokenStream stream("\\f{ab}c", macros);
  EXPECT_EQ(restOf(stream), "7:c 4:a 5:b 1:# 1:3 1:#") << "what is no argument stays as it is written";
}

} // namespace
} // namespace halfspace::math
