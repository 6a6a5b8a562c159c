#include "lessons/reading/document.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr int depth = 8;

Problem yamlProblem(const std::string &text) {
  const auto document = parseYaml(text, "a.md", 10, depth);
  EXPECT_FALSE(document) << text;
  return document ? Problem{} : document.problem();
}

TEST(Yaml, Nodes_KnowTheirLinesInTheFile) {
  const auto document = parseYaml("a: 1\nb:\n  - x\n  - {c: 2}\n", "a.md", 10, depth);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->find("a")->text, "1");
  EXPECT_EQ(document->find("a")->line, 10);
  EXPECT_EQ(document->find("b")->children.at(1).find("c")->line, 13);
}

TEST(Yaml, WithReferences_IsRefusedSoThatItCannotGrow) {
  const Problem bomb = yamlProblem("a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n");
  EXPECT_NE(bomb.sentence.find("References"), std::string::npos);
  EXPECT_EQ(bomb.line, 11);
}

TEST(Yaml, NestedTooDeeply_IsRefused) {
  EXPECT_NE(yamlProblem(std::string(9, '[') + std::string(9, ']')).sentence.find("too deeply"),
            std::string::npos);
  EXPECT_TRUE(parseYaml(std::string(8, '[') + std::string(8, ']'), "a.md", 1, depth));
  yamlProblem(std::string(50000, '['));
  yamlProblem(std::string(50000, '{'));
}

TEST(Yaml, WithABrokenLine_NamesTheLine) {
  EXPECT_EQ(yamlProblem("a: 1\nb: [1, 2\n").file, "a.md");
  EXPECT_GE(yamlProblem("a: 1\nb: [1, 2\n").line, 11);
  yamlProblem("a: \"open");
  yamlProblem("? [a]\n: b");
  yamlProblem("");
}

TEST(Yaml, WithAKeyTwice_IsRefused) { EXPECT_EQ(yamlProblem("a: 1\na: 2\n").line, 11); }

TEST(Json, ThatLeavesAKeyWithoutAValue_IsRefused) { EXPECT_FALSE(parseJson("{\"a\":", "a", depth)); }

TEST(Json, Numbers_KeepTheirSpelling) {
  const auto document = parseJson("[0.10, 18446744073709551616, -3]", "a", depth);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->children[0].text, "0.10");
  EXPECT_EQ(document->children[1].text, "18446744073709551616");
  EXPECT_EQ(document->children[2].text, "-3");
}

} // namespace
} // namespace halfspace
