// `halfspace check` as a shell meets it: what is wrong with lessons, a line for each problem.
#include "tests/app/command_fixture.h"
#include "tests/untranslated.h"

#include <regex>
#include <sstream>
#include <vector>

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

/// A mistake in the lesson that new-lesson writes, and what is told of it behind the file's name.
struct Mistake {
  std::string right;
  std::string wrong;
  int line;
  std::string told; ///< its beginning
};

const std::vector<Mistake> &mistakes() {
  static const std::vector<Mistake> all{
      {"id: base", "id: Base", 2, "id: An id is made of"},
      {"title: My", "titl: My", 3,
       "titl: There is no such field. Remove it or mend its name. Perhaps “title” is"},
      {"title: My first lesson", "", 2, "title: This field is missing."},
      {"sources: []", "sources: &a [*a]", 5, "References with * are not read."},
      {"sources: []", "sources: [&a [x, x], &b [*a, *a], &c [*b, *b]]", 5, "References with * are not read."},
      {"sources: []", "sources: " + std::string(100, '[') + std::string(100, ']'), 5,
       "Lists and maps are nested too deeply"},
      {"sources: []", "sources: [", 5,
       "This is not YAML as it should be: …. Perhaps a ] is missing: this [ is never "
       "closed."},
      {"title: My first lesson", "title: Roof: how far", 3,
       "This is not YAML as it should be: …. A text with a colon in it needs quotes. Perhaps "
       "“title: 'Roof: how far'” is meant."},
      {"title: My first lesson", "title: Half-open, [0, 1)\ntitle: Again", 4, "“title” stands here twice"},
      {"P0: [5, 4, 7],", "P0: [5, 4, 7,", 7,
       "This is not YAML as it should be: …. Perhaps a ] is missing: this [ is never closed."},
      {"title: My first lesson", "title: 'It's mine'", 3,
       "This is not YAML as it should be: …. Perhaps a text in quotes has such a quote in "
       "it: "
       "write that twice."},
      {"  - {name: Q", "\t- {name: Q", 8,
       "This is not YAML as it should be: …. Perhaps spaces are meant: this line is "
       "indented "
       "by a tab."},
      {"  - {name: Q", " - {name: Q", 8,
       "This is not YAML as it should be: …. Perhaps this line is indented too much or "
       "too "
       "little."},
      {"n: [1, 2, 2]", "n:[1, 2, 2]", 7,
       "This is not YAML as it should be: …. Perhaps a comma is missing, or the "
       "space "
       "behind a colon."},
      {"[11, 15, 8]}", "[11, 15, 8]]}", 8,
       "This is not YAML as it should be: …. Perhaps there is a ] too many."},
      {"of: {E: E, Q: Q}}", "of: {E: E, Q: Q}", 9,
       "A list or a map cannot be a name. Names are plain words. Perhaps a } is missing: this { is never "
       "closed."},
      {"height: 21}\n---\n", "height: 21}\n\n", 1, "The head that opens here has no end. Put a line ---"},
      {"sources: []", "needs: [plain-implicit]", 5,
       "needs: There is no lesson “plain-implicit”. Perhaps “plane-implicit” is meant."},
      {"id: base", "id: ray-sphere", 2, "id: A lesson of the program has the id “ray-sphere” already"},
      {"## Ask first", "# Ask first", 12, "This heading begins no step. Perhaps “## Ask first” is meant."},
      {"## Give", "# Give", 32, "This heading begins no step. Perhaps “## Give something to do” is meant."},
      {"between dollars", "as $x^2 in the space", 14, "This $ has no partner in its paragraph."},
      {"plane is $Q$?", "plane is $Q?", 17, "ask: This $ has no partner in its paragraph."},
      {"  positive: On the side that $\\vec n$ points to\n", "", 18,
       "answer: At the start “side” is “positive”, but there is no such choice. Add one."},
      {"f, side\n```\n", "f, side\n", 28,
       "The block that opens here is never closed. End it with a line ```."},
      {"{P0: [5, 4, 7], n:", "{P: [5, 4, 7], n:", 7, "scene[0].plane"},
      {"E, plane:", "E, plain:", 7, "scene[0]: It does not say what it is"},
      {"point: [11, 15, 8]", "point: [11, 15]", 8, "scene[1].point: Here three numbers are expected"},
      {"point: [11, 15, 8]", "point: {x: 11}", 8, "scene[1].point: Here three numbers are expected"},
      {"point: [11, 15, 8]", "point: [11, fifteen, 8]", 8, "scene[1].point: “fifteen” is not a number"},
      {"name: Q", "name: E", 8, "scene[1].name: The name “E” is taken"},
      {"signed-distance", "signed-distanse", 9,
       "scene[2].construction: There is no construction “signed-distanse”. Mend the name, or use a newer "
       "version of "
       "Halfspace. Perhaps “signed-distance” is meant."},
      {"{E: E, Q: Q}", "{E: E}", 9, "scene[2].of.Q: This construction looks at a point Q"},
      {"{E: E, Q: Q}", "{E: E, Q: R}", 9, "scene[2].of.Q: Above this entry there is no object “R”."},
      {"{E: E, Q: Q}", "{E: Q, Q: Q}", 9, "scene[2].of.E: Here a plane is expected, but “Q” is a point."},
      {"from: [1.25, -0.1, 0.6]", "from: [0, 0, 0]", 10, "camera.from: The camera cannot look"},
      {"height: 21", "height: -21", 10, "camera.height: The height of the view must"},
      {"between dollars", "as $\\frac{1$", 14, "In “\\frac{1”, column 6: A `}` is missing"},
      {"between dollars", "![a box](box.png)", 14, "There is no picture “box.png”"},
      {"between dollars", "![a box](../../etc/hostname)", 14, "The picture “../../etc/hostname” is not in"},
      {"between dollars", "![a box](base.md)", 14, "The picture “base.md” cannot be shown. It is neither"},
      {"answer: side", "answer: sides", 18, "answer: There is no value “sides”. Perhaps “side” is meant."},
      {"  on: Exactly", "  inside: Exactly", 22,
       "choices: “side” is never “inside”. It can be: positive, negative, on."},
      {"is now {f}", "is now {g}", 26, "There is no value “g”."},
      {"f, side", "f, sides", 29, "lines: There is no worked line “sides”. Perhaps “side” is meant."},
      {"The program notices", std::string(40, '>') + " The program notices", 34,
       "Lists and quotes are nested too"},
      {"```draw\nF\n", "```draw\nG\n", 41, "draw: There is no mark “G”."},
      {"```draw\nF\n", "```draw\nplane.F\n", 41, "draw: There is no mark “plane.F”. Perhaps “F” is meant."},
      {"```task", "```tusk", 44, "There is no block “tusk”. Perhaps “task” is meant."},
      {"signed_distance = 6", "signed_distanse = 6", 46,
       "when: There is no value “signed_distanse”. Perhaps “signed_distance” is meant."},
      {"signed_distance = 6", "signed_distance = six", 46,
       "when: “signed_distance” is a number, and never “six”."},
      {"signed_distance = 6", "signed_distance = cos_angle", 46,
       "when: “cos_angle” is a value too, and two values are not compared: compare “signed_distance” with a "
       "number."},
      {"signed_distance = 6", "signed_distance < length", 46,
       "when: “signed_distance < length” orders a word: < and > compare a value with a number, not with a "
       "word "
       "or another value."},
      {"ask: On which side of the plane is $Q$?", "ask: \"On which side of $\\lambda$ is $Q$?\"", 17,
       "This is not YAML as it should be: unknown escape character: l. In double quotes a backslash begins a "
       "sign of YAML's own: put the text in single quotes."},
      {"ask: On which side of the plane is $Q$?", "ask: \"On which side of $\\theta$ is $Q$?\"", 17,
       "ask: In double quotes a backslash begins a sign of YAML's own: put the text in single quotes."},
      {"signed_distance = 6", "side = upward", 46,
       "when: “side” is never “upward”. It can be: positive, negative, on."},
      {"signed_distance = 6", "signed_distance", 46, "when: “signed_distance” is not a comparison"},
      {"signed_distance = 6", "signed_distance == 6", 46,
       "when: “signed_distance == 6” is not a comparison: write it as side = negative, or t < 0, with and "
       "between two. Perhaps “signed_distance = 6” is meant."},
      {"signed_distance = 6", "signed_distance > 5,5 && side != on", 46,
       "when: “signed_distance > 5,5 && side != on” is not a comparison: write it as side = negative, or t < "
       "0, "
       "with and between two. Perhaps “signed_distance > 5.5 and side != on” is meant."},
  };
  return all;
}

