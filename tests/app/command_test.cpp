// The program as a shell meets it, without a display: what it prints, where, and with which exit status.
#include "tests/program_test.h"

#include <nlohmann/json.hpp>

#include <QImage>

#include <algorithm>

namespace halfspace {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

class Program : public ProgramTest {
protected:
  QImage picture(const std::string &name) const {
    return QImage(QString::fromStdString(inFolder(name).string()));
  }

  /// `arguments` as a shell reads them; `environment`: NAME=value in front. No display and no home.
  Ran run(const std::string &arguments, const std::string &environment = "") const {
    return shell("exec env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR -u QT_QPA_PLATFORM HOME='" +
                 folder().string() + "' " + environment + " '" HALFSPACE_PROGRAM "' " + arguments +
                 " >.out 2>.err </dev/null");
  }

  Json explained(const std::string &arguments) const {
    const Ran ran = run("explain --format json " + arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return Json::parse(ran.out);
  }

  /// Refused: status 2, nothing printed, and one sentence that says why.
  void expectRefused(const std::string &arguments, const std::string &reason,
                     const std::string &environment = "") const {
    SCOPED_TRACE(environment + " halfspace " + arguments);
    const Ran ran = run(arguments, environment);
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("halfspace: ") && (ran.err.ends_with(".\n") || ran.err.ends_with("?\n")))
        << ran.err;
    EXPECT_NE(ran.err.find(reason), std::string::npos) << ran.err;
  }
};

TEST_F(Program, Lessons_ListsIdsAndTitles) {
  const Ran ran = run("lessons");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_GE(std::count(ran.out.begin(), ran.out.end(), '\n'), 4);
  EXPECT_TRUE(ran.out.starts_with("plane-implicit  What equation does a plane have?\n")) << ran.out;
}

TEST_F(Program, LessonsAsJson_TellIdsTitlesStepsAndSources) {
  const Ran ran = run("lessons --json");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  const Json lessons = Json::parse(ran.out);
  ASSERT_EQ(lessons.size(), 4U);
  std::vector<std::string> ids;
  for (const Json &lesson : lessons) {
    ids.push_back(lesson.at("id"));
    EXPECT_FALSE(lesson.at("title").get<std::string>().empty());
    EXPECT_GE(lesson.at("steps").get<int>(), 5);
    EXPECT_FALSE(lesson.at("sources").empty());
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"plane-implicit", "signed-distance", "ray-plane-dot",
                                           "ray-triangle-perp"}));
}

TEST_F(Program, ExplainPlane_GivesItsCoefficientsExactly) {
  const Json json = explained("plane-implicit");
  EXPECT_EQ(json.at("lesson"), "plane-implicit");
  EXPECT_EQ(json.at("case"), "plane");
  EXPECT_EQ(json.at("values").at("coefficients").at("value"), (Json{1, 2, 2, -27}));
  EXPECT_EQ(json.at("values").at("coefficients").at("exact"), (Json{"1", "2", "2", "-27"}));
  EXPECT_EQ(json.at("values").at("normalized").at("exact"), (Json{"1/3", "2/3", "2/3", "-9"}));
}

TEST_F(Program, ExplainDistance_GivesSideDistanceAndFootExactly) {
  const Json json = explained("signed-distance");
  const Json &values = json.at("values");
  EXPECT_EQ(json.at("case"), "positive");
  EXPECT_EQ(values.at("f"), (Json{{"value", 30}, {"exact", "30"}}));
  EXPECT_EQ(values.at("signed_distance"), (Json{{"value", 10}, {"exact", "10"}}));
  EXPECT_EQ(values.at("side"), "positive");
  EXPECT_EQ(values.at("foot").at("exact"), (Json{"23/3", "25/3", "4/3"}));
  EXPECT_DOUBLE_EQ(values.at("foot").at("value").at(0).get<double>(), 23.0 / 3);
}

