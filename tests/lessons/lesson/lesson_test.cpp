#include "lessons/lesson/lesson.h"

#include "lessons/lesson/shown.h"
#include "lessons/reading/document.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const std::string frontMatter = "---\n"
                                "id: example\n"
                                "title: An example\n"
                                "order: 7\n"
                                "sources: [PG 1]\n"
                                "scene:\n"
                                "  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}\n"
                                "  - {name: Q, point: [11, 15/2, 0.5]}\n"
                                "  - {name: d, construction: signed-distance, of: {E: E, Q: Q}}\n"
                                "camera: {from: [0, -1, 1], at: [1, 2, 3], height: 12}\n"
                                "---\n"; // 11 lines

Problem problemOf(const std::string &text) {
  const auto lesson = parseLesson(text, "a.md");
  EXPECT_FALSE(lesson) << text;
  if (lesson)
    return {};
  EXPECT_EQ(lesson.problem().file, "a.md");
  EXPECT_GE(lesson.problem().sentence.size(), 15U);
  return lesson.problem();
}

/// The words of a step, with a | where something stands between them.
std::string wordsIn(const LessonStep &step) {
  std::string words;
  for (const StepBlock &block : step.blocks)
    if (const auto *own = std::get_if<StepWords>(&block))
      words += (words.empty() ? "" : "|") + own->text.written();
  return words;
}

std::vector<std::string> linesIn(const LessonStep &step) {
  std::vector<std::string> ids;
  for (const StepBlock &block : step.blocks)
    if (const auto *lines = std::get_if<StepLines>(&block))
      ids.insert(ids.end(), lines->ids.begin(), lines->ids.end());
  return ids;
}

std::string replaced(std::string text, const std::string &from, const std::string &to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Lesson, NamesThatAreNearlyRight_AreGuessed) {
  EXPECT_TRUE(problemOf(replaced(frontMatter, "signed-distance", "signed-distanc") + "## One\n")
                  .sentence.ends_with("Perhaps “signed-distance” is meant."));
  EXPECT_TRUE(problemOf(replaced(frontMatter, "{E: E, Q: Q}", "{E: E, Q: q}") + "## One\n")
                  .sentence.ends_with("there is no object “q”."))
      << "no letter is right";
  std::string longer = replaced(frontMatter, "name: Q", "name: Peak");
  EXPECT_TRUE(problemOf(replaced(longer, "Q: Q}", "Q: Peek}") + "## One\n")
                  .sentence.ends_with("Perhaps “Peak” is meant."));
}