TEST_F(Program, Lines_NamedNone_AreNone_AndPassTheCheck) {
  ASSERT_EQ(run("new-lesson base").status, 0);
  std::string text = contentOf(inFolder("base.md"));
  text.replace(text.find("f, side"), 7, "none");
  write("base.md", text);
  const Ran ran = run("check base.md");
  EXPECT_EQ(ran.status, 0) << ran.out;
}

/// Whether it begins so; `…` stands for what the library of YAML says, which is not the same everywhere.
bool tells(const std::string &out, const std::string &beginning) {
  const std::string reason = "…";
  const auto at = beginning.find(reason);
  return out.starts_with(beginning.substr(0, at)) &&
         (at == std::string::npos || out.find(beginning.substr(at + reason.size()), at) != std::string::npos);
}

TEST_F(Program, Check_OfALessonWithOneMistake_TellsItWithItsLineAndNothingElse) {
  ASSERT_EQ(run("new-lesson base").status, 0);
  const std::string base = contentOf(inFolder("base.md"));
  for (const Mistake &mistake : mistakes()) {
    const auto place = base.find(mistake.right);
    ASSERT_NE(place, std::string::npos) << mistake.right;
    write("base.md", std::string(base).replace(place, mistake.right.size(), mistake.wrong));
    const Ran ran = run("check base.md");
    EXPECT_EQ(ran.status, 1) << mistake.wrong;
    EXPECT_TRUE(tells(ran.out, "base.md:" + std::to_string(mistake.line) + ": " + mistake.told)) << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(Program, Check_OfALessonWithOneMistake_SaysNothingInEnglishToThoseWhoSpeakAnotherLanguage) {
  ASSERT_EQ(run("new-lesson base").status, 0);
  const std::string base = contentOf(inFolder("base.md"));
  std::string files;
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    const Mistake &mistake = mistakes()[i];
    const std::string file = "a" + std::to_string(i) + ".md";
    write(file, std::string(base).replace(base.find(mistake.right), mistake.right.size(), mistake.wrong));
    files += " " + file;
  }
  const Ran ran = run("check" + files, "HALFSPACE_LANGUAGE=pseudo");
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), std::ptrdiff_t(mistakes().size())) << ran.out;
  const std::regex place("^[^⟦]*");                         // in the file
  const std::regex reason("(YÁML ás ít shóúld bé: )[^.]*"); // from a library, which speaks English
  std::istringstream lines(ran.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_EQ(test::untranslatedIn(std::regex_replace(std::regex_replace(line, place, ""), reason, "$1")),
              std::vector<std::string>())
        << line;
}

