#include "widgets/picture/math/alphabets.h"

#include <gtest/gtest.h>

namespace halfspace::math {
namespace {

TEST(InAlphabet, LettersOfEachAlphabet_AreTheirCharacters) {
  EXPECT_EQ(inAlphabet('x', Alphabet::Italic), U'𝑥');
  EXPECT_EQ(inAlphabet('x', Alphabet::Upright), U'x');
  EXPECT_EQ(inAlphabet('x', Alphabet::Bold), U'𝐱');
  EXPECT_EQ(inAlphabet('x', Alphabet::BoldItalic), U'𝒙');
  EXPECT_EQ(inAlphabet('A', Alphabet::Blackboard), U'𝔸');
  EXPECT_EQ(inAlphabet('A', Alphabet::Script), U'𝒜');
  EXPECT_EQ(inAlphabet('g', Alphabet::Fraktur), U'𝔤');
  EXPECT_EQ(inAlphabet('T', Alphabet::Sans), U'𝖳');
  EXPECT_EQ(inAlphabet('t', Alphabet::Mono), U'𝚝');
}

TEST(InAlphabet, LettersThatUnicodeHadBefore_AreThose) {
  EXPECT_EQ(inAlphabet('h', Alphabet::Italic), U'ℎ');
  EXPECT_EQ(inAlphabet('R', Alphabet::Blackboard), U'ℝ');
  EXPECT_EQ(inAlphabet('C', Alphabet::Blackboard), U'ℂ');
  EXPECT_EQ(inAlphabet('L', Alphabet::Script), U'ℒ');
  EXPECT_EQ(inAlphabet('I', Alphabet::Fraktur), U'ℑ');
}

TEST(InAlphabet, GreekAndDigits_AreThereWhereUnicodeHasThem) {
  EXPECT_EQ(inAlphabet(U'λ', Alphabet::Italic), U'𝜆');
  EXPECT_EQ(inAlphabet(U'λ', Alphabet::Bold), U'𝛌');
  EXPECT_EQ(inAlphabet(U'ϕ', Alphabet::Italic), U'𝜙');
  EXPECT_EQ(inAlphabet(U'Γ', Alphabet::Bold), U'𝚪');
  EXPECT_EQ(inAlphabet('7', Alphabet::Bold), U'𝟕');
  EXPECT_EQ(inAlphabet('7', Alphabet::Italic), U'7');
  EXPECT_EQ(inAlphabet(U'λ', Alphabet::Script), U'λ');
}

TEST(InAlphabet, OtherCharacters_StayAsTheyAre) {
  EXPECT_EQ(inAlphabet('+', Alphabet::Bold), U'+');
  EXPECT_EQ(inAlphabet(U'ж', Alphabet::Italic), U'ж');
}

TEST(WithoutAlphabet, ACharacterOfAnAlphabet_IsItsLetter) {
  EXPECT_EQ(withoutAlphabet(U'𝑥'), U'x');
  EXPECT_EQ(withoutAlphabet(U'ℝ'), U'R');
  EXPECT_EQ(withoutAlphabet(U'𝛌'), U'λ');
  EXPECT_EQ(withoutAlphabet(U'x'), 0U);
  EXPECT_EQ(withoutAlphabet(U'+'), 0U);
}

} // namespace
} // namespace halfspace::math
