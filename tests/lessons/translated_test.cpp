// Users are addressed in one language: nothing that the lessons' scenes come to, and no refusal, has a word
// or a number of another in it.
#include "tests/effort.h"
#include "tests/lessons/construction/construction_ids.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/test_name.h"
#include "tests/untranslated.h"

#include "lessons/lesson/lesson.h"
#include "lessons/pseudo_language.h"
#include "lessons/scene/change_words.h"
#include "lessons/scene/file/explain_formats.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/term/plain_text.h"
#include "lessons/text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

constexpr int scenesPerWriting = effort(20);

void expectTranslated(const std::string &text, const Names &names = {}) {
  EXPECT_EQ(untranslatedIn(text, names), std::vector<std::string>()) << text;
  EXPECT_FALSE(hasDecimalPoint(text)) << text;
}

void expectTranslated(const WorkingLine &line, const Names &names) {
  expectTranslated(line.sentence, names);
  for (const WrongTerm &mistake : line.mistakes)
    expectTranslated(replacedAll(mistake.sentence, "{answer}", "1"), names);
  EXPECT_FALSE(hasDecimalPoint(plainText(line))) << plainText(line);
  EXPECT_FALSE(hasDecimalPoint(latexOf(line))) << latexOf(line);
  expectTranslated(spoken(line), names);
}

/// Labels are LaTeX, in which words stand by themselves.
void expectTranslated(const Mark &mark) {
  static const std::regex wordsInLatex(R"(\\(?:text|mbox)\{([^{}]*)\})");
  for (const std::string &latex : {baseOf(mark).label, baseOf(mark).numbers, baseOf(mark).coordinates}) {
    EXPECT_FALSE(hasDecimalPoint(latex)) << latex;
    for (std::sregex_iterator words(latex.begin(), latex.end(), wordsInLatex), end; words != end; ++words)
      expectTranslated((*words)[1].str());
  }
}

void expectTranslated(const Evaluation &evaluation) {
  Names names{"it"};
  for (const EvaluatedEntry &entry : evaluation.entries)
    names.insert(entry.name);
  for (const EvaluatedEntry &entry : evaluation.entries) {
    SCOPED_TRACE(entry.name);
    expectTranslated(entry.missing, names);
    expectTranslated(entry.outcome->told->description, names);
    for (const std::string &id : entry.outcome->explanation->ids())
      expectTranslated(*entry.outcome->explanation->find(id), names);
    for (const SpecialCase &special : *entry.outcome->nearby)
      expectTranslated(special.sentence, names);
    for (const Crossing &crossing : entry.outcome->crossings->all)
      expectTranslated(crossing.name, names);
  }
  const Figure figure = figureOf(evaluation);
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    expectTranslated(figure.marks[i]);
  expectTranslated(explanationText("", evaluation), names);
}

class EveryConstructionTranslated : public testing::TestWithParam<std::string> {};

/// Objects that are not of a kind, are beyond its bounds or cannot be written so: what a scene file with one
/// of them is refused with.
const std::vector<std::string> &refusedEntries() {
  static const std::vector<std::string> all{
      R"({"name":"E","plain":1})",
      R"({"name":"1","point":[1,2,3]})",
      R"({"name":"Q","point":[1,2,3]})",
      R"({"name":"R","point":[1,2]})",
      R"({"name":"R","point":[1,2,"three"]})",
      R"({"name":"R","point":[1,2,9999999999]})",
      R"({"name":"R","point":[1,2,{}]})",
      R"({"name":"R","point":[1,2,3],"color":"mud"})",
      R"({"name":"F","plane":{"P0":[1,2,3],"n":[1,2,3],"m":[1,2,3]}})",
      R"({"name":"F","plane":{"P0":[1,2,3]}})",
      R"({"name":"F","number":{"value":9,"from":0,"to":5,"step":1}})",
      R"({"name":"S","sphere":{"c":[1,2,3],"R":-1}})",
      R"({"name":"R","point-on-plane":{"on":"Q","near":[1,2,3]}})",
      R"({"name":"R","point-on-plane":{"on":"Nobody","near":[1,2,3]}})",
      R"({"name":"M","mesh":{"corners":"0 0 0","faces":"0 1 2","at":[0,0,0],"k":1}})",
      R"({"name":"M","mesh":{"corners":"0 zero 0","faces":"0 1 2","at":[0,0,0],"k":1}})",
      R"({"name":"d","construction":"distance","of":{"E":"E"}})",
      R"({"name":"d","construction":"signed-distance","of":{"E":"Q","Q":"Q"}})",
      R"({"name":"d","construction":"signed-distance","of":{"E":"E"}})",
      R"({"name":"d","construction":"signed-distance","of":{"E":["E","F"],"Q":"Q"}})",
      R"({"name":"d","construction":"signed-distance","of":{"E":"E","Q":"Q","R":"Q"}})",
      R"({"name":"d","construction":"ray-plane-substitution","of":{"planes":[],"L":"Q"}})",
      R"({"name":"d","construction":"ray-plane-substitution","of":{"planes":["E","E"],"L":"Q"}})",
      R"({"name":"d","construction":"ray-solid-pluecker","of":{"K":"E","L":"Q"}})",
      R"({"name":"d","construction":"signed-distance","of":[]})",
      R"({"name":"d","construction":"signed-distance"})",
      R"(7)"};
  return all;
}