TEST(Lesson, FrontMatter_IsReadExactly) {
  const auto lesson = parseLesson(frontMatter + "## One\nWords.\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->id, "example");
  EXPECT_EQ(lesson->title, "An example");
  EXPECT_EQ(lesson->order, 7);
  EXPECT_EQ(lesson->sources, std::vector<std::string>{"PG 1"});
  EXPECT_EQ(coordinate(*findObject(lesson->scene, "Q"), 0), ExactVec3(11, Rational(15, 2), Rational(1, 2)));
  EXPECT_EQ(lesson->camera.at, glm::dvec3(1, 2, 3));
  EXPECT_EQ(lesson->camera.height, 12);
}

std::string withMacros(const std::string &macros) {
  return replaced(frontMatter, "scene:\n", "macros:" + macros + "\nscene:\n") + "## One\nWords.\n";
}

TEST(Lesson, Macros_AreReadWithTheirArguments) {
  const auto lesson =
      parseLesson(withMacros("\n  R: \\mathbb{R}\n  inner: '\\langle #1, #2\\rangle'"), "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->macros, (Macros{{"R", {0, "\\mathbb{R}"}}, {"inner", {2, "\\langle #1, #2\\rangle"}}}));
  EXPECT_TRUE(parseLesson(frontMatter + "## One\n", "a.md")->macros.empty());
}

TEST(Lesson, WhoseMacrosBringTooMuchTogether_IsRefused) {
  // Each formula stands for 10 · 10 · 80 letters, and alone it would be set.
  const std::string macros = "\n  a: '" + std::string(80, 'x') + "'\n  b: '\\a\\a\\a\\a\\a\\a\\a\\a\\a\\a'" +
                             "\n  c: '\\b\\b\\b\\b\\b\\b\\b\\b\\b\\b'\n";
  const auto lesson = [&](int formulas) {
    std::string text = withMacros(macros);
    for (int i = 0; i < formulas; ++i)
      text += "\nSo $\\c$.\n";
    return parseLesson(text, "a.md");
  };
  EXPECT_TRUE(lesson(60)) << lesson(60).problem().text();
  const auto refused = lesson(200);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.problem().sentence.find("more than 1024 KiB"), std::string::npos);
}

TEST(Lesson, MacrosThatAreNone_AreToldWithTheirLine) {
  const auto expect = [](const std::string &macros, int line, const std::string &field,
                         const std::string &words) {
    const Problem problem = problemOf(withMacros(macros));
    EXPECT_EQ(problem.line, line) << problem.text();
    EXPECT_EQ(problem.field, field);
    EXPECT_NE(problem.sentence.find(words), std::string::npos) << problem.sentence;
  };
  expect("\n  R: x\n  \\S: x", 8, "macros.\\S", "cannot be the name");
  expect("\n  R2: x", 7, "macros.R2", "cannot be the name");
  expect("\n  R: [x]", 7, "macros.R", "in single quotes is expected");
  expect("\n  R: ''", 7, "macros.R", "in single quotes is expected");
  expect("\n  R: 'a # b'", 7, "macros.R", "number of an argument");
  expect("\n  R: '" + std::string(longestMacro + 1, 'x') + "'", 7, "macros.R", "too long");
  expect("\n  R: \\vec #1", 7, "macros.R", "put the macro in single quotes");
  expect("\n  R: x\n  S: x\\T\n  T: '\\S'", 8, "macros.S", "uses itself");
  expect(" x", 6, "macros", "at most 100 macros");
  std::string many;
  for (char a = 'a'; a <= 'z'; ++a)
    for (char b = 'a'; b <= 'e'; ++b)
      many += "\n  " + std::string{a, b} + ": x";
  expect(many, 7, "macros", "at most 100 macros");
}

TEST(Lesson, Steps_KeepTheirWordsApartFromTheirBlocks) {
  const auto lesson = parseLesson(frontMatter + R"(## First
Some $f(Q)$ words.
```lines
f, side
foot
```
```task
do: Go there.
when: side = negative and f < -1/2
now: $f$ is {f}.
hints:
  - Where is $Q$?
  - 'Drag $Q$: along $\vec n$.'
done: $Q$ is there.
```
More.

## Second
```predict
ask: Where?
answer: side
choices: {positive: Here, negative: There}
why: So.
```
)",
                                  "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  ASSERT_EQ(lesson->steps.size(), 2U);
  const LessonStep &first = lesson->steps[0];
  EXPECT_EQ(first.title, "First");
  EXPECT_EQ(wordsIn(first), "Some $f(Q)$ words.|More.");
  EXPECT_EQ(linesIn(first), (std::vector<std::string>{"f", "side", "foot"}));
  const std::vector<Task> tasks = tasksOf(first);
  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_EQ(tasks[0].instruction.written(), "Go there.");
  EXPECT_EQ(tasks[0].now.written(), "$f$ is {f}.");
  EXPECT_EQ(tasks[0].answer.written(), "$Q$ is there.");
  ASSERT_EQ(tasks[0].hints.size(), 2U);
  EXPECT_EQ(tasks[0].hints[1].text.written(), "Drag $Q$: along $\\vec n$.");
  EXPECT_EQ(tasks[0].hints[1].line, tasks[0].hints[0].line + 1);
  ASSERT_EQ(tasks[0].conditions.size(), 2U);
  EXPECT_EQ(tasks[0].conditions[1].relation, Condition::Relation::Less);
  EXPECT_EQ(tasks[0].conditions[1].against, "-1/2");
  const Prediction *prediction = predictionOf(lesson->steps[1]);
  ASSERT_TRUE(prediction);
  EXPECT_EQ(prediction->choices.at(1).word, "negative");
}

/// The sorts of a step's blocks, from top to bottom.
std::string sortsIn(const LessonStep &step) {
  std::string sorts;
  for (const StepBlock &block : step.blocks)
    sorts += std::visit(
        Overloaded{
            [](const StepWords &) { return "words "; }, [](const StepLines &) { return "lines "; },
            [](const StepNote &) { return "note "; }, [](const Task &) { return "task "; },
            [](const Prediction &) { return "question "; }, [](const StepFlight &) { return "flight "; },
            [](const StepFragments &) { return "fragments "; }, [](const StepCost &) { return "cost "; }},
        block);
  return sorts;
}

TEST(Lesson, Blocks_StandInTheOrderOfTheFile) {
  const std::string task = "```task\ndo: Go.\nwhen: f = 0\n```\n";
  const std::string ask = "```predict\nask: A?\nanswer: side\nchoices: {a: b, c: d}\nwhy: So.\n```\n";
  const auto lesson =
      parseLesson(frontMatter + "## One\nA.\n```lines\nf\n```\n\n" + task + "\nB.\n\n```lines\nside\n```\n" +
                      ask + "```note\nT\nW.\n```\n## Two\n" + task + "## Three\nA.\n" + task + "C.\n",
                  "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(sortsIn(lesson->steps[0]), "words lines task words lines question note ");
  EXPECT_EQ(sortsIn(lesson->steps[1]), "lines task ") << "all lines, where none are named";
  EXPECT_EQ(sortsIn(lesson->steps[2]), "words lines task words ");
}

TEST(Lesson, ANote_HasATitleAndWordsThatAreFoldedAway) {
  const auto lesson = parseLesson(
      frontMatter + "## One\n```note\n\nFor *readers* of $n$\n\nA word.\n\nAnother $\\foo$.\n```\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  const auto *note = std::get_if<StepNote>(&lesson->steps[0].blocks.back());
  ASSERT_TRUE(note);
  EXPECT_EQ(note->title, "For *readers* of $n$");
  EXPECT_EQ(note->words.text.written(), "A word.\n\nAnother $\\foo$.");
  EXPECT_EQ(note->words.lines, (std::vector<int>{17, 18, 19}));
  const Problem problem = problemOf(frontMatter + "## One\n```note\nA title alone\n```\n");
  EXPECT_EQ(problem.line, 13);
  EXPECT_NE(problem.sentence.find("words below it"), std::string::npos);
}

TEST(Lesson, ACostBlock_NamesTheHits) {
  const auto lesson = parseLesson(frontMatter + "## One\nA.\n```cost\n{hits: nearest}\n```\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(sortsIn(lesson->steps[0]), "words lines cost ");
  const auto &cost = std::get<StepCost>(lesson->steps[0].blocks.back());
  EXPECT_EQ(cost.hits, "nearest");
  EXPECT_EQ(cost.line, 15);
  EXPECT_EQ(problemOf(frontMatter + "## One\n```cost\n{hits: L, most: 3}\n```\n").field, "cost.most");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```cost\n{}\n```\n").field, "cost.hits");
}

TEST(Lesson, AFlightBlock_NamesItsNumbersAndTheHits) {
  const auto flightIn = [](const std::string &fields) {
    const auto lesson = parseLesson(frontMatter + "## One\nA.\n```flight\n{" + fields + "}\n```\n", "a.md");
    return std::get<StepFlight>(lesson->steps[0].blocks.back());
  };
  const StepFlight flight = flightIn("frame: f, seed: s, hits: nearest, first-seed: 7");
  EXPECT_EQ(flight.frame, "f");
  EXPECT_EQ(flight.seed, "s");
  EXPECT_EQ(flight.hits, "nearest");
  EXPECT_EQ(flight.firstSeed, 7);
  EXPECT_EQ(flightIn("frame: f, seed: s, hits: nearest").firstSeed, 1);
  const auto fieldRefused = [](const std::string &fields) {
    return problemOf(frontMatter + "## One\n```flight\n{" + fields + "}\n```\n").field;
  };
  EXPECT_EQ(fieldRefused("seed: s, hits: nearest"), "flight.frame");
  EXPECT_EQ(fieldRefused("frame: f, hits: nearest"), "flight.seed");
  EXPECT_EQ(fieldRefused("frame: f, seed: s"), "flight.hits");
  EXPECT_EQ(fieldRefused("frame: f, seed: s, hits: h, speed: 2"), "flight.speed");
  EXPECT_EQ(fieldRefused("frame: f, seed: s, hits: h, first-seed: 0"), "flight.first-seed");
}

TEST(Lesson, AFragmentsBlock_SaysTheOrder) {
  const auto isByNumber = [](const std::string &fields) {
    const auto lesson =
        parseLesson(frontMatter + "## One\nA.\n```fragments\n{" + fields + "}\n```\n", "a.md");
    return std::get<StepFragments>(lesson->steps[0].blocks.back()).byNumber;
  };
  EXPECT_FALSE(isByNumber("hits: nearest"));
  EXPECT_FALSE(isByNumber("hits: nearest, by: parameter"));
  EXPECT_TRUE(isByNumber("hits: nearest, by: number"));
  EXPECT_EQ(problemOf(frontMatter + "## One\n```fragments\n{hits: h, by: name}\n```\n").field,
            "fragments.by");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```fragments\n{by: number}\n```\n").field, "fragments.hits");
}

TEST(Lesson, ADrawBlock_NamesMarks) {
  const auto lesson = parseLesson(frontMatter + "## One\n```draw\nF, d.w\n```\n## Two\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->steps[0].drawn, (std::vector<std::string>{"F", "d.w"}));
  EXPECT_TRUE(lesson->steps[1].drawn.empty());
  EXPECT_EQ(problemOf(frontMatter + "## One\n```draw\nF; w\n```\n").field, "draw");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```draw\n\n```\n").field, "draw");
}

TEST(Lesson, ADrawBlockOfAll_DrawsAllMarks) {
  const auto lesson = parseLesson(frontMatter + "## One\n```draw\nall\n```\n## Two\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_TRUE(lesson->steps[0].drawsAllResults);
  EXPECT_TRUE(lesson->steps[0].drawn.empty());
  EXPECT_FALSE(lesson->steps[1].drawsAllResults);
}

TEST(Lesson, AHideBlock_NamesEntries) {
  const auto lesson = parseLesson(frontMatter + "## One\n```hide\nE, d\nQ\n```\n## Two\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->steps[0].hidden, (std::vector<std::string>{"E", "d", "Q"}));
  EXPECT_EQ(lesson->steps[0].hiddenLines, (std::vector{14, 14, 15}));
  EXPECT_TRUE(lesson->steps[1].hidden.empty());
  EXPECT_EQ(problemOf(frontMatter + "## One\n```hide\n\n```\n").field, "hide");
}

TEST(Lesson, AFormulasBlock_IsKept_AndStandsNotOnThePage) {
  const auto lesson = parseLesson(
      frontMatter + "## One\nWords.\n```formulas\nThe plane:\n\n$$x = 1$$\n```\n## Two\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  const LessonStep &step = lesson->steps.front();
  EXPECT_EQ(sortsIn(step), "words lines ");
  ASSERT_EQ(step.formulas.size(), 1U);
  EXPECT_EQ(step.formulas[0].text.written(), "The plane:\n\n$$x = 1$$");
  EXPECT_EQ(step.formulas[0].lines.front(), 15);
  EXPECT_EQ(problemOf(frontMatter + "## One\n```formulas\n\n```\n").line, 13);
}

TEST(Lesson, ABlankBlock_SaysWhichLinesAreLeftToTheLearner) {
  const auto lesson = parseLesson(
      frontMatter + "## One\n```blank\nlast\n```\n## Two\n```blank\n all \n```\n## Three\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->steps[0].blank, Fading::Last);
  EXPECT_EQ(lesson->steps[1].blank, Fading::All);
  EXPECT_EQ(lesson->steps[2].blank, std::nullopt);
  const Problem problem = problemOf(frontMatter + "## One\n```blank\nsome\n```\n");
  EXPECT_EQ(problem.line, 14);
  EXPECT_NE(problem.sentence.find("none, gaps, last or all"), std::string::npos);
}

TEST(Lesson, AHeadingInABlockOfCode_IsNoStep) {
  const auto lesson = parseLesson(frontMatter + "## One\n````\n```task\n## not a step\n````\n", "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->steps.size(), 1U);
  EXPECT_NE(wordsIn(lesson->steps[0]).find("## not a step"), std::string::npos);
}

TEST(Lesson, WithWindowsLineEndsAndAByteOrderMark_IsReadTheSame) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : frontMatter + "## One\nWords.\n")
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto lesson = parseLesson(text, "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(wordsIn(lesson->steps[0]), "Words.");
}

TEST(LessonProblems, InTheFrame_NameTheLine) {
  EXPECT_EQ(problemOf("# A title\n").line, 1);
  EXPECT_EQ(problemOf("---\nid: x\n").line, 1);
  EXPECT_EQ(problemOf(frontMatter + "\nloose words\n## One\n").line, 13);
  problemOf(frontMatter);
  EXPECT_EQ(problemOf(frontMatter + "## One\n```task\ndo: x\n").line, 13);
}

TEST(LessonProblems, OfBytesThatAreNoText_NameTheLine) {
  for (const char *bytes : {"\xFF", "\xC3", "\xED\xA0\x80", "\x1B[31m", "\x7F", "\xC2\x9B"}) {
    EXPECT_EQ(problemOf(replaced(frontMatter, "An example", bytes)).line, 3);
    EXPECT_EQ(problemOf(frontMatter + "## One\nWords " + bytes + "\n").line, 13);
  }
  EXPECT_EQ(problemOf(frontMatter + "## One\n" + std::string(1, '\0')).line, 13);
}

TEST(Lesson, FlatPage_IsTwoDirectionsOfTheScene) {
  const auto withFlat = [](const std::string &flat) {
    return replaced(frontMatter, "height: 12}\n", "height: 12}\nflat: " + flat + "\n") + "## One\n";
  };
  EXPECT_FALSE(parseLesson(frontMatter + "## One\n", "mine.md")->flat);
  const auto lesson = parseLesson(withFlat("{up: E.n, right: n}"), "mine.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->flat, (FlatPage{{"E", 1}, {"E", 1}}));
  EXPECT_EQ(problemOf(withFlat("{up: E.n}")).field, "flat.right");
  EXPECT_EQ(problemOf(withFlat("{up: F.n, right: E.n}")).field, "flat.up");
  EXPECT_EQ(problemOf(withFlat("{up: E.P0, right: E.n}")).field, "flat.up") << "a point is no direction";
  EXPECT_EQ(problemOf(withFlat("{up: E.n, right: E.n, left: E.n}")).field, "flat.left");
  EXPECT_FALSE(problemOf(withFlat("up")).sentence.empty());
}

TEST(Lesson, HasShadows_UnlessItsHeadSaysFalse) {
  const auto withShadows = [](const std::string &value) {
    return replaced(frontMatter, "height: 12}\n", "height: 12}\nshadows: " + value + "\n") + "## One\n";
  };
  EXPECT_TRUE(parseLesson(frontMatter + "## One\n", "a.md")->hasShadows);
  EXPECT_TRUE(parseLesson(withShadows("true"), "a.md")->hasShadows);
  EXPECT_FALSE(parseLesson(withShadows("false"), "a.md")->hasShadows);
  const Problem problem = problemOf(withShadows("none"));
  EXPECT_EQ(problem.field, "shadows");
  EXPECT_EQ(problem.line, 11);
}

TEST(LessonProblems, InTheFrontMatter_NameLineAndField) {
  const Problem id = problemOf(replaced(frontMatter, "id: example", "id: An Example"));
  EXPECT_EQ(id.line, 2);
  EXPECT_EQ(id.field, "id");
  const Problem unknown = problemOf(replaced(frontMatter, "order: 7", "ordre: 7"));
  EXPECT_EQ(unknown.line, 4);
  EXPECT_EQ(unknown.field, "ordre");
  const Problem number = problemOf(replaced(frontMatter, "15/2", "15/0"));
  EXPECT_EQ(number.line, 8);
  EXPECT_EQ(number.field, "scene[1].point");
  const Problem kind = problemOf(replaced(frontMatter, "{E: E, Q: Q}", "{E: Q, Q: Q}"));
  EXPECT_EQ(kind.line, 9);
  EXPECT_EQ(kind.field, "scene[2].of.E");
  EXPECT_EQ(problemOf(replaced(frontMatter, "height: 12", "height: 0")).field, "camera.height");
  EXPECT_EQ(problemOf(replaced(frontMatter, "from: [0, -1, 1]", "from: [0, 0, 0]")).field, "camera.from");
  EXPECT_EQ(problemOf(replaced(frontMatter, "title: An example\n", "")).field, "title");
}

TEST(LessonProblems, InBlocks_NameLineAndField) {
  const Problem when = problemOf(frontMatter + "## One\n```task\ndo: x\nwhen: side < negative\n```\n");
  EXPECT_EQ(when.line, 15);
  EXPECT_EQ(when.field, "when");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```task\nwhen: t = 1\n```\n").field, "do");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```task\ndo: x\n```\n").field, "when");
  const std::string task = frontMatter + "## One\n```task\ndo: x\nwhen: t = 1\n";
  EXPECT_EQ(problemOf(task + "now: [a]\n```\n").field, "now");
  EXPECT_EQ(problemOf(task + "hints: [[a]]\n```\n").field, "hints");
  EXPECT_EQ(problemOf(task + "hints: [a, b, c, d]\n```\n").line, 16);
  EXPECT_EQ(
      problemOf(frontMatter + "## One\n```predict\nask: a\nanswer: t\nwhy: c\nchoices: {a: b}\n```\n").field,
      "choices");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```lines\n\n```\n").field, "lines");
  EXPECT_EQ(problemOf(frontMatter + "## One\n```lines\n$x$\n```\n").line, 14);
}

TEST(LessonProblems, InListsOfTexts_NameLineAndField) {
  const std::string task = frontMatter + "## One\n```task\ndo: x\nwhen: t = 1\n";
  const std::string term = frontMatter + "## One\n```term\nname: a\nmeans: b\n";
  const std::string tooLong(maxFieldText + 1, 'a');
  for (const std::string &wrong :
       {std::string("['']"), std::string("[b, '']"), std::string("{a: b}"), "[" + tooLong + "]", tooLong}) {
    const Problem hints = problemOf(task + "hints: " + wrong + "\n```\n");
    EXPECT_EQ(hints.field, "hints") << wrong;
    EXPECT_EQ(hints.line, 16) << wrong;
    EXPECT_EQ(problemOf(term + "also: " + wrong + "\n```\n").field, "term.also") << wrong;
    const Problem sources = problemOf(replaced(frontMatter, "[PG 1]", wrong) + "## One\n");
    EXPECT_EQ(sources.field, "sources") << wrong;
    EXPECT_EQ(sources.line, 5) << wrong;
    const Problem needs = problemOf(replaced(frontMatter, "sources: [PG 1]", "needs: " + wrong) + "## One\n");
    EXPECT_EQ(needs.field, "needs") << wrong;
  }
  const auto lesson = parseLesson(task + "hints: [" + tooLong.substr(1) + "]\n```\n", "a.md");
  EXPECT_TRUE(lesson) << "as long as it may be";
}

TEST(LessonProblems, TooLarge_IsRefused) {
  EXPECT_NE(problemOf(std::string(maxLessonBytes + 1, 'a')).sentence.find("too large"), std::string::npos);
}

TEST(LessonProblems, OfWordsThatCannotBeReadAsMarkdown_NameTheirLine) {
  const Problem deep = problemOf(frontMatter + "## One\n\n" + std::string(50, '>') + " a\n");
  EXPECT_NE(deep.sentence.find("too deeply"), std::string::npos);
  EXPECT_EQ(deep.line, 14);
  const Problem task =
      problemOf(frontMatter + "## One\n```task\ndo: '" + std::string(50, '>') + " a'\nwhen: t = 1\n```\n");
  EXPECT_EQ(task.line, 14);
  EXPECT_EQ(task.field, "do");
  EXPECT_NE(problemOf(frontMatter + "## One\n" + std::string(100000, 'a')).sentence.find("too long"),
            std::string::npos);
}

TEST(LessonProblems, OfAFileThatIsNotThere_IsAProblem) {
  EXPECT_FALSE(readLesson("/no/such/lesson.md"));
  EXPECT_FALSE(readLesson("/"));
  EXPECT_EQ(readLessons("/no/such/folder").problems.size(), 1U);
}

TEST(ShownIn, AStepWithLines_KeepsThoseLinesTheirMarksAndTheGivens) {
  const Evaluation all = evaluate(test::distanceScene());
  LessonStep step;
  step.blocks = {StepLines{{"foot"}}};
  const Shown shown = shownIn(step, all);
  ASSERT_EQ(shown.working.lines.size(), 1U);
  EXPECT_EQ(shown.working.lines[0].id, "distance.foot");
  EXPECT_NE(findMark(shown.figure, "Q"), nullptr);
  EXPECT_NE(findMark(shown.figure, "distance.F"), nullptr);
  EXPECT_NE(findMark(figureOf(all), "distance.theta"), nullptr);
  EXPECT_EQ(findMark(shown.figure, "distance.theta"), nullptr);
}

TEST(ShownIn, EveryBlockOfLines_HasItsOwnInTheOrderOfThePage) {
  const Evaluation all = evaluate(test::distanceScene());
  const LessonStep step{"", {StepLines{{"foot", "f"}}, StepWords{"Words."}, StepLines{{"side", "f"}}}};
  const Shown shown = shownIn(step, all);
  EXPECT_EQ(shown.linesIn, (std::vector<std::size_t>{2, 1}));
  std::vector<std::string> ids;
  for (const WorkingLine &line : shown.working.lines)
    ids.push_back(line.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"distance.f", "distance.foot", "distance.side"}));
}

TEST(ShownIn, MarksThatAStepDraws_AreThereBesidesThoseOfItsLines) {
  Scene scene = test::distanceScene();
  LessonStep step{"", {StepLines{{"f"}}}};
  const auto has = [&](const std::string &mark) {
    return findMark(shownIn(step, evaluate(scene)).figure, mark) != nullptr;
  };
  EXPECT_FALSE(has("distance.F"));
  step.drawn = {"F"};
  EXPECT_TRUE(has("distance.F"));
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  step.blocks = {StepLines{{"distance.f"}}};
  EXPECT_FALSE(has("distance.F") || has("again.F")) << "both have one";
  step.drawn = {"again.F"};
  EXPECT_TRUE(has("again.F"));
  EXPECT_FALSE(has("distance.F"));
}

TEST(ShownIn, EntriesThatAStepHides_HaveNoMarks_WhateverItDraws) {
  const Evaluation all = evaluate(test::distanceScene());
  LessonStep step{"", {StepLines{{"distance.*"}}}, {"F"}};
  step.hidden = {"E"};
  for (const Question question : {Question::Answered, Question::Open}) {
    const Figure figure = shownIn(step, all, question).figure;
    EXPECT_EQ(findMark(figure, "E"), nullptr);
    EXPECT_EQ(findMark(figure, "E.n"), nullptr);
    EXPECT_NE(findMark(figure, "Q"), nullptr);
  }
  EXPECT_NE(findMark(shownIn(step, all).figure, "distance.F"), nullptr);
  step.hidden = {"distance"};
  const Shown shown = shownIn(step, all);
  EXPECT_EQ(findMark(shown.figure, "distance.F"), nullptr);
  EXPECT_NE(findMark(shown.figure, "E"), nullptr);
  EXPECT_FALSE(shown.working.lines.empty()) << "its lines stand on the page all the same";
}

TEST(ShownIn, WhileTheQuestionIsOpen_OnlyWhatIsGivenIsDrawn) {
  const Evaluation all = evaluate(test::distanceScene());
  for (const LessonStep &step :
       {LessonStep{"", {StepLines{{"foot"}}}, {"F"}}, LessonStep{"", {StepLines()}}}) {
    for (const Mark &mark : shownIn(step, all, Question::Open).figure.marks)
      EXPECT_EQ(baseOf(mark).role, Role::Given) << baseOf(mark).id;
    EXPECT_NE(findMark(shownIn(step, all, Question::Open).figure, "Q"), nullptr);
    EXPECT_NE(findMark(shownIn(step, all).figure, "distance.F"), nullptr);
  }
}

TEST(ShownIn, WhileTheQuestionIsOpen_ARayDoesNotEndNearWhatItMeets) {
  const Scene scene{{{"E", PlaneObject{{0, 0, 2}, {0, 0, 1}}},
                     {"L", RayObject{{0, 0, 5}, {0, 0, -1}}},
                     {"meeting", ConstructionUse{"ray-plane-dot", {{"E", "E"}, {"L", "L"}}}}}};
  const LessonStep step{"", {StepLines{{"t"}}}};
  const auto meets = [&](Question question) {
    const Figure figure = shownIn(step, evaluate(scene), figureOf(evaluate(scene)), question).figure;
    for (const Mark &mark : figure.marks)
      if (const auto *ray = std::get_if<RayMark>(&mark))
        return ray->meets.has_value();
    throw std::logic_error("no ray");
  };
  EXPECT_TRUE(meets(Question::Answered));
  EXPECT_FALSE(meets(Question::Open));
}

TEST(ShownIn, AStepOverTwoConstructions_ShowsTheLinesThatItNames) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const Evaluation all = evaluate(scene);
  const auto idsOf = [&](std::vector<std::string> names) {
    LessonStep step;
    step.blocks = {StepLines{std::move(names)}};
    std::vector<std::string> ids;
    for (const WorkingLine &line : shownIn(step, all).working.lines)
      ids.push_back(line.id);
    return ids;
  };
  EXPECT_EQ(idsOf({"again.f", "distance.foot"}), (std::vector<std::string>{"distance.foot", "again.f"}));
  EXPECT_EQ(idsOf({"foot"}), std::vector<std::string>()) << "both have one";
  EXPECT_EQ(idsOf({"cosine"}).size(), 0U) << "both have one";
  EXPECT_EQ(idsOf({"again.*"}).size(), 8U) << "all that there are in the plane";
}

TEST(ShownIn, AStepThatNamesTheLinesOfOneConstruction_MakesNoneOfTheOthers) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const Evaluation all = evaluate(scene);
  LessonStep step;
  step.blocks = {StepLines{{"distance.f"}}};
  EXPECT_EQ(shownIn(step, all).working.lines.size(), 1U);
  const Outcome &other = *all.find("again")->outcome;
  EXPECT_FALSE(other.explanation.isMade() || other.told.isMade() || other.values.isMade());
}

TEST(ShownIn, OfTwoNearlyEqualFigures_SharesTheMarksThatAreTheSame) {
  const Scene scene = test::distanceScene();
  const Evaluation before = evaluate(scene);
  const Evaluation after = evaluate(test::edited(scene, {ChangeObject{"Q", PointObject{{1, 2, 3}}}}), before);
  const LessonStep step{"", {StepLines{{"f"}}}};
  const Shown shownBefore = shownIn(step, before);
  const Shown shownAfter = shownIn(step, after);
  EXPECT_EQ(findMark(shownAfter.figure, "E.n"), findMark(shownBefore.figure, "E.n"));
  EXPECT_NE(findMark(shownAfter.figure, "Q"), findMark(shownBefore.figure, "Q"));
}

TEST(ShownIn, WhoNamesACoordinate_ShowsItsObject) {
  const Scene scene{{test::planeE(),
                     {"F", PlaneObject{{0, 0, 0}, {0, 0, 1}}},
                     {"meet", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}}}};
  LessonStep step;
  step.blocks = {StepLines{{"direction"}}};
  const Figure figure = shownIn(step, evaluate(scene)).figure;
  EXPECT_NE(findMark(figure, "meet.g"), nullptr) << "the line whose direction is worked out";
  EXPECT_EQ(findMark(figure, "meet.g.A"), nullptr);
}

TEST(ShownIn, TheCasesOfTheConstructionsThatAStepNames_AreTold) {
  Scene scene = test::distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "distance.F"}}}});
  const Evaluation all = evaluate(scene);
  const std::string first = all.find("distance")->outcome->told->description;
  const std::string second = all.find("again")->outcome->told->description;
  LessonStep step;
  EXPECT_EQ(shownIn(step, all).description, first + " " + second);
  step.blocks = {StepLines{{"distance.f"}}};
  EXPECT_EQ(shownIn(step, all).description, first);
  step.blocks = {StepLines{{"again.no-line-of-this-case"}}}; // its case is told all the same
  EXPECT_EQ(shownIn(step, all).description, second);
}