TEST_F(Program, Check_OfPicturesThatAPageHasNoRoomFor_TellsThem_StepByStep) {
  ASSERT_EQ(run("new-lesson base").status, 0);
  QImage(4096, 4096, QImage::Format_Mono).save(QString::fromStdString(inFolder("large.png").string()));
  const std::string base = contentOf(inFolder("base.md"));
  const std::string two = "![a](large.png) ![b](large.png)\n";
  const std::string step = "\n## Pictures\n\n" + two + "```lines\nf\n```\n" + two;
  write("base.md", base + step + step);
  EXPECT_EQ(run("check base.md").out, "Nothing is wrong. Lessons: 1\n");
  write("base.md", base + step + "```lines\nf\n```\n![one more](large.png)\n" + step);
  const Ran ran = run("check base.md");
  EXPECT_NE(
      ran.out.find("The picture “large.png” cannot be shown. The pictures before it have so many pixels"),
      std::string::npos)
      << ran.out;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
}

TEST_F(Program, Check_OfPicturesThatAPageOnlyDescribes_TakesNoRoomForThem) {
  ASSERT_EQ(run("new-lesson base").status, 0);
  QImage(4096, 4096, QImage::Format_Mono).save(QString::fromStdString(inFolder("large.png").string()));
  std::string step = "\n## Pictures\n\n```task\ndo: Like ![a](large.png).\nwhen: side = on\n```\n"
                     "```predict\nask: Is it ![a](large.png)?\nanswer: side\n"
                     "choices: {on: '![a](large.png)', otherwise: '![a](large.png)'}\n"
                     "why: As ![a](large.png).\n```\n";
  for (int i = 0; i < 4; ++i)
    step += "![a](large.png)\n";
  write("base.md", contentOf(inFolder("base.md")) + step);
  EXPECT_EQ(run("check base.md").out, "Nothing is wrong. Lessons: 1\n");
}

