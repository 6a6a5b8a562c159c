// `halfspace check` as a shell meets it: what is wrong with lessons, a line for each problem.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

TEST_F(Program, Check_OfOurLessons_FindsNothing) {
  const Ran ran = run("check");
  EXPECT_EQ(ran.status, 0) << ran.out;
  EXPECT_EQ(ran.err, "");
  const std::string all = run("lessons").out;
  EXPECT_EQ(ran.out,
            "Nothing is wrong. Lessons: " + std::to_string(std::count(all.begin(), all.end(), '\n')) + "\n");
}

const std::string faultyLesson = R"(---
id: faulty
title: Faulty
macros: {ok: '\vec #1'}
scene:
  - {name: Q, point: [1, 2, 3]}
---

## One

Words with $\ok n$ and $\foo$,
and `$\foo$`; $t$ = $\frac{1}$
```task
do: Ärger with $x^2^3$.
when: side = on
```

$$\left( x$$

```python
$code
```

```predict
ask: Where is $\Q$?
answer: side
choices:
  on: $\vec n$
  positive: $\begin{x}$
why: Because $}$.
```
And λ $\bar$
)";

TEST_F(Program, Check_OfALesson_TellsEachThingThatIsWrong) {
  write("faulty.md", faultyLesson);
  const Ran ran = run("check faulty.md");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(
      ran.out,
      "faulty.md:11: In “\\foo”, column 1: `\\foo` is unknown.\n"
      "faulty.md:12: In “\\frac{1}”, column 9: An argument is missing here.\n"
      "faulty.md:14: do: In “x^2^3”, column 4: There are two superscripts: put the first with its base into "
      "`{}`.\n"
      "faulty.md:15: when: There is no value “side”.\n"
      "faulty.md:18: In “\\left( x”, column 1: A `\\right` is missing for this `\\left`.\n"
      "faulty.md:25: ask: In “\\Q”, column 1: `\\Q` is unknown.\n"
      "faulty.md:26: answer: There is no value “side”.\n"
      "faulty.md:29: choices: In “\\begin{x}”, column 1: The environment `x` is unknown.\n"
      "faulty.md:30: why: In “}”, column 1: This `}` has no `{`.\n"
      "faulty.md:32: In “\\bar”, column 2: An argument is missing here.\n");
}

TEST_F(Program, NewLesson_PassesTheCheck_AndIsOpenedFromItsFolder) {
  const Ran written = run("new-lesson my-first");
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out, "my-first.md is written. Try it: halfspace --lessons . my-first\n");
  EXPECT_EQ(run("check my-first.md").out, "Nothing is wrong. Lessons: 1\n");
  EXPECT_NE(run("explain my-first --lessons .").out.find("My first lesson"), std::string::npos);
  EXPECT_EQ(run("--lessons . explain my-first --set Q=5,4,8 --format json").status, 0);
  EXPECT_NE(run("lessons --lessons .").out.find("my-first  My first lesson\n"), std::string::npos);
  EXPECT_EQ(run("explain my-first").status, 2) << "of ours there is none";
}

TEST_F(Program, NewLesson_OverAFile_OrWithNoId_IsRefused) {
  write("mine.md", "precious");
  expectRefused("new-lesson mine", "stays as it is");
  EXPECT_EQ(run("check mine.md").status, 1) << "and so it does";
  for (const std::string bad : {"Mine", "../mine", "a/b", "''", "'a: b'"})
    expectRefused("new-lesson " + bad, "cannot be the id of a lesson");
}

TEST_F(Program, OwnLessons_WithIdsOfOurs_OrInNoFolder_AreToldAndLeftOut) {
  std::filesystem::create_directory(inFolder("mine"));
  write("mine/a.md", "---\nid: signed-distance" + faultyLesson.substr(faultyLesson.find("\ntitle")));
  const Ran ran = run("lessons --lessons mine --lessons nowhere");
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.err.find("mine/a.md: id: Another lesson has the id “signed-distance”"), std::string::npos);
  EXPECT_NE(ran.err.find("nowhere: The folder of lessons cannot be read."), std::string::npos);
  EXPECT_EQ(ran.out.find("Faulty"), std::string::npos);
}

TEST_F(Program, Check_OfAFolder_TellsWhatIsWrongInEachFile) {
  std::filesystem::create_directory(inFolder("mine"));
  write("mine/a.md", "---\nid: a\n---\n");
  write("mine/b.md", faultyLesson);
  const Ran ran = run("check mine no-such-file.md");
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find("mine/a.md"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("mine/b.md:11:"), std::string::npos);
  EXPECT_NE(ran.out.find("no-such-file.md"), std::string::npos);
}

} // namespace
} // namespace halfspace