TEST(RightChoice, IsThatOfWhatTheSceneComesTo) {
  const Prediction whichSide{
      "Which side?", "side", {{"positive", "That of n"}, {"negative", "The other"}}, "It is so."};
  const auto rightFor = [&](const char *side) {
    return rightChoice(whichSide, test::withValues({{"side", "", Word{side, side}}}));
  };
  EXPECT_EQ(rightFor("positive"), "positive");
  EXPECT_EQ(rightFor("negative"), "negative");
  EXPECT_EQ(rightFor("on"), "") << "no choice fits";
}

TEST(RightChoice, Otherwise_IsRightWhereNoOtherFits_AlsoWithoutAValue) {
  const Prediction whichSide{
      "Which side?", "side", {{otherwise, "Neither"}, {"positive", "That of n"}}, "It is so."};
  const auto rightFor = [&](const char *value, const char *side) {
    return rightChoice(whichSide, test::withValues({{value, "", Word{side, side}}}));
  };
  EXPECT_EQ(rightFor("side", "positive"), "positive");
  EXPECT_EQ(rightFor("side", "on"), otherwise);
  EXPECT_EQ(rightFor("location", "positive"), otherwise);
}

TEST(StepOf, ALessonThatHasNone_ShowsAllLines) {
  Lesson one;
  one.steps = {{"First", {}}};
  EXPECT_EQ(stepOf(one, 0).title, "First");
  for (const LessonStep &step : {stepOf(one, 1), stepOf(Lesson(), 0)}) {
    ASSERT_EQ(step.blocks.size(), 1U);
    EXPECT_TRUE(std::get<StepLines>(step.blocks[0]).ids.empty());
  }
}