TEST_F(Program, ExplainRayAndPlane_IsBehindAtTheStartAndHitsWhenTurned) {
  const Json behind = explained("ray-plane-dot");
  EXPECT_EQ(behind.at("case"), "behind");
  EXPECT_EQ(behind.at("values").at("t").at("exact"), "-10/3");
  const Json hit = explained("ray-plane-dot --set r=1,-3,-2");
  EXPECT_EQ(hit.at("case"), "hit");
  EXPECT_EQ(hit.at("values").at("t").at("exact"), "10/3");
  EXPECT_DOUBLE_EQ(hit.at("values").at("t").at("value").get<double>(), 10.0 / 3);
}

TEST_F(Program, ExplainRayAndTriangle_HitsInside) {
  const Json json = explained("ray-triangle-perp");
  EXPECT_EQ(json.at("case"), "hit");
  EXPECT_EQ(json.at("values").at("location"), "interior");
  EXPECT_EQ(json.at("values").at("s").at("exact"), "1/4");
  EXPECT_EQ(json.at("values").at("t_triangle").at("exact"), "1/2");
  EXPECT_EQ(json.at("values").at("perp").at("uv").at("exact"), "68");
}

TEST_F(Program, ExplainAsJson_GivesEveryLineInLatexAndInPlainText) {
  const Json json = explained("signed-distance");
  ASSERT_GE(json.at("working").size(), 5U);
  for (const Json &line : json.at("working"))
    for (const char *piece : {"symbols", "numbers", "result", "text"})
      EXPECT_EQ(line.at(piece).get<std::string>().find("\\mark"), std::string::npos) << line;
  EXPECT_EQ(json.at("working").at(3).at("text"), "dist = f(Q)/|n| = 30/3 = 10");
}

TEST_F(Program, ExplainAsText_IsTheDefaultAndEndsWithTheCase) {
  const Ran ran = run("explain signed-distance");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_NE(ran.out.find("\nF = (23/3, 25/3, 4/3)\n"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("dist = f(Q)/|n| = 30/3 = 10\n"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find('\\'), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out, run("explain signed-distance --format text").out);
}

TEST_F(Program, ExplainAsText_CallsTheRaysParameterAsTheLinesDo) {
  const Ran ran = run("explain ray-triangle-perp");
  for (const char *part : {"\nλ = 3/2\n", "\nt = 1/2\n", "\nu·u = 80\n"})
    EXPECT_NE(ran.out.find(part), std::string::npos) << part << ran.out;
  EXPECT_EQ(ran.out.find("perp ="), std::string::npos) << ran.out;
  EXPECT_EQ(explained("ray-triangle-perp").at("values").at("t").at("exact"), "3/2");
}

TEST_F(Program, ExplainAsLatex_IsOneAlignedBlock) {
  const Ran ran = run("explain ray-plane-dot --format latex");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(ran.out.starts_with("\\paragraph{Where does a ray meet a plane?}\n\\begin{align*}\n"))
      << ran.out;
  EXPECT_NE(ran.out.find("\\end{align*}\n"), std::string::npos);
  EXPECT_EQ(ran.out.find("\\mark"), std::string::npos);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '{'), std::count(ran.out.begin(), ran.out.end(), '}'));
}

TEST_F(Program, ExplainDegenerateInput_SaysWhatIsWrongWithIt) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"plane-implicit --set n=0,0,0", "zero-normal"},
      {"signed-distance --set n=0,0,0", "zero-normal"},
      {"signed-distance --set Q=5,4,7", "on"},
      {"ray-plane-dot --set r=0,0,0", "zero-direction"},
      {"ray-plane-dot --set r=-2,-1,2", "parallel"},
      {"ray-plane-dot --set r=-2,-1,2 --set Q=5,4,7", "in-plane"},
      {"ray-triangle-perp --set P1=9,9,0", "coincident"},
      {"ray-triangle-perp --set P2=5,9,2", "collinear"},
      {"ray-triangle-perp --set r=0,0,0", "zero-direction"}};
  for (const auto &[arguments, name] : cases) {
    const Json json = explained(arguments);
    EXPECT_EQ(json.at("case"), name) << arguments;
    EXPECT_FALSE(json.at("description").get<std::string>().empty()) << arguments;
  }
}

