#include "lessons/pseudo_language.h"
#include "lessons/words.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(PseudoLanguage, OfAText_IsInBracketsAndAThirdLonger) {
  EXPECT_EQ(inPseudoLanguage("Undo"), "⟦Undo ~~⟧");
  EXPECT_EQ(inPseudoLanguage("Drag a handle to move it, please."),
            "⟦Drag a handle to move it, please. ~~~~~~~ ~~~~⟧");
}

TEST(PseudoLanguage, OfASentence_KeepsThePlacesToFill) {
  const test::SpokenToIn nobody(pseudoLanguage());
  EXPECT_EQ(words("{t} is negative", {{"t", "t = −1"}}), "⟦t = −1 is negative ~~~~~⟧");
}

TEST(PseudoLanguage, HasADecimalComma) { EXPECT_EQ(pseudoLanguage().decimalMark, ','); }

} // namespace
} // namespace halfspace