TEST(ShownIn, AStepWithNoneOfTheLines_ShowsNone_AndWhatIsGivenAlone) {
  const auto lesson = parseLesson("---\nid: a\ntitle: A\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n"
                                  "## Read\nWords.\n```lines\nnone\n```\n",
                                  "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  const Evaluation all = evaluate(test::distanceScene());
  const Shown shown = shownIn(lesson->steps[0], all);
  EXPECT_TRUE(shown.working.lines.empty());
  EXPECT_EQ(shown.linesIn, std::vector<std::size_t>{0});
  EXPECT_LT(shown.figure.marks.size(), figureOf(all).marks.size());
  EXPECT_FALSE(shown.figure.marks.empty());
}

TEST(Lesson, Titles_ThatWouldSteerWhoReadsThem_DoNot) {
  const auto lesson = parseLesson("---\nid: a\ntitle: \"A\\e[31m\\u202E\"\nchapter: \"C\\u202E\"\nscene:\n"
                                  "  - {name: Q, point: [1, 2, 3]}\n---\n## S\u202E\n"
                                  "```note\nN\u202E\nWords.\n```\n",
                                  "a.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  EXPECT_EQ(lesson->title, "A\uFFFD[31m\uFFFD");
  EXPECT_EQ(lesson->chapter, "C\uFFFD");
  EXPECT_EQ(lesson->steps[0].title, "S\uFFFD");
  EXPECT_EQ(std::get<StepNote>(lesson->steps[0].blocks.back()).title, "N\uFFFD");
}

TEST(ShownIn, AStepWithoutLines_ShowsAll) {
  const Evaluation all = evaluate(test::distanceScene());
  const LessonStep step{"", {StepLines()}};
  EXPECT_EQ(shownIn(step, all).working.lines.size(), workingOf(all).lines.size());
  EXPECT_EQ(shownIn(step, all).figure.marks.size(), figureOf(all).marks.size());
}

} // namespace
} // namespace halfspace
