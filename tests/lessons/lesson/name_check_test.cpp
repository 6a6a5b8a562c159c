#include "lessons/lesson/name_check.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const std::string frontMatter = "---\n"
                                "id: example\n"
                                "title: An example\n"
                                "scene:\n"
                                "  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}\n"
                                "  - {name: Q, point: [11, 15, 8]}\n"
                                "  - {name: L, ray: {Q: [1, 1, 1], r: [1, -1, 0]}}\n"
                                "  - {name: d, construction: signed-distance, of: {E: E, Q: Q}}\n"
                                "  - {name: m, construction: ray-plane-dot, of: {E: E, L: L}}\n"
                                "  - {name: e, construction: signed-distance, of: {E: E, Q: m.H}}\n"
                                "---\n"; // 11 lines

/// The problems of a lesson with this behind its front matter, as `line: field: sentence`.
std::vector<std::string> problemsIn(const std::string &body) {
  const auto lesson = parseLesson(frontMatter + body, "a.md");
  EXPECT_TRUE(lesson) << lesson.problem().text();
  std::vector<std::string> texts;
  if (lesson)
    for (const Problem &problem : problemsWithNames(*lesson)) {
      EXPECT_EQ(problem.file, "a.md");
      texts.push_back(std::to_string(problem.line) + ": " + problem.field + ": " + problem.sentence);
    }
  return texts;
}

using Texts = std::vector<std::string>;

std::string lines(const std::string &ids) { return "## One\n```lines\n" + ids + "\n```\n"; }
std::string draw(const std::string &ids) { return "## One\n```draw\n" + ids + "\n```\n"; }
std::string hide(const std::string &names) { return "## One\n```hide\n" + names + "\n```\n"; }
std::string task(const std::string &when) { return "## One\n```task\ndo: Go.\nwhen: " + when + "\n```\n"; }
std::string question(const std::string &answer, const std::string &words) {
  std::string text = "## One\n```predict\nask: Where?\nanswer: " + answer + "\nchoices:\n";
  for (const char word : words)
    text += std::string("  ") + word + ": Here\n";
  return text + "why: So.\n```\n";
}

TEST(NameCheck, NamesOfTheScene_AreRight) {
  EXPECT_EQ(problemsIn(lines("d.f, d.*, m.numerator\nt, collect")), Texts{});
  EXPECT_EQ(problemsIn(draw("H, d.F, E.n, Q, facing, P0")), Texts{});
  EXPECT_EQ(problemsIn(task("d.side = on and t < 1/2 and point.z = 0 and facing_normal.2 != 1")), Texts{});
  EXPECT_EQ(problemsIn(task("case = missing-object and d.case = positive and m.case != in-plane")), Texts{});
  EXPECT_EQ(
      problemsIn("## One\n```predict\nask: What?\nanswer: t\nchoices:\n  0: No\n  -22: Yes\nwhy: So.\n```\n"),
      Texts{});
  EXPECT_EQ(problemsIn("## One\nIt is {d.f} at {Q} and {E.n}, {point.x}, not `{code}` or ${f}$ or \\{no}.\n"),
            Texts{});
}

TEST(NameCheck, NameOfAConstruction_IsNoValue_AndItsValuesAreTold) {
  const Texts problems = problemsIn("## One\nIt is {d}.\n");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().find("“d” has several values: write one of d."), std::string::npos);
  EXPECT_NE(problems.front().find("d.signed_distance"), std::string::npos);
}

TEST(NameCheck, EntriesThatAreHidden_AreThere_AndInThePicture) {
  EXPECT_EQ(problemsIn(hide("E, d, L")), Texts{});
  EXPECT_EQ(problemsIn(hide("E\nF")), Texts{"15: hide: There is no entry “F” in the scene."});
  EXPECT_EQ(problemsIn(hide("E.n")).size(), 1U) << "a part of an entry is not hidden alone";
  const auto lesson = parseLesson(
      "---\nid: a\ntitle: A\nscene: [{name: k, number: {value: 1, from: 0, to: 2, step: 1}}]\n---\n" +
          hide("k"),
      "a.md");
  ASSERT_TRUE(lesson);
  EXPECT_EQ(problemsWithNames(*lesson).at(0).sentence, "“k” is a number: it is in no picture.");
}

TEST(NameCheck, LiveValuesInAQuestion_AreTold_BecauseNoneIsFilledIn) {
  EXPECT_EQ(
      problemsIn("## One\n```predict\nask: What is {d.f}?\nanswer: d.side\nchoices:\n  positive: It is {Q}\n"
                 "  negative: $\\vec{n}$\nwhy: So {d.f} is.\n```\n"),
      (Texts{"14: ask: No live value is filled in here: {d.f} would stand as it is.",
             "17: choices: No live value is filled in here: {Q} would stand as it is.",
             "19: why: No live value is filled in here: {d.f} would stand as it is."}));
}

TEST(NameCheck, BlocksOfWhatLooksAtNoTriangles_AreTold) {
  for (const char *block : {"cost", "fragments"})
    for (const char *name : {"m", "L"})
      EXPECT_EQ(problemsIn("## One\n```" + std::string(block) + "\n{hits: " + name + "}\n```\n"),
                Texts{"14: hits: “" + std::string(name) +
                      "” is no construction of the scene that looks at many triangles."});
}

