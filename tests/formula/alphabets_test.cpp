#include "widgets/formula/alphabets.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

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

const std::vector<Alphabet> allAlphabets{Alphabet::Italic,     Alphabet::Upright,    Alphabet::Bold,
                                         Alphabet::BoldItalic, Alphabet::Blackboard, Alphabet::Script,
                                         Alphabet::Fraktur,    Alphabet::Sans,       Alphabet::Mono};

/// All Latin and Greek letters and digits.
std::u32string allLetters() {
  std::u32string letters;
  for (const auto &[first, last] :
       {std::pair{U'A', U'Z'}, {U'a', U'z'}, {U'0', U'9'}, {U'Α', U'Ρ'}, {U'α', U'ω'}})
    for (char32_t letter = first; letter <= last; ++letter)
      letters += letter;
  return letters;
}

TEST(Alphabets, OfAnyLetter_GiveItBack) {
  for (const Alphabet alphabet : allAlphabets)
    for (const char32_t letter : allLetters()) {
      const char32_t character = inAlphabet(letter, alphabet);
      if (character != letter) {
        EXPECT_EQ(withoutAlphabet(character), letter) << static_cast<unsigned>(letter);
      }
      EXPECT_EQ(inAlphabet(character, alphabet), character) << "it has its form already";
    }
}

TEST(Alphabets, OfDifferentLetters_AreDifferentCharacters) {
  for (const Alphabet alphabet : allAlphabets) {
    std::set<char32_t> characters;
    for (const char32_t letter : allLetters())
      EXPECT_TRUE(characters.insert(inAlphabet(letter, alphabet)).second) << static_cast<unsigned>(letter);
  }
}

TEST(Alphabets, ForLatinLetters_HaveFormsForAllOfThem) {
  for (const Alphabet alphabet : allAlphabets)
    for (char32_t letter = 'A'; letter <= 'z'; ++letter)
      if ((letter <= 'Z' || letter >= 'a') && alphabet != Alphabet::Upright) {
        EXPECT_NE(inAlphabet(letter, alphabet), letter) << static_cast<unsigned>(letter);
      }
}

} // namespace
} // namespace halfspace::math