TEST_F(Program, LessonFile_IsOpenedLikeALesson) {
  ASSERT_EQ(run("new-lesson my-first").status, 0);
  EXPECT_EQ(run("explain my-first.md").out, run("explain my-first --lessons .").out);
  EXPECT_EQ(run("explain my-first.md --set Q=5,4,8 --format json").status, 0);
  write("broken.md", "---\nid: broken\n---\n");
  const Ran broken = run("explain broken.md");
  EXPECT_EQ(broken.status, 2);
  EXPECT_TRUE(broken.err.starts_with("halfspace: broken.md:2: title:")) << broken.err;
  const std::string ours = contentOf(inFolder("my-first.md"));
  write("other.md", std::string(ours).replace(ours.find("my-first"), 8, "ray-sphere"));
  EXPECT_NE(run("explain other.md").out.find("My first lesson"), std::string::npos) << "the file comes first";
}

TEST_F(Program, NewLesson_OverAFile_OrWithNoId_IsRefused) {
  write("mine.md", "precious");
  expectRefused("new-lesson mine", "stays as it is");
  EXPECT_EQ(run("check mine.md").status, 1) << "and so it does";
  for (const std::string bad : {"Mine", "../mine", "a/b", "''", "'a: b'", "-- -x"})
    expectRefused("new-lesson " + bad, "cannot be the id of a lesson");
  expectRefused("new-lesson signed-distance",
                "A lesson of the program has the id “signed-distance” already.");
}

TEST_F(Program, OwnLessons_WithIdsOfOurs_OrInNoFolder_AreToldAndLeftOut) {
  std::filesystem::create_directory(inFolder("mine"));
  write("mine/a.md", "---\nid: signed-distance" + faultyLesson.substr(faultyLesson.find("\ntitle")));
  const Ran ran = run("lessons --lessons mine --lessons nowhere");
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.err.find("mine/a.md:2: id: Another lesson has the id “signed-distance”"), std::string::npos);
  EXPECT_NE(ran.err.find("nowhere: The folder of lessons cannot be read."), std::string::npos);
  EXPECT_EQ(ran.out.find("Faulty"), std::string::npos);
}

TEST_F(Program, Check_TellsWhatALessonNeeds_UnlessItIsBesideItOrOfOurs) {
  ASSERT_EQ(run("new-lesson first").status, 0);
  const std::string first = contentOf(inFolder("first.md"));
  const auto needing = [&](const std::string &ids) {
    return std::string(first)
        .replace(first.find("id: first"), 9, "id: second")
        .replace(first.find("sources") + 1, 11, "needs: [" + ids + "]");
  };
  write("second.md", needing("first, ray-sphere"));
  EXPECT_EQ(run("check second.md").status, 0);
  EXPECT_EQ(run("check .").status, 0);
  write("first.md", "---\nid: first\n---\n");
  EXPECT_EQ(run("check second.md").status, 0) << "it is there, with another mistake";
  write("second.md", needing("ray-sphere, fist"));
  EXPECT_EQ(run("check second.md").out,
            "second.md:5: needs: There is no lesson “fist”. Perhaps “first” is meant.\n");
  write("second.md", needing("second"));
  EXPECT_EQ(run("check second.md").out,
            "second.md:5: needs: The lesson cannot come before itself. Take this id away.\n");
}

TEST_F(Program, Check_OfACopyOfOurLessons_TellsOnlyTheSlipThatIsInIt) {
  std::filesystem::copy(TEST_LESSONS_FOLDER, inFolder("ours"), std::filesystem::copy_options::recursive);
  write("ours/ray-sphere.md", "no lesson\n");
  EXPECT_EQ(run("check ours").out,
            "ours/ray-sphere.md:1: A lesson begins with a line --- and its id, title and scene below it.\n");
}

TEST_F(Program, Check_OfNoFileAtAll_IsRefused) {
  const Ran ran = run("check ''");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.out, "There is no such file.\n");
}

TEST_F(Program, Check_OfAllOurLessonsElsewhere_FindsNothing) {
  EXPECT_EQ(run("check '" TEST_LESSONS_FOLDER "'").status, 0);
  EXPECT_EQ(run("check '" TEST_LESSONS_FOLDER "/ray-sphere.md'").status, 0);
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
