// Characters that are typed instead of commands: what they mean to a formula.
#include "widgets/formula/latex_symbols.h"

#include "widgets/formula/latex_commands.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace::math {
namespace {

struct Meaning {
  char32_t typed;
  char32_t character;
  AtomClass atomClass;
};

struct TypedSymbols : testing::TestWithParam<Meaning> {};

TEST_P(TypedSymbols, AreTheCharactersAndClassesOfMathematics) {
  const TypedSymbol symbol = typedSymbol(GetParam().typed);
  EXPECT_EQ(symbol.character, GetParam().character);
  EXPECT_EQ(symbol.atomClass, GetParam().atomClass);
}

INSTANTIATE_TEST_SUITE_P(
    OnAKeyboard, TypedSymbols,
    testing::Values(Meaning{'-', U'−', AtomClass::Bin}, Meaning{'*', U'∗', AtomClass::Bin},
                    Meaning{'=', '=', AtomClass::Rel}, Meaning{'(', '(', AtomClass::Open},
                    Meaning{')', ')', AtomClass::Close}, Meaning{',', ',', AtomClass::Punct},
                    Meaning{'/', '/', AtomClass::Ord}, Meaning{'7', '7', AtomClass::Ord},
                    Meaning{'x', 'x', AtomClass::Ord}));

INSTANTIATE_TEST_SUITE_P(
    FromUnicode, TypedSymbols,
    testing::Values(Meaning{U'·', U'⋅', AtomClass::Bin}, Meaning{U'≤', U'≤', AtomClass::Rel},
                    Meaning{U'∈', U'∈', AtomClass::Rel}, Meaning{U'×', U'×', AtomClass::Bin},
                    Meaning{U'→', U'→', AtomClass::Rel}, Meaning{U'⟨', U'⟨', AtomClass::Open},
                    Meaning{U'∞', U'∞', AtomClass::Ord}, Meaning{U'ж', U'ж', AtomClass::Ord}));

TEST(TypedScripts, AboveAndBelow_StandForTheirPlainCharacters) {
  const auto above = typedScript(U'⁻');
  ASSERT_TRUE(above);
  EXPECT_TRUE(above->isAbove);
  EXPECT_EQ(above->character, U'−');
  const auto below = typedScript(U'ₙ');
  ASSERT_TRUE(below);
  EXPECT_FALSE(below->isAbove);
  EXPECT_EQ(below->character, U'n');
}

TEST(TypedScripts, OfAllDigits_AreThereBothWays) {
  const std::u32string_view above = U"⁰¹²³⁴⁵⁶⁷⁸⁹";
  for (char32_t digit = 0; digit < 10; ++digit) {
    EXPECT_EQ(typedScript(above[digit])->character, U'0' + digit);
    EXPECT_EQ(typedScript(U'₀' + digit)->character, U'0' + digit);
  }
}

TEST(TypedScripts, OfPlainCharacters_AreNone) {
  for (const char32_t plain : {U'2', U'n', U'+', U'λ'})
    EXPECT_FALSE(typedScript(plain));
}

TEST(Fences, AreBracketsBarsAndArrowsUpright) {
  for (const char32_t fence : std::u32string_view(U"()[]{}|‖/⟨⟩⌊⌉↑⇕"))
    EXPECT_TRUE(isFence(fence)) << static_cast<unsigned>(fence);
  for (const char32_t other : std::u32string_view(U"x<>→=.,"))
    EXPECT_FALSE(isFence(other)) << static_cast<unsigned>(other);
}

TEST(Negations, OfRelations_AreCharactersOfTheirOwnWhereUnicodeHasThem) {
  EXPECT_EQ(negated('='), U'≠');
  EXPECT_EQ(negated(U'∈'), U'∉');
  EXPECT_EQ(negated(U'⊆'), U'⊈');
  EXPECT_EQ(negated(U'⟂'), 0U);
  EXPECT_EQ(negated('x'), 0U);
}

TEST(Names, OfCommandsAndSymbols_AreFoundExactlyAndEachOnce) {
  for (const SymbolCommand &command : symbolCommands())
    EXPECT_EQ(symbolNamed(command.name), &command) << command.name;
  for (const Command &command : commands())
    EXPECT_EQ(commandNamed(command.name), &command) << command.name;
  for (const char *unknown : {"", "cdo", "cdott", "CDOT", "zzz"}) {
    EXPECT_EQ(symbolNamed(unknown), nullptr) << unknown;
    EXPECT_EQ(commandNamed(unknown), nullptr) << unknown;
  }
}

} // namespace
} // namespace halfspace::math
