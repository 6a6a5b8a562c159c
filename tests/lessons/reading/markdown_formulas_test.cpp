// How formulas are taken out of Markdown and found again, and the characters that it names.
#include "lessons/reading/markdown_formulas.h"

#include "lessons/reading/markdown_entity.h"
#include "lessons/text.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace halfspace {
namespace {

/// The formulas that stand in a text from which they were taken, in its order.
std::vector<std::size_t> foundIn(std::string_view text) {
  std::vector<std::size_t> found;
  for (FormulaPlace next = nextFormula(text); next.begin < next.end; next = nextFormula(text)) {
    found.push_back(next.formula);
    text.remove_prefix(next.end);
  }
  return found;
}

class ManyFormulas : public testing::TestWithParam<std::size_t> {};

TEST_P(ManyFormulas, InOneText_AreAllFoundAgainInTheirOrder) {
  std::string text;
  for (std::size_t i = 0; i < GetParam(); ++i)
    text += "$x$ ";
  ASSERT_LE(text.size(), maxMarkdownBytes);
  const MarkdownWithoutFormulas taken = takeFormulas(text);
  ASSERT_EQ(taken.formulas.size(), GetParam());
  const std::vector<std::size_t> found = foundIn(taken.markdown);
  ASSERT_EQ(found.size(), GetParam());
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_EQ(found[i], i);
  EXPECT_FALSE(firstNoText(taken.markdown)) << "what stands for them is text";
}

// Around the places where one more byte of a stand-in changes.
INSTANTIATE_TEST_SUITE_P(Count, ManyFormulas, testing::Values(1U, 64U, 65U, 4096U, 4097U, 16384U));

TEST(NextFormula, InATextWithoutOne_IsAtItsEnd) {
  for (const std::string_view text : {"", "words", "\xF3", "\xF3\x80\x80\x80", "\U0010FFFF"}) {
    const FormulaPlace place = nextFormula(text);
    EXPECT_EQ(place.begin, text.size());
    EXPECT_EQ(place.end, text.size());
  }
}

TEST(TakenFormulas, OfRandomTexts_StandWhereTheirPlacesSay) {
  static const std::vector<std::string> pieces{"$a_1$", "$ \\frac12$", "$$b*c$$", " words ",   "\n\n",
                                               "ö",     "`$c$`",       "\\$",     "$x$ = $3$", ",",
                                               "*so*",  "\n",          "{f}",     "$x$ = {f}"};
  RandomNumbers random(5);
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (int piece = random.integer(1, 12); piece > 0; --piece)
      text += pieces.at(static_cast<std::size_t>(random.integer(0, int(pieces.size()) - 1)));
    const MarkdownWithoutFormulas taken = takeFormulas(text);
    EXPECT_EQ(foundIn(taken.markdown).size(), taken.formulas.size()) << text;
    std::size_t last = 0;
    for (const MarkdownFormula &formula : taken.formulas)
      for (const MarkdownFormula::Side &side : formula.sides) {
        EXPECT_EQ(text.substr(side.place, side.text.size()), side.text) << text;
        EXPECT_GT(side.place, last) << text;
        EXPECT_NE(writtenIn(formula).find(side.text), std::string::npos) << text;
        last = side.place;
      }
  }
}

class Relations : public testing::TestWithParam<char> {};

TEST_P(Relations, BetweenTwoFormulas_MakeThemOne) {
  const std::string relation(1, GetParam());
  const MarkdownWithoutFormulas taken = takeFormulas("so $a$ " + relation + " $b$?");
  ASSERT_EQ(taken.formulas.size(), 1U);
  EXPECT_EQ(writtenIn(taken.formulas[0]), "a " + relation + " b");
  EXPECT_EQ(taken.formulas[0].punctuation, "?");
}

TEST(Formulas, PunctuationBehindThem_StaysWithThem_ButNotTheEndOfAnAddress) {
  const auto behind = [](const char *text) { return takeFormulas(text).formulas.at(0).punctuation; };
  EXPECT_EQ(behind("(there is no $I$.) So"), ".)");
  EXPECT_EQ(behind("(as [a](https://b) tells of $I$.) So"), ".)");
  EXPECT_EQ(behind("[a](https://b/$c$) so"), "");
  EXPECT_EQ(behind("[a](https://b/(c)/$d$) so"), "");
  EXPECT_EQ(behind("so $a$?"), "?");
  EXPECT_EQ(takeFormulas("(by $v[1](t)$ and $I$.)").formulas.at(1).punctuation, ".)");
}

INSTANTIATE_TEST_SUITE_P(Signs, Relations, testing::Values('=', '<', '>'));

TEST(Formulas, BesideASignThatIsNoRelation_StayTwo) {
  for (const char *text : {"so $a$ + $b$", "so $a$= $b$", "so $a$ =$b$", "so $a$ = b $c$", "so $a$\n= $b$"})
    EXPECT_EQ(takeFormulas(text).formulas.size(), 2U) << text;
}

TEST(NumberedEntities, WithNumbersOfCharacters_AreTheSameInBothBases) {
  RandomNumbers random(9);
  for (int i = 0; i < 200; ++i) {
    const auto code = static_cast<unsigned>(random.integer(0x20, 0x10FFFF));
    std::array<char, 16> hexadecimal{};
    std::snprintf(hexadecimal.data(), hexadecimal.size(), "&#x%X;", code);
    const std::string character = characterOfEntity("&#" + std::to_string(code) + ";");
    EXPECT_EQ(characterOfEntity(hexadecimal.data()), character) << code;
    EXPECT_FALSE(firstNoText(character)) << code;
    if (!utf8(code).empty() && !firstNoText(utf8(code))) {
      EXPECT_EQ(character, utf8(code));
    }
  }
}

using NamedCharacter = std::pair<std::string, std::string>;

class Entities : public testing::TestWithParam<NamedCharacter> {};

TEST_P(Entities, ByTheirNames_AreCharactersAndUnknownOnesStand) {
  EXPECT_EQ(characterOfEntity(GetParam().first), GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(Names, Entities,
                         testing::Values(NamedCharacter{"&nbsp;", "\u00A0"}, NamedCharacter{"&ne;", "≠"},
                                         NamedCharacter{"&quot;", "\""}, NamedCharacter{"&deg;", "°"},
                                         NamedCharacter{"&asymp;", "≈"}, NamedCharacter{"&X3C;", "&X3C;"},
                                         NamedCharacter{"&LT;", "&LT;"}, NamedCharacter{"&ltt;", "&ltt;"},
                                         NamedCharacter{"&;", "&;"}, NamedCharacter{"&#X2212;", "−"},
                                         NamedCharacter{"&#;", "\uFFFD"},
                                         NamedCharacter{"&#127;", "\uFFFD"}));

} // namespace
} // namespace halfspace
