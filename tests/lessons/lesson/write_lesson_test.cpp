// Drafts written as lessons: what is read back is what was written.
#include "lessons/lesson/write_lesson.h"

#include "lessons/lesson/condition.h"
#include "lessons/lesson/draft_of_lesson.h"
#include "lessons/lesson/explore.h"
#include "lessons/lesson/lesson.h"
#include "lessons/lesson/shown.h"
#include "lessons/text.h"
#include "lessons/typed/typed_scene.h"
#include "tests/effort.h"
#include "tests/lessons/scene/random_edits.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

const CameraView view{{0, -1, 0.5}, {1, 2, 3.25}, 12};

Lesson readBack(const LessonDraft &draft, const Scene &scene) {
  const std::string text = writeLesson(draft, scene, view).text;
  auto lesson = parseLesson(text, "a.md");
  EXPECT_TRUE(lesson) << lesson.problem().text() << "\n" << text;
  return lesson ? *lesson : Lesson();
}

const DraftQuestion whichSide{
    "On which side?", "side", {{"positive", "There: $\\nu$"}, {"otherwise", "Elsewhere"}}, "It's so."};

LessonDraft everything() {
  return {
      "mine",
      "Mine: 'a' \"b\" #c",
      {{"One", "Words of $f(Q)$, {f}.\n\n### A heading\n\n```\n## code\n```", {"distance"}, {"E"}, whichSide},
       {"Two", "", {}, {}, {}, DraftTask{"Drag Q.\n\n- there\n- or there", "side = negative and f < -1/2"}}}};
}

TEST(WriteLesson, ADraftWithEverything_IsReadBack) {
  const LessonDraft draft = everything();
  EXPECT_TRUE(problemsOf(draft).empty());
  const Lesson lesson = readBack(draft, test::distanceScene());
  EXPECT_EQ(draftOf(lesson), draft);
  EXPECT_EQ(lesson.scene, test::distanceScene());
  EXPECT_EQ(lesson.camera, view);
  EXPECT_TRUE(tasksOf(lesson.steps[1]).front().conditions ==
              *parseConditions(draft.steps[1].task->condition));
}

TEST(DraftOf, ALessonThatSaysMoreThanADraft_IsNothing) {
  const std::string text = writeLesson(everything(), test::distanceScene(), view).text;
  const auto draftIn = [](const std::string &lesson) { return draftOf(*parseLesson(lesson, "a.md")); };
  EXPECT_EQ(draftIn(text), everything());
  EXPECT_EQ(draftIn(text + "\n```note\nA note\nOf something.\n```\n"), std::nullopt);
  EXPECT_EQ(draftIn(replacedAll(text, "distance.*", "distance.f")), std::nullopt);
  EXPECT_EQ(draftIn(replacedAll(text, "\n---\n## One", "\nsources: [PG 3.4]\n---\n## One")), std::nullopt);
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    EXPECT_EQ(draftOf(lesson), std::nullopt) << lesson.id;
}

TEST(WriteLesson, ASimpleLesson_ReadsAsSomebodyWouldWriteIt) {
  const LessonDraft draft{"mine", "How far?", {{"The side", "Look at $Q$.", {"distance"}, {"E"}}}};
  EXPECT_EQ(writeLesson(draft, test::distanceScene(), view).text,
            "---\nid: mine\ntitle: How far?\nscene:\n"
            "  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}\n"
            "  - {name: Q, point: [11, 15, 8]}\n"
            "  - {name: distance, construction: signed-distance, of: {E: E, Q: Q}}\n"
            "camera: {from: [0, -1, 0.5], at: [1, 2, 3.25], height: 12}\n---\n"
            "## The side\n\nLook at $Q$.\n\n"
            "```lines\ndistance.*\n```\n\n```draw\nall\n```\n\n```hide\nE\n```\n");
}

TEST(WriteLesson, StepsOfItsLines_AreTold) {
  const WrittenLesson written = writeLesson(everything(), test::distanceScene(), view);
  EXPECT_FALSE(written.stepAt(written.stepLines[0] - 1));
  EXPECT_EQ(written.stepAt(written.stepLines[0]), 0U);
  EXPECT_EQ(written.stepAt(written.stepLines[1] - 1), 0U);
  EXPECT_EQ(written.stepAt(written.stepLines[1]), 1U);
  const Lesson lesson = readBack(everything(), test::distanceScene());
  EXPECT_EQ(written.stepAt(tasksOf(lesson.steps[1]).front().conditionsLine), 1U);
  EXPECT_EQ(written.stepAt(predictionOf(lesson.steps[0])->valueLine), 0U);
}

TEST(WriteLesson, AStep_ShowsWhatExploreDoes_ButWhatItHides) {
  LessonDraft draft{"mine", "Mine", {{"One", "", {"distance"}}}};
  const Evaluation all = evaluate(test::distanceScene());
  EXPECT_EQ(shownIn(readBack(draft, test::distanceScene()).steps[0], all).figure.marks,
            shownIn(stepShowing({"distance"}), all).figure.marks);
  draft.steps[0].workings = {};
  EXPECT_EQ(shownIn(readBack(draft, test::distanceScene()).steps[0], all).figure.marks,
            shownIn(stepShowing({}), all).figure.marks);
  draft.steps[0].hidden = {"distance"};
  EXPECT_EQ(findMark(shownIn(readBack(draft, test::distanceScene()).steps[0], all).figure, "distance.F"),
            nullptr);
}

