// Random documents, written as JSON and as YAML: what is read of them, wherever they are broken.
#include "lessons/reading/document_builder.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using Kind = DocumentNode::Kind;
constexpr int depth = 6;

/// A document without a pattern; texts are such as JSON and YAML write alike in quotes.
DocumentNode randomNode(RandomNumbers &random, int levels) {
  static const std::vector<std::string> texts{"", "E", "1.50", "true", "größe", "a: b", "x # y", "[", " − "};
  DocumentNode node;
  const int choice = levels == 0 ? 0 : random.integer(0, 2);
  node.kind = choice == 0 ? Kind::Text : choice == 1 ? Kind::List : Kind::Map;
  if (node.kind == Kind::Text)
    node.text = texts.at(static_cast<std::size_t>(random.integer(0, int(texts.size()) - 1)));
  const int children = node.kind == Kind::Text ? 0 : random.integer(0, 4);
  for (int i = 0; i < children; ++i) {
    node.children.push_back(randomNode(random, levels - 1));
    if (node.kind == Kind::Map)
      node.children.back().key = "k" + std::to_string(i);
  }
  return node;
}

/// The document as JSON, which YAML reads too, with an end of a line before each child; the nodes learn their
/// lines.
void write(DocumentNode &node, std::string &text, int &line) {
  node.line = line;
  if (node.kind == Kind::Text) {
    text += '"' + node.text + '"';
    return;
  }
  text += node.kind == Kind::List ? '[' : '{';
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    text += i == 0 ? "\n " : ",\n ";
    ++line;
    text += node.kind == Kind::Map ? '"' + node.children[i].key + "\": " : "";
    write(node.children[i], text, line);
  }
  text += node.kind == Kind::List ? ']' : '}';
}

void expectSame(const DocumentNode &read, const DocumentNode &written, int firstLine) {
  EXPECT_EQ(read.kind, written.kind);
  EXPECT_EQ(read.key, written.key);
  EXPECT_EQ(read.text, written.text);
  EXPECT_EQ(read.line, written.line + firstLine - 1) << read.key;
  ASSERT_EQ(read.children.size(), written.children.size());
  for (std::size_t i = 0; i < read.children.size(); ++i)
    expectSame(read.children[i], written.children[i], firstLine);
}

TEST(Documents, OfAnyShape_AreReadAlikeFromJsonAndYaml) {
  RandomNumbers random(11);
  for (int i = 0; i < 200; ++i) {
    DocumentNode written = randomNode(random, 4);
    std::string text;
    int line = 1;
    write(written, text, line);
    SCOPED_TRACE(text);
    const auto json = parseJson(text, "a", depth);
    ASSERT_TRUE(json) << json.problem().text();
    expectSame(*json, written, 1);
    const auto yaml = parseYaml(text, "a", 20, depth);
    ASSERT_TRUE(yaml) << yaml.problem().text();
    expectSame(*yaml, written, 20);
  }
}

TEST(Json, CutOffAnywhere_IsRefusedOnALineThatItHas) {
  const std::string whole = "{\n\"a\": [1,\n true, \"x\\n\"],\n\"b\": {\"c\": null}}";
  ASSERT_TRUE(parseJson(whole, "a", depth));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string cut = whole.substr(0, size);
    const auto document = parseJson(cut, "a", depth);
    ASSERT_FALSE(document) << cut;
    EXPECT_LE(document.problem().line, lineAt(cut, size)) << cut;
    EXPECT_FALSE(document.problem().sentence.empty()) << cut;
  }
}

class NestedTo : public testing::TestWithParam<int> {};

TEST_P(NestedTo, ADepth_IsReadUpToThatDepthAndNoFarther) {
  const int levels = GetParam();
  std::string text = "1";
  for (int i = 0; i < levels; ++i)
    text = i % 2 == 0 ? "[" + text + "]" : "{\"a\": " + text + "}";
  EXPECT_TRUE(parseJson(text, "a", levels));
  EXPECT_TRUE(parseYaml(text, "a", 1, levels));
  for (const auto &refused : {parseJson(text, "a", levels - 1), parseYaml(text, "a", 1, levels - 1)}) {
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.problem().sentence.find("most " + std::to_string(levels - 1)), std::string::npos)
        << refused.problem().sentence;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, NestedTo, testing::Values(1, 2, 3, 8, 20));

TEST(DocumentBuilder, AfterSeveralProblems_TellsTheFirst) {
  DocumentBuilder builder("a", depth);
  EXPECT_FALSE(builder.refuse("first", 3));
  EXPECT_FALSE(builder.refuse("second", 4));
  const auto finished = builder.finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.problem().text(), "a:3: first");
}

TEST(DocumentBuilder, OfAMap_ExpectsAKeyBeforeEachValueAndAfterEachChild) {
  DocumentBuilder builder("a", depth);
  EXPECT_FALSE(builder.expectsKey()) << "nothing is open";
  ASSERT_TRUE(builder.open(Kind::Map, 1));
  EXPECT_TRUE(builder.expectsKey());
  ASSERT_TRUE(builder.key("list", 1));
  EXPECT_FALSE(builder.expectsKey());
  ASSERT_TRUE(builder.open(Kind::List, 2));
  EXPECT_FALSE(builder.expectsKey()) << "lists have none";
  ASSERT_TRUE(builder.close());
  EXPECT_TRUE(builder.expectsKey());
  ASSERT_TRUE(builder.close());
  const auto finished = builder.finish();
  ASSERT_TRUE(finished);
  ASSERT_NE(finished->find("list"), nullptr);
  EXPECT_EQ(finished->find("list")->line, 2);
}

TEST(LineAt, OfEveryPlace_IsOneMoreThanTheEndsOfLinesBeforeIt) {
  const std::string text = "\na\r\n\n\nb";
  for (std::size_t place = 0; place <= text.size(); ++place) {
    const std::string before = text.substr(0, place);
    EXPECT_EQ(lineAt(text, place), 1 + int(std::count(before.begin(), before.end(), '\n'))) << place;
  }
  EXPECT_EQ(lineAt(text, text.size()), 5);
}

} // namespace
} // namespace halfspace
