#include "lessons/lesson/macros.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Macro, OfABody_HasAsManyArgumentsAsItNames) {
  EXPECT_EQ(macroOf("\\mathbb{R}"), (Macro{0, "\\mathbb{R}"}));
  EXPECT_EQ(macroOf("#2+#1#2"), (Macro{2, "#2+#1#2"}));
  EXPECT_EQ(macroOf("\\#x"), (Macro{0, "\\#x"}));
  EXPECT_EQ(macroOf("\\#1"), (Macro{0, "\\#1"}));
  EXPECT_EQ(macroOf("\\\\#1"), (Macro{1, "\\\\#1"})) << "behind a backslash of its own";
  EXPECT_FALSE(macroOf("#"));
  EXPECT_FALSE(macroOf("a#b"));
  EXPECT_FALSE(macroOf("#0"));
}

TEST(Macro, InAFormula_StandsForItsBody) {
  const Macros macros{
      {"R", {0, "\\mathbb{R}"}}, {"inner", {2, "\\langle #1,#2\\rangle"}}, {"v", {1, "\\vec{#1}"}}};
  EXPECT_EQ(expanded("x\\in\\R^3", macros), "x\\in\\mathbb{R}^3");
  EXPECT_EQ(expanded("\\inner{a+b} c", macros), "\\langle {a+b},c\\rangle ");
  EXPECT_EQ(expanded("\\inner12", macros), "\\langle 1,2\\rangle ");
  EXPECT_EQ(expanded("\\v{\\v a}", macros), "\\vec{{\\vec{a}}}");
  EXPECT_EQ(expanded("\\v\\alpha\\v λ", macros), "\\vec{\\alpha}\\vec{λ}");
  EXPECT_EQ(expanded("\\Rx \\\\R \\{", macros), "\\Rx \\\\R \\{");
}

TEST(Macro, BehindACommand_DoesNotBecomePartOfIt) {
  const Macros macros{{"a", {0, "x"}}, {"b", {0, "\\beta"}}, {"v", {1, "\\vec#1y"}}};
  EXPECT_EQ(expanded("\\vec\\a", macros), "\\vec x");
  EXPECT_EQ(expanded("\\b\\a", macros), "\\beta x");
  EXPECT_EQ(expanded("\\v x", macros), "\\vec xy");
  EXPECT_EQ(expanded("\\v\\pi", macros), "\\vec\\pi y");
}

TEST(Macro, WithASignOfNumber_KeepsIt) {
  EXPECT_EQ(expanded("\\n 2", {{"n", *macroOf("\\#1")}}), "\\#1 2");
  EXPECT_EQ(expanded("\\n 2", {{"n", *macroOf("\\##1")}}), "\\#2");
  EXPECT_EQ(expanded("\\n", {{"n", *macroOf("a\\")}}), "a\\");
}

TEST(Macro, ThatLacksAnArgument_GetsNone) {
  EXPECT_EQ(expanded("a\\v", {{"v", {1, "\\vec{#1}"}}}), "a\\vec{}");
  EXPECT_EQ(expanded("a\\v{b", {{"v", {1, "\\vec #1"}}}), "a\\vec {b");
}

TEST(Macros, ThatUseThemselves_AreFound) {
  EXPECT_EQ(findRecursion({{"a", {0, "x\\a"}}}), "a");
  EXPECT_EQ(findRecursion({{"a", {0, "\\b"}}, {"b", {0, "\\c"}}, {"c", {0, "\\a"}}}), "a");
  EXPECT_EQ(findRecursion({{"a", {0, "\\b"}}, {"b", {0, "\\b"}}}), "b") << "a only leads there";
  EXPECT_EQ(findRecursion({{"a", {0, "\\ab\\\\a"}}, {"b", {0, "\\a\\a"}}}), std::nullopt);
}

TEST(Macros, ThatGrowWithoutMeasure_AreLeftAsTheyAre) {
  Macros macros;
  for (char name = 'a'; name < 'z'; ++name)
    macros[std::string(1, name)] = {0, std::string("\\") + static_cast<char>(name + 1) + "\\" +
                                           static_cast<char>(name + 1)};
  for (const char *last : {"x", ""}) {
    macros["z"] = {0, last};
    EXPECT_EQ(expanded("\\a", macros), "\\a");
  }
  EXPECT_EQ(expanded("\\a", {{"a", {0, "x\\a"}}}), "\\a");
}

} // namespace
} // namespace halfspace