TEST_F(Program, Set_TakesFullAndShortNamesFractionsAndDecimals) {
  const Json full = explained("signed-distance --set E.n=0,0,1 --set E.P0=0,0,1/3 --set Q=1,2,-1.5");
  EXPECT_EQ(full.at("values").at("signed_distance").at("exact"), "-11/6");
  EXPECT_EQ(full, explained("signed-distance --set n=0,0,1 --set P0=0,0,1/3 --set Q=1,2,-3/2"));
  EXPECT_EQ(full.at("case"), "negative");
}

TEST_F(Program, Set_WithoutANameOrANumber_IsRefused) {
  expectRefused("explain signed-distance --set X=1,2,3", "“X” is not one of the values here: P0, n, Q");
  expectRefused("explain signed-distance --set Q", "sets nothing");
  expectRefused("explain signed-distance --set Q=1,2", "takes three numbers");
  expectRefused("explain signed-distance --set Q=1,2,3,4", "takes three numbers");
  expectRefused("explain signed-distance --set Q=1,two,3", "“two” is not a number");
  expectRefused("explain signed-distance --set Q=1,1/0,3", "“1/0” is not a number");
  expectRefused("explain signed-distance --set Q=1,nan,3", "“nan” is not a number");
  expectRefused("explain signed-distance --set Q=1e300,2,3", "too large");
  expectRefused("explain signed-distance --set", "--set");
}

TEST_F(Program, Arguments_ThatItDoesNotKnow_AreRefused) {
  expectRefused("explain", "subject");
  expectRefused("explain signed-distance --format xml", "xml");
  expectRefused("lessons --yaml", "--yaml");
  expectRefused("render signed-distance", "--output");
  expectRefused("render signed-distance -o a.png --size 0x10", "--size");
  expectRefused("render signed-distance -o a.png --size wide", "--size");
  expectRefused("render signed-distance -o a.png --size 99999x99999", "--size");
  expectRefused("render signed-distance -o a.pdf", ".png");
  EXPECT_FALSE(fs::exists(inFolder("a.pdf")));
  expectRefused("render signed-distance -o a.png --theme neon", "neon");
  expectRefused("render signed-distance -o a.png --step 0", "--step");
  expectRefused("render signed-distance -o a.png --step 99", "--step");
}

TEST_F(Program, ALessonOrFileThatIsNotThere_IsRefused) {
  expectRefused("explain no-such-lesson", "There is no lesson “no-such-lesson”");
  expectRefused("render no-such-lesson -o a.png", "There is no lesson “no-such-lesson”");
  expectRefused("explain missing.halfspace", "missing.halfspace: There is no such file");
  expectRefused("explain /", "/: This is a folder, not a file");
  expectRefused("no-such-lesson", "There is no lesson “no-such-lesson”");
}

TEST_F(Program, ASessionFile_IsExplainedLikeALesson) {
  std::ofstream(inFolder("mine.halfspace"))
      << R"({"format":"halfspace","version":1,"lesson":"signed-distance",
    "step":0,"scene":[{"name":"E","plane":{"P0":["0","0","0"],"n":["0","0","2"]}},
    {"name":"Q","point":["1","2","-10/3"]},
    {"name":"d","construction":"signed-distance","of":{"E":"E","Q":"Q"}}]})";
  EXPECT_EQ(explained("mine.halfspace").at("values").at("signed_distance").at("exact"), "-10/3");
  EXPECT_EQ(explained("mine.halfspace --set Q=0,0,7").at("values").at("signed_distance").at("exact"), "7");
}

