// Fields of a document: what is read of them, and what is said of those that cannot be.
#include "lessons/reading/document.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// A map that was read from YAML, and its reader as a part `scene[1]` of a file.
struct FieldReading : testing::Test {
  FieldReader &read(const std::string &yaml) {
    auto parsed = parseYaml(yaml, "a.md", 1, 8);
    EXPECT_TRUE(parsed) << yaml;
    m_document = *parsed;
    return m_reader.emplace(m_document, "a.md", "scene[1]");
  }
  /// The problem of the reader; one without a sentence where there is none.
  [[nodiscard]] Problem problem() const { return m_reader->problem().value_or(Problem{}); }

private:
  DocumentNode m_document;
  std::optional<FieldReader> m_reader;
};

TEST_F(FieldReading, OfALaterFault_StillGivesTheFieldsBeforeIt) {
  FieldReader &fields = read("name: E\ntitle: [a]");
  (void)fields.text("title");
  EXPECT_EQ(fields.text("name"), "E");
  EXPECT_EQ(problem().field, "scene[1].title");
}

TEST_F(FieldReading, OfTextsThatAreThere_GivesThem) {
  FieldReader &fields = read("name: E\ntitle: ''");
  EXPECT_EQ(fields.text("name"), "E");
  EXPECT_EQ(fields.text("title", "none"), "") << "an empty text is one";
  EXPECT_EQ(fields.text("sources", "none"), "none");
  EXPECT_FALSE(fields.problem());
}

TEST_F(FieldReading, OfAMissingField_NamesItByItsFullPath) {
  EXPECT_EQ(read("\n\nname: E").text("plane"), "");
  EXPECT_EQ(problem().field, "scene[1].plane");
  EXPECT_EQ(problem().file, "a.md");
  EXPECT_EQ(problem().line, 3) << "where the map begins";
}

TEST_F(FieldReading, OfAListWhereATextIsExpected_TellsItsLine) {
  EXPECT_EQ(read("name: E\ntitle: [a, b]").text("title", "fallback"), "");
  EXPECT_EQ(problem().line, 2);
  EXPECT_NE(problem().sentence.find("text is expected"), std::string::npos);
}

TEST_F(FieldReading, OfAVeryLongText_StopsAtTheLimit) {
  EXPECT_EQ(read("a: " + std::string(maxFieldText, 'x')).text("a").size(), maxFieldText);
  EXPECT_FALSE(problem().line);
  EXPECT_EQ(read("a: " + std::string(maxFieldText + 1, 'x')).text("a"), "");
  EXPECT_NE(problem().sentence.find("4000"), std::string::npos) << problem().sentence;
}

TEST_F(FieldReading, OfSeveralFaults_KeepsTheFirst) {
  FieldReader &fields = read("b: [1]");
  (void)fields.text("a");
  (void)fields.text("b");
  fields.allowOnly({});
  EXPECT_EQ(problem().field, "scene[1].a");
}

TEST_F(FieldReading, OfUnknownKeys_NamesTheFirstWithItsLine) {
  FieldReader &fields = read("name: E\nplan: x\npoint: y");
  fields.allowOnly({"name", "plane", "point"});
  EXPECT_EQ(problem().field, "scene[1].plan");
  EXPECT_EQ(problem().line, 2);
}

TEST_F(FieldReading, OfKnownKeys_LetsSomeBeMissing) {
  read("name: E").allowOnly({"name", "plane"});
  EXPECT_EQ(problem().sentence, "");
}

TEST_F(FieldReading, OfAListWhereFieldsAreExpected_IsRefused) {
  read("[name, E]").allowOnly({"name"});
  EXPECT_EQ(problem().field, "scene[1]");
}

TEST_F(FieldReading, AtTheTopOfAFile_NamesTheFieldAlone) {
  const DocumentNode empty{DocumentNode::Kind::Map, "", "", {}, 1};
  FieldReader fields(empty, "a.md", "");
  (void)fields.text("title");
  EXPECT_EQ(fields.problem()->field, "title");
}

