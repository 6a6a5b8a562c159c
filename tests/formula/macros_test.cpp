#include "tests/formula/described.h"

#include <gtest/gtest.h>

namespace halfspace::math {
namespace {

TEST(Macros, AnAbbreviation_StandsForItsBody) {
  const Macros macros{{"R", {0, "\\mathbb{R}"}}};
  EXPECT_EQ(read("x\\in\\R^3", macros), read("x\\in\\mathbb{R}^3"));
}

TEST(Macros, Arguments_ArePutIn) {
  const Macros macros{{"inner", {2, "\\langle #1,#2\\rangle"}}};
  EXPECT_EQ(read("\\inner{a+b}c", macros), read("\\langle a+b,c\\rangle"));
}

TEST(Macros, AnArgument_MayUseTheMacroItself) {
  const Macros macros{{"v", {1, "\\vec{#1}"}}};
  EXPECT_EQ(read("\\v{\\v a}", macros), read("\\vec{\\vec{a}}"));
}

TEST(Macros, Macros_MayUseOthers) {
  const Macros macros{{"a", {0, "\\b x\\b"}}, {"b", {0, "\\beta"}}};
  EXPECT_EQ(read("\\a", macros), read("\\beta x\\beta"));
}

TEST(Macros, AMacro_HidesACommand) {
  EXPECT_EQ(read("\\vec x", {{"vec", {1, "\\mathbf{#1}"}}}), read("\\mathbf{x}"));
}

TEST(Macros, Tables_MayBeMadeByThem) {
  const Macros macros{{"col", {2, "\\begin{pmatrix}#1\\\\#2\\end{pmatrix}"}}};
  EXPECT_EQ(read("\\col12", macros), read("\\begin{pmatrix}1\\\\2\\end{pmatrix}"));
}

TEST(Macros, WhatIsWrongInABody_IsToldAtItsUse) {
  EXPECT_EQ(read("xy\\bad", {{"bad", {0, "\\foo"}}}), "error 3: `\\foo` is unknown.");
  EXPECT_EQ(read("x\\bad", {{"bad", {0, "a\xFF"}}}),
            "error 2: In the macro `\\bad`: This byte is no character: the text is not UTF-8.");
}

TEST(Macros, AMissingArgument_IsTold) {
  const Macros macros{{"v", {1, "\\vec{#1}"}}};
  EXPECT_EQ(read("a\\v", macros), "error 2: `\\v` lacks an argument.");
  EXPECT_EQ(read("{\\v}", macros), "error 2: `\\v` lacks an argument.");
}

TEST(Macros, AMacroThatUsesItself_IsRefused) {
  EXPECT_EQ(read("a\\a", {{"a", {0, "x\\a"}}}), "error 2: This formula is too long.");
  EXPECT_EQ(read("\\a", {{"a", {0, "\\b"}}, {"b", {0, "\\c"}}, {"c", {0, "\\a"}}}),
            "error 1: `\\c` becomes too long.");
  EXPECT_EQ(read("\\d", {{"d", {0, "\\a"}}, {"a", {0, "\\a"}}}), "error 1: `\\a` becomes too long.");
}

TEST(Macros, AnUnusedMacroThatUsesItself_HarmsNobody) { EXPECT_EQ(read("x", {{"a", {0, "\\a"}}}), "x"); }

TEST(Macros, ExplosiveBodies_AreRefusedInsteadOfTakingForEver) {
  for (const char *last : {"x", ""}) {
    Macros macros;
    for (char name = 'a'; name < 'z'; ++name)
      macros[std::string(1, name)] = {0, std::string("\\") + static_cast<char>(name + 1) + "\\" +
                                             static_cast<char>(name + 1)};
    macros["z"] = {0, last};
    EXPECT_NE(read("\\a", macros).find("error 1:"), std::string::npos);
  }
}

} // namespace
} // namespace halfspace::math