/// Pieces of which YAML or Markdown could make something else.
class NastyTexts {
public:
  explicit NastyTexts(std::uint64_t seed) : m_engine(seed) {}

  std::string next(std::size_t longest) {
    static const std::vector<std::string> pieces{
        "'",    "\"",   ": ",  " #", "`",   "```", "~~~", "```task\n", "## ", "# ",  "\n",   "\n\n",
        "- ",   "{f}",  "$x$", "\\", "---", "%",   "@",   "&a",        "*b",  "!",   "|",    ">",
        "é",    "\t",   "  ",  ",",  "[",   "]",   "{",   "}",         "x",   "so ", "null", "true",
        "\r\n", "\n  ", "\n ", "1",  "...", "? ",  "~",   "<b>",       "’"};
    std::string text;
    for (auto count = below(longest + 1); count > 0; --count)
      text += pieces[below(pieces.size())];
    return text;
  }
  std::size_t below(std::size_t end) { return m_engine() % end; }

private:
  std::mt19937_64 m_engine;
};

LessonDraft nastyDraft(NastyTexts &texts) {
  DraftStep step{texts.next(4), texts.next(6)};
  if (texts.below(2) == 0)
    step.workings = {"distance"};
  if (texts.below(2) == 0)
    step.hidden = {"Q", "distance"};
  if (texts.below(2) == 0)
    step.question = DraftQuestion{
        texts.next(6), "side", {{"positive", texts.next(5)}, {"negative", texts.next(5)}}, texts.next(6)};
  if (texts.below(2) == 0)
    step.task = DraftTask{texts.next(8), "side = negative"};
  return {"mine", texts.next(4), {step, {"Two", texts.next(6)}}};
}

TEST(WriteLesson, NastyTexts_AreRefusedOrReadBack) {
  NastyTexts texts(7);
  int written = 0;
  int refused = 0;
  for (int i = 0; i < test::effort(20000); ++i) {
    const LessonDraft draft = nastyDraft(texts);
    const auto problems = problemsOf(draft);
    for (const DraftProblem &problem : problems)
      EXPECT_FALSE(problem.sentence.empty());
    if (!problems.empty()) {
      ++refused;
      continue;
    }
    ++written;
    const Lesson lesson = readBack(draft, test::distanceScene());
    ASSERT_EQ(draftOf(lesson), tidied(draft)) << writeLesson(draft, test::distanceScene(), view).text;
  }
  EXPECT_GT(written, test::atLeast(2000));
  EXPECT_GT(refused, test::atLeast(2000));
}

TEST(WriteLesson, ScenesAtRandom_AreReadBack) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::RandomEdits random(seed);
    Scene scene = test::distanceScene();
    for (int i = 0; i < test::effort(200); ++i) {
      const Edit edit = random.next(scene);
      const auto after = apply(scene, edit);
      if (!after)
        continue;
      scene = *after;
      Scene withoutLabels = scene;
      withoutLabels.labels.clear();
      ASSERT_EQ(readBack({"mine", "Mine", {{"One", ""}}}, scene).scene, withoutLabels);
    }
  }
}

TEST(WriteLesson, FormulasLooksAndOddNames_AreReadBack) {
  const auto scene =
      readTypedScene("k = 3/2, 0 <= k <= 5, step 1/2\nA = (1, -2/3, 0.5), green, locked\n"
                     "B = (k, 2k - 1, A.x)\nM = (A + B)/2, pink\nE: x + 2y - 2z = 27, hidden\n"
                     "null = 3\ntrue = 1/7\nS = sphere(M, 2k)\nd = distance(M, E)\nv = d.F - A\n",
                     "typed");
  ASSERT_TRUE(scene) << scene.problem().text();
  EXPECT_EQ(readBack({"mine", "null", {{"null", "null"}}}, *scene).scene, *scene);
}

TEST(DraftProblems, WhatIsMissing_IsToldWithItsStep) {
  EXPECT_EQ(problemsOf({"mine", "", {}}).size(), 2U) << "a title, a step";
  LessonDraft draft = everything();
  draft.steps[1].task->condition = " ";
  draft.steps[1].title = "\n";
  const auto problems = problemsOf(draft);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].step, 1U);
  EXPECT_EQ(problems[0].sentence, "The step has no title.");
  EXPECT_EQ(problems[1].sentence, "The task does not say when it is done.");
}

TEST(DraftProblems, WordsThatWouldBeSomethingElse_AreToldWhy) {
  const auto sentence = [](const std::string &words) {
    const auto problems = problemsOf({"mine", "Mine", {{"One", words}}});
    return problems.empty() ? std::string() : problems.front().sentence;
  };
  EXPECT_EQ(sentence("Words\n### Heading\n\n- a list\n\n```\n## code\n```"), "");
  EXPECT_NE(sentence("Words\n## Heading").find("add one"), std::string::npos);
  EXPECT_NE(sentence("Words\n```\ncode").find("never closed"), std::string::npos);
  EXPECT_NE(sentence("```hide\nE\n```").find("instruction"), std::string::npos);
  EXPECT_NE(sentence("```lines\nnone\n```").find("instruction"), std::string::npos);
  EXPECT_NE(sentence("A \x01").find("nobody sees"), std::string::npos);
}

} // namespace
} // namespace halfspace
