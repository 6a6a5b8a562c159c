#include "lessons/reading/document_builder.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr int depth = 8;

Problem jsonProblem(const std::string &text) {
  const auto document = parseJson(text, "a.halfspace", depth);
  EXPECT_FALSE(document) << text;
  return document ? Problem{} : document.problem();
}

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

TEST(Yaml, WithSomethingBehindItsEnd_IsRefused) {
  EXPECT_NE(yamlProblem("a: 1\n---\nb: 2\n").sentence.find("behind the end"), std::string::npos);
}

TEST(Yaml, WithAMapForAName_IsRefusedWhereItStands) { EXPECT_EQ(yamlProblem("a: 1\n{b: c}: 2\n").line, 11); }

TEST(Yaml, Values_AreTextsWhateverTheySpell) {
  const auto document = parseYaml("[1.50, true, '', \"a\\nb\"]", "a.md", 1, depth);
  ASSERT_TRUE(document);
  std::vector<std::string> texts;
  for (const DocumentNode &child : document->children) {
    EXPECT_EQ(child.kind, DocumentNode::Kind::Text);
    texts.push_back(child.text);
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"1.50", "true", "", "a\nb"}));
}

TEST(Json, Nodes_KnowTheirKindsAndLines) {
  const auto document = parseJson("{\n\"a\": 1,\n\"b\": [\"1\",\n true, null],\n\"c\": {}}", "a", depth);
  ASSERT_TRUE(document);
  using Kind = DocumentNode::Kind;
  EXPECT_EQ(document->find("a")->kind, Kind::Number);
  EXPECT_EQ(document->find("a")->line, 2);
  const DocumentNode &list = *document->find("b");
  EXPECT_EQ(list.kind, Kind::List);
  EXPECT_EQ(list.children.at(0).kind, Kind::Text);
  EXPECT_EQ(list.children.at(1).kind, Kind::Literal);
  EXPECT_EQ(list.children.at(1).line, 4);
  EXPECT_EQ(list.children.at(2).text, "null");
  EXPECT_EQ(document->find("c")->kind, Kind::Map);
  EXPECT_EQ(document->find("c")->line, 5);
  EXPECT_EQ(list.find("a"), nullptr) << "a list has no keys";
  EXPECT_EQ(parseJson("{\"a\": 1\n}", "a", depth)->find("a")->line, 1) << "a number that ends its line";
}

TEST(Json, ThatIsDamaged_NamesTheLine) {
  EXPECT_EQ(jsonProblem("{\"a\": 1,\n\"b\" 2}").line, 2);
  EXPECT_EQ(jsonProblem("{\n\n\"a\": [1, 2").line, 3);
  EXPECT_EQ(jsonProblem("{\"a\": 1} x").file, "a.halfspace");
  EXPECT_EQ(jsonProblem("{\n\"a\": 1,\n\"a\": 2}").line, 3) << "a key twice";
}

TEST(Json, WithBytesThatAreNoText_NamesTheLine) {
  EXPECT_EQ(jsonProblem("{\n\"a\": \"\xff\"}").line, 2);
  EXPECT_EQ(jsonProblem(std::string("{}\n\0", 4)).line, 2) << "a zero byte does not end it";
}

TEST(Json, NestedTooDeeply_IsRefused) {
  EXPECT_TRUE(parseJson(std::string(8, '[') + std::string(8, ']'), "a", depth));
  EXPECT_NE(jsonProblem(std::string(9, '[') + std::string(9, ']')).sentence.find("too deeply"),
            std::string::npos);
  jsonProblem(std::string(50000, '['));
}

TEST(Json, WithANumberBeyondAll_IsRefusedAsTooLarge) {
  EXPECT_NE(jsonProblem("[1,\n1e999]").sentence.find("too large"), std::string::npos);
}

/// Lists of ones, so many in all.
std::string ones(std::size_t count) {
  std::string text = "[1";
  for (std::size_t i = 1; i < count; ++i)
    text += ",1";
  return text + "]";
}

TEST(Document, OfVeryManyValues_IsReadUpToTheLimit) {
  EXPECT_TRUE(parseJson(ones(maxDocumentNodes - 1), "a", depth)); // the list is one too
  EXPECT_NE(jsonProblem(ones(maxDocumentNodes)).sentence.find("too much"), std::string::npos);
}

TEST(Document, OfVeryManyFields_IsReadUpToTheLimit) {
  const auto fields = [](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
      text += "k" + std::to_string(i) + ": 1\n";
    return text;
  };
  EXPECT_TRUE(parseYaml(fields(maxMapKeys), "a.md", 1, depth));
  EXPECT_EQ(yamlProblem(fields(maxMapKeys + 1)).line, 10 + int(maxMapKeys));
}

TEST(Problem, ToldAsText_LeavesOutWhatIsNotKnown) {
  EXPECT_EQ((Problem{"It is torn.", "a.md", 3, "scene[1].n"}.text()), "a.md:3: scene[1].n: It is torn.");
  EXPECT_EQ((Problem{"It is torn.", "a.md", 0, ""}.text()), "a.md: It is torn.");
  EXPECT_EQ((Problem{"It is torn.", "", 0, "n"}.text()), "n: It is torn.");
  EXPECT_EQ((Problem{"It is torn.", "", 0, ""}.text()), "It is torn.");
}

} // namespace
} // namespace halfspace