TEST(Translated, RefusalsOfScenes_SayNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  for (const std::string &entry : refusedEntries()) {
    SCOPED_TRACE(entry);
    const auto session =
        readSession(R"({"format":"halfspace","version":1,"lesson":"a","step":0,"scene":[)"
                    R"({"name":"E","plane":{"P0":[1,2,3],"n":[1,2,2]}},{"name":"Q","point":[1,2,3]},)" +
                        entry + "]}",
                    "a.halfspace");
    ASSERT_FALSE(session);
    EXPECT_EQ(untranslatedIn(session.problem().sentence, {"planes"}), std::vector<std::string>())
        << session.problem().sentence;
  }
}

TEST(Translated, RefusalsOfFiles_SayNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  for (const std::string file :
       {"", "{", "[]", R"({"format":"other"})", R"({"format":"halfspace","version":1000})",
        R"({"format":"halfspace","version":1})", R"({"format":"halfspace","version":1,"lesson":"A b"})",
        R"({"format":"halfspace","version":1,"lesson":"a","step":-1,"scene":[]})",
        R"({"format":"halfspace","version":1,"lesson":"a","step":0,"scene":7})",
        R"({"format":"halfspace","version":1,"lesson":"a","step":0,"scene":[],"more":1})",
        R"({"format":"halfspace","format":"halfspace"})", "\xFF"}) {
    const auto session = readSession(file, "a.halfspace");
    ASSERT_FALSE(session) << file;
    EXPECT_EQ(untranslatedIn(session.problem().sentence), std::vector<std::string>())
        << session.problem().sentence;
  }
}

TEST(Translated, RefusalsOfLabels_SayNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  const std::string tooLong = "{\"Q." + std::string(longestMarkId, 'n') + "\":{}}";
  for (const std::string &labels :
       {std::string("3"), std::string(R"({"X":{}})"), std::string(R"({"Q":{"at":1}})"),
        std::string(R"({"Q":{"at":[1,1000]}})"), std::string(R"({"Q":{"side":"top"}})"), tooLong}) {
    const auto session = readSession(
        R"({"format":"halfspace","version":5,"lesson":"a","step":0,"scene":[{"name":"Q","point":[1,2,3]}],)"
        R"("labels":)" +
            labels + "}",
        "a.halfspace");
    ASSERT_FALSE(session) << labels;
    expectTranslated(session.problem().sentence, {});
  }
  Scene hidden;
  hidden.labels["Q"] = {{}, true};
  for (const Scene &scene : {Scene(), hidden})
    for (const ChangeLabel &change : {ChangeLabel{"Q", {}}, ChangeLabel{"Q", LabelByHand{LabelSpot()}},
                                      ChangeLabel{"Q", LabelByHand{{}, true}}})
      expectTranslated(wordsForLabel(scene, change), {});
}

TEST(Translated, RefusalsOfEditsAndValues_SayNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  const Scene scene = distanceScene();
  for (const Edit &edit :
       {Edit(ChangeObject{"Q", PlaneObject{}}), Edit(ChangeObject{"nobody", PlaneObject{}}),
        Edit(AddEntry{0, {"Q", PointObject{}}}), Edit(RemoveEntry{"E"}), Edit(RenameEntry{"E", "Q"}),
        Edit(RebindRole{"E", "on", "Q"}), Edit(RebindRole{"Q", hostRole, "E"}),
        Edit(RebindRole{"distance", "E", "Q"}), Edit(MoveEntry{"distance", 0}),
        Edit(ChangeLabel{"nobody", LabelByHand{{}, true}})}) {
    const auto edited = apply(scene, edit);
    ASSERT_FALSE(edited);
    expectTranslated(edited.problem().sentence, {"distance"});
  }
  for (const std::string value : {"Q", "Z=1,2,3", "Q=1,2", "Q=1,2,three", "Q=1,2,99999999999"}) {
    const auto changed = withValue({"", 0, scene, {}}, value);
    ASSERT_FALSE(changed) << value;
    EXPECT_EQ(untranslatedIn(changed.problem().sentence), std::vector<std::string>())
        << changed.problem().sentence;
  }
}

TEST(Translated, WordsForChanges_SayNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    Names names;
    for (const Entry &entry : lesson.scene.entries)
      names.insert(entry.name);
    for (const Handle &handle : handlesOf(lesson.scene))
      expectTranslated(wordsForMoving(lesson.scene, handle), names);
    for (const CoordinateSpec &spec : findKind(NumberObject::kind)->coordinates)
      names.insert(std::string(spec.name));
    for (const CoordinateId &id : coordinatesOf(lesson.scene))
      expectTranslated(wordsForChanging(lesson.scene, id), names);
    expectTranslated(evaluate(lesson.scene));
  }
}

TEST_P(EveryConstructionTranslated, InAllItsCases_SaysNothingInEnglish) {
  const SpokenToIn nobody(pseudoLanguage());
  const Construction &construction = *findConstruction(GetParam());
  for (const Writing writing : {Writing::SmallIntegers, Writing::Decimals}) {
    RandomObjects random(20'240'000 + static_cast<std::uint64_t>(writing));
    for (int i = 0; i < scenesPerWriting && !HasFailure(); ++i)
      expectTranslated(evaluate(sceneOf(construction, random.objectsFor(construction, writing))));
  }
}

INSTANTIATE_TEST_SUITE_P(Words, EveryConstructionTranslated, testing::ValuesIn(constructionIds()), testName);

} // namespace
} // namespace halfspace