TEST_F(Program, ADamagedSessionFile_IsRefusedWithItsPlace) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "bad.halfspace"},
      {"{\"format\":\"halfspace\",", "bad.halfspace"},
      {std::string("\0\xff\xfe PNG", 7), "bad.halfspace"},
      {R"({"format":"halfspace","version":99,"lesson":"x","step":0,"scene":[]})", "version"},
      {R"({"format":"halfspace","version":1,"lesson":"signed-distance","step":0,
           "scene":[{"name":"Q","point":["1","2"]}]})",
       "scene[0].point"},
      {R"({"format":"halfspace","version":1,"lesson":"signed-distance","step":0,
           "scene":[{"name":"d","construction":"no-such","of":{}}]})",
       "no-such"}};
  for (const auto &[text, reason] : cases) {
    write("bad.halfspace", text);
    expectRefused("explain bad.halfspace", reason);
    expectRefused("render bad.halfspace -o a.png", reason);
    expectRefused("bad.halfspace", reason);
  }
  EXPECT_FALSE(fs::exists(inFolder("a.png")));
}

TEST_F(Program, Render_WritesAnOpaquePictureOfTheSizeAskedFor) {
  const Ran ran = run("render signed-distance -o plain.png --size 320x200");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out + ran.err, "");
  const QImage plain = picture("plain.png");
  EXPECT_EQ(plain.size(), QSize(320, 200));
  EXPECT_EQ(plain.pixelColor(0, 0).alpha(), 255);
}

TEST_F(Program, RenderTransparent_LeavesTheBackgroundClearAndTheFigureSolid) {
  const Ran ran = run("render ray-triangle-perp -o clear.png --size 160x100 --transparent");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out + ran.err, "");
  const QImage clear = picture("clear.png");
  EXPECT_EQ(clear.pixelColor(0, 0).alpha(), 0);
  int most = 0;
  for (int y = 0; y < clear.height(); ++y)
    for (int x = 0; x < clear.width(); ++x)
      most = std::max(most, clear.pixelColor(x, y).alpha());
  EXPECT_EQ(most, 255);
}

TEST_F(Program, RenderStep_DrawsLessThanTheWholeFigure) {
  EXPECT_EQ(run("render ray-triangle-perp -o whole.png --size 160x100").status, 0);
  EXPECT_EQ(run("render ray-triangle-perp -o step.png --size 160x100 --step 1").status, 0);
  EXPECT_EQ(picture("step.png").width(), 160);
  EXPECT_NE(contentOf(inFolder("whole.png")), contentOf(inFolder("step.png")));
}

TEST_F(Program, RenderSet_DrawsTheChangedScene) {
  EXPECT_EQ(run("render signed-distance -o start.png --size 160x100").status, 0);
  EXPECT_EQ(run("render signed-distance -o again.png --size 160x100").status, 0);
  EXPECT_EQ(run("render signed-distance -o moved.png --size 160x100 --set Q=1,1,1").status, 0);
  EXPECT_EQ(contentOf(inFolder("start.png")), contentOf(inFolder("again.png")));
  EXPECT_NE(contentOf(inFolder("start.png")), contentOf(inFolder("moved.png")));
}

TEST_F(Program, RenderWhereNothingCanBeWritten_IsRefused) {
  expectRefused("render signed-distance -o no-such-folder/a.png --size 64x64", "no-such-folder/a.png");
  expectRefused("render signed-distance -o . --size 64x64", "cannot be written");
}

TEST_F(Program, HelpAndVersion_ArePrinted) {
  const Ran help = run("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const char *command : {"lessons", "explain", "render"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
  const Ran explainHelp = run("explain --help");
  EXPECT_EQ(explainHelp.status, 0);
  EXPECT_NE(explainHelp.out.find("--format"), std::string::npos);
  const Ran version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("halfspace ")) << version.out;
  EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1);
}

TEST_F(Program, TheWindow_WithoutADisplay_IsRefusedWithOneSentence) {
  expectRefused("", "needs a display");
  expectRefused("signed-distance", "needs a display");
  expectRefused("", "needs a display", "DISPLAY=:9999");
  expectRefused("signed-distance", "needs a display", "WAYLAND_DISPLAY=wayland-9999");
}

} // namespace
} // namespace halfspace
