#include "lessons/pseudo_language.h"
#include "lessons/words.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(PseudoLanguage, OfAText_HasAccentsAndBracketsAndIsAThirdLonger) {
  EXPECT_EQ(inPseudoLanguage("Undo"), "⟦Úndó ~~⟧");
  EXPECT_EQ(inPseudoLanguage("Drag a handle to move it, please."),
            "⟦Drág á hándlé tó móvé ít, pléásé. ~~~~~~~ ~~~~⟧");
}

TEST(PseudoLanguage, OfASentence_KeepsThePlacesToFill) {
  const test::SpokenToIn nobody(pseudoLanguage());
  EXPECT_EQ(words("{t} is negative", {{"t", "t = −1"}}), "⟦t = −1 ís négátívé ~~~~~⟧");
}

TEST(PseudoLanguage, OfWhatIsNoWords_KeepsTheLetters) {
  EXPECT_EQ(inPseudoLetters("Pictures (*.image), `code` and <p>more</p> of {name}"),
            "Píctúrés (*.image), `code` ánd <p>móré</p> óf {name}");
  EXPECT_EQ(inPseudoLetters("a brace { alone, and a < e"), "á brácé { álóné, ánd á < é");
}

TEST(PseudoLanguage, HasADecimalComma) { EXPECT_EQ(pseudoLanguage().decimalMark, ','); }

} // namespace
} // namespace halfspace