struct IntegerField {
  const char *yaml;
  std::optional<int> value; ///< nothing: a problem
};

struct WholeNumbers : FieldReading, testing::WithParamInterface<IntegerField> {};

TEST_P(WholeNumbers, BetweenTheirBounds_AreReadAndOthersRefused) {
  const int value = read(GetParam().yaml).integer("n", -2, 10);
  EXPECT_EQ(value, GetParam().value.value_or(-2));
  EXPECT_EQ(problem().sentence.empty(), GetParam().value.has_value()) << problem().sentence;
}

INSTANTIATE_TEST_SUITE_P(Spelled, WholeNumbers,
                         testing::Values(IntegerField{"n: 7", 7}, IntegerField{"n: -2", -2},
                                         IntegerField{"n: 10", 10}, IntegerField{"n: 11", {}},
                                         IntegerField{"n: -3", {}}, IntegerField{"n: 7.0", {}},
                                         IntegerField{"n: seven", {}}, IntegerField{"n: 7 8", {}},
                                         IntegerField{"n: ''", {}}, IntegerField{"n: [7]", {}},
                                         IntegerField{"n: 99999999999999999999", {}},
                                         IntegerField{"m: 7", {}}));

TEST_F(FieldReading, OfAMissingNumber_GivesTheFallback) {
  EXPECT_EQ(read("m: 1").integer("n", 0, 9, 4), 4);
  EXPECT_EQ(problem().sentence, "");
}

TEST_F(FieldReading, OfANumberOutOfBounds_TellsThem) {
  (void)read("n: 99").integer("n", -2, 10);
  EXPECT_NE(problem().sentence.find("-2 to 10"), std::string::npos) << problem().sentence;
}

TEST_F(FieldReading, OfATruthValueInJson_IsNoWholeNumber) {
  const auto document = parseJson("{\"n\": true, \"m\": 3, \"k\": \"3\"}", "a", 8);
  ASSERT_TRUE(document);
  FieldReader fields(*document, "a", "");
  EXPECT_EQ(fields.integer("m", 0, 9), 3);
  EXPECT_EQ(fields.integer("k", 0, 9), 3) << "a spelled number is one";
  EXPECT_FALSE(fields.problem());
  (void)fields.integer("n", 0, 9);
  EXPECT_TRUE(fields.problem());
}

TEST_F(FieldReading, OfATruthValue_TakesTrueAndFalseAlone) {
  EXPECT_TRUE(read("a: true").truth("a", false));
  EXPECT_FALSE(read("a: false").truth("a", true));
  EXPECT_TRUE(read("b: false").truth("a", true)) << "what is missing is as it is without the field";
  EXPECT_EQ(problem().sentence, "");
  for (const char *value : {"no", "True", "0", "''", "[false]", "{false: 1}"}) {
    (void)read(std::string("a: ") + value).truth("a", true);
    EXPECT_EQ(problem().field, "scene[1].a") << value;
    EXPECT_NE(problem().sentence.find("true or false"), std::string::npos) << value;
  }
}

struct LessonIds : FieldReading, testing::WithParamInterface<std::pair<std::string, bool>> {};

TEST_P(LessonIds, OfSmallLettersDigitsAndHyphens_AreTakenAndOthersRefused) {
  (void)read("id: \"" + GetParam().first + "\"").lessonId("id");
  EXPECT_EQ(problem().sentence.empty(), GetParam().second) << problem().sentence;
}

INSTANTIATE_TEST_SUITE_P(Spelled, LessonIds,
                         testing::Values(std::pair("signed-distance", true), std::pair("step2", true),
                                         std::pair(std::string(64, 'a'), true),
                                         std::pair(std::string(65, 'a'), false), std::pair("", false),
                                         std::pair("Distance", false), std::pair("a b", false),
                                         std::pair("../etc", false), std::pair("größe", false)));

} // namespace
} // namespace halfspace