TEST(NameCheck, FlightWithoutItsNumbers_IsTold) {
  EXPECT_EQ(
      problemsIn("## One\n```flight\n{frame: L, seed: nobody, hits: m}\n```\n"),
      (Texts{"14: frame: “L” is no number of the scene.", "14: seed: “nobody” is no number of the scene.",
             "14: hits: “m” is no construction of the scene that looks at many triangles."}));
}

TEST(NameCheck, LineThatNobodyHas_IsToldWithItsPlaceAndWhatIsMeant) {
  EXPECT_EQ(problemsIn(lines("t,\n  d.foto hit")),
            Texts{"15: lines: There is no worked line “d.foto”. Perhaps “d.foot” is meant."});
  EXPECT_EQ(problemsIn(lines("xyzzy.*")), Texts{"14: lines: There is no worked line “xyzzy.*”."});
  EXPECT_EQ(problemsIn(lines("E.*")), Texts{"14: lines: There is no worked line “E.*”."});
}

TEST(NameCheck, QuestionWithoutTheChoiceThatIsRightAtTheStart_IsTold) {
  EXPECT_EQ(problemsIn(question("t", "12")),
            Texts{"15: answer: At the start “t” is none of these choices. Add one for what it is there."});
  EXPECT_EQ(
      problemsIn("## One\n```predict\nask: Where?\nanswer: m.case\nchoices:\n  hit: Here\n  parallel: There\n"
                 "why: So.\n```\n"),
      Texts{"15: answer: At the start “m.case” is “behind”, but there is no such choice. Add one."});
}

TEST(NameCheck, NameThatSeveralHave_IsToSayWhose) {
  EXPECT_EQ(problemsIn(lines("f")), Texts{"14: lines: “f” can be d.f or e.f: say which."});
  EXPECT_EQ(problemsIn(draw("F")), Texts{"14: draw: “F” can be d.F or e.F: say which."});
  EXPECT_EQ(problemsIn(task("side = on")), Texts{"15: when: “side” can be d.side or e.side: say which."});
  EXPECT_EQ(problemsIn("## One\n{f}\n"), Texts{"13: : “f” can be d.f or e.f: say which."});
}

TEST(NameCheck, MarkThatIsNeverDrawn_IsTold) {
  EXPECT_EQ(problemsIn(draw("facign")),
            Texts{"14: draw: There is no mark “facign”. Perhaps “facing” is meant."});
  EXPECT_EQ(problemsIn(draw("E.m")), Texts{"14: draw: There is no mark “E.m”. Perhaps “E.n” is meant."});
}

TEST(NameCheck, ComparisonThatCanNeverHold_IsTold) {
  EXPECT_EQ(problemsIn(task("d.side = possitive")),
            Texts{"15: when: “d.side” is never “possitive”. It can be: positive, negative, on. Perhaps "
                  "“positive” is meant."});
  EXPECT_EQ(problemsIn(task("m.case = miss")),
            Texts{"15: when: “m.case” is never “miss”. It can be: hit, behind, parallel, in-plane, "
                  "zero-direction, zero-normal."});
  EXPECT_EQ(problemsIn(task("t = small")), Texts{"15: when: “t” is a number, and never “small”."});
  EXPECT_EQ(problemsIn(task("point = 0")),
            Texts{"15: when: “point” has several numbers: name one of them, as point.x or point.0."});
  EXPECT_EQ(problemsIn(task("point.w = 0")),
            Texts{"15: when: There is no value “point.w”. Perhaps “point” is meant."});
  EXPECT_EQ(problemsIn(task("point.3 = 0")),
            Texts{"15: when: There is no value “point.3”. Perhaps “point” is meant."});
}

TEST(NameCheck, ChoiceThatTheAnswerNeverIs_IsToldWithItsLine) {
  EXPECT_EQ(problemsIn(question("t", "1q")), Texts{"18: choices: “t” is a number, and never “q”."});
  EXPECT_EQ(problemsIn(question("tt", "12")),
            Texts{"15: answer: There is no value “tt”. Perhaps “t” is meant."});
}

TEST(NameCheck, LiveValueThatIsNotThere_IsTold) {
  EXPECT_EQ(problemsIn("## One\n\nWords\nand {denominater}.\n"),
            Texts{"15: : There is no value “denominater”. Perhaps “denominator” is meant."});
  EXPECT_EQ(problemsIn("## One\n```note\nA title\nIt is {Q.z}.\n```\n"),
            Texts{"15: note: There is no value “Q.z”."});
}

TEST(NameCheck, LiveValueWithoutAValueAtTheStart_IsTold) {
  std::string parallel = frontMatter + "## One\n{t}\n";
  parallel.replace(parallel.find("r: [1, -1, 0]"), 13, "r: [2, -1, 0]");
  const auto lesson = parseLesson(parallel, "a.md");
  ASSERT_TRUE(lesson);
  ASSERT_EQ(problemsWithNames(*lesson).size(), 1U);
  EXPECT_EQ(problemsWithNames(*lesson).front().text(),
            "a.md:13: “t” has no value at the start: a dash would stand here.");
}

} // namespace
} // namespace halfspace
