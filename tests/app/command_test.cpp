// The program as a shell meets it, without a display: what it prints, where, and with which exit status.
#include "tests/app/command_fixture.h"

#include <array>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <vector>

namespace halfspace {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Whether a terminal would be steered, or sentences turned, by characters that a file has put in.
bool isHarmless(const std::string &text) {
  const std::array<std::string, 4> harmful{"\x1B", "\x07", "\xC2\x9B", "\u202E"};
  return std::none_of(harmful.begin(), harmful.end(), [&](const std::string &character) {
    return text.find(character) != std::string::npos;
  });
}

/// A session file of these fields, which are JSON.
std::string sessionWith(const std::string &lesson, const std::string &step, const std::string &scene = "[]") {
  return R"({"format":"halfspace","version":1,"lesson":)" + lesson + R"(,"step":)" + step + R"(,"scene":)" +
         scene + "}";
}

TEST_F(Program, Lessons_ListsIdsAndTitles) {
  const Ran ran = run("lessons");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_GE(std::count(ran.out.begin(), ran.out.end(), '\n'), 4);
  EXPECT_TRUE(ran.out.starts_with("line-ray-segment  Which points does A + t v reach?\n")) << ran.out;
}

TEST_F(Program, LessonsAsJson_TellIdsTitlesStepsAndSources) {
  const Ran ran = run("lessons --json");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  const Json lessons = Json::parse(ran.out);
  ASSERT_GE(lessons.size(), 6U);
  std::vector<std::string> ids;
  for (const Json &lesson : lessons) {
    ids.push_back(lesson.at("id"));
    EXPECT_FALSE(lesson.at("title").get<std::string>().empty());
    EXPECT_GE(lesson.at("steps").get<int>(), 3);
    EXPECT_TRUE(lesson.at("sources").is_array()); // the notes teach most of them, not all
  }
  EXPECT_EQ(ids[0], "line-ray-segment");
  EXPECT_EQ(lessons.at(0).at("chapter"), "Tools");
  EXPECT_EQ(lessons.at(1).at("needs").at(0), "line-ray-segment");
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
  EXPECT_EQ(json.at("working").at(5).at("text"), "dist = f(Q)/|n| = 30/3 = 10");
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

TEST_F(Program, ExplainAsMathMl_IsASectionOfAPage) {
  const Ran ran = run("explain ray-plane-dot --format mathml");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(ran.out.starts_with("<section>\n<h2>Where does a ray meet a plane?</h2>\n<p><math "))
      << ran.out;
  EXPECT_TRUE(ran.out.ends_with("</p>\n</section>\n")) << ran.out;
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

TEST_F(Program, Set_BeyondWhatIsRead_SaysWhetherTheNumberIsTooLargeOrTooLong) {
  for (const char *number : {"1e401", "-1e401", "1e10", "1e99999999999", "12345678901"})
    expectRefused("explain signed-distance --set Q=" + std::string(number) + ",0,0", "too large");
  for (const char *number : {"1e-401", "1e-400", "1e-99999999999"})
    expectRefused("explain signed-distance --set Q=" + std::string(number) + ",0,0", "too long");
}

TEST_F(Program, Set_BeforeTheSubject_TakesOneValueOnly) {
  EXPECT_EQ(explained("--set Q=1,2,3 signed-distance"), explained("signed-distance --set Q=1,2,3"));
  EXPECT_EQ(run("render --set Q=1,2,3 signed-distance -o before.png --size 64x64").status, 0);
  EXPECT_EQ(run("render signed-distance -o after.png --size 64x64 --set Q=1,2,3").status, 0);
  EXPECT_EQ(picture("before.png").size(), QSize(64, 64));
  EXPECT_EQ(contentOf(inFolder("before.png")), contentOf(inFolder("after.png")));
}

TEST_F(Program, AMeshForACommand_IsRefused) {
  expectRefused("render photon-torpedo --mesh ball.stl -o a.png", "--mesh is for the window");
  expectRefused("--mesh ball.stl explain photon-torpedo", "--mesh is for the window");
}

TEST_F(Program, ASubjectInFrontOfACommand_IsRefused) {
  expectRefused("signed-distance lessons", "stands before a command");
  expectRefused("signed-distance explain ray-plane-dot", "stands before a command");
}

TEST_F(Program, AnEmptySubject_IsNoLesson) {
  expectRefused("explain ''", "There is no lesson “”");
  expectRefused("render '' -o a.png", "There is no lesson “”");
  expectRefused("''", "There is no lesson “”");
}

TEST_F(Program, Arguments_ThatItDoesNotKnow_AreRefused) {
  expectRefused("explain", "Say what to explain: a lesson, a file, or lines with --typed.");
  expectRefused("explain signed-distance --format xml", "xml");
  expectRefused("lessons --yaml", "--yaml");
  expectRefused("explin ray-sphere", "Perhaps the command “explain” is meant. Try halfspace --help.");
  expectRefused("render signed-distance", "--output");
  expectRefused("render signed-distance -o a.png --size 0x10", "--size");
  expectRefused("render signed-distance -o a.png --size wide", "--size");
  expectRefused("render signed-distance -o a.png --size 99999x99999", "--size");
  expectRefused("render signed-distance -o a.doc", ".png, .svg, .pdf, .tex");
  EXPECT_FALSE(fs::exists(inFolder("a.pdf")));
  expectRefused("render signed-distance -o a.png --theme neon", "neon");
  expectRefused("render signed-distance -o a.png --step 0", "--step");
  expectRefused("render signed-distance -o a.png --step 99", "--step");
}

TEST_F(Program, ALessonOrFileThatIsNotThere_IsRefused) {
  expectRefused("explain no-such-lesson", "There is no lesson “no-such-lesson”");
  expectRefused("explain signed-distanze", "Perhaps “signed-distance” is meant.");
  for (const char *name : {"a", "-"})
    expectRefused(std::string("render signed-distance -o ") + name, "let the name end in .png");
  expectRefused("render no-such-lesson -o a.png", "There is no lesson “no-such-lesson”");
  expectRefused("explain missing.halfspace", "missing.halfspace: There is no such file");
  expectRefused("explain /", "/: This is a folder, not a file");
  expectRefused("no-such-lesson", "There is no lesson “no-such-lesson”");
}

TEST_F(Program, WhatIsNoFile_IsNamedAsWhatItIsAndNotWaitedFor) {
  fs::create_directory(inFolder("folder"));
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", inFolder("zero.halfspace"));
  expectRefused("explain folder", "folder: This is a folder, not a file.");
  for (const char *name : {"pipe", "./pipe", "zero.halfspace", "/dev/null"}) {
    expectRefused("explain " + std::string(name), "This is a device, a pipe or a socket, not a file.");
    expectRefused("render -o a.png " + std::string(name),
                  "This is a device, a pipe or a socket, not a file.");
  }
}

TEST_F(Program, ALessonThatIsNoText_IsToldWithItsLineAndTheOthersAreListed) {
  addLesson("---\nid: added\ntitle: A\xFF\n---\n## Step\n");
  for (const char *arguments : {"lessons", "lessons --json"}) {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.out.find("signed-distance"), std::string::npos);
    EXPECT_EQ(ran.out.find("added"), std::string::npos);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find("added.md:3: The file holds bytes here that are no text"), std::string::npos)
        << ran.err;
  }
  EXPECT_EQ(Json::parse(run("lessons --json").out).size(), 1U);
}

TEST_F(Program, ALessonThatWouldSteerTheTerminal_DoesNot) {
  // YAML spells in plain letters what the file itself may not hold.
  const std::string steering = R"("T\e[31m\x9B31m\a\u202E")";
  addLesson("---\nid: added\ntitle: " + steering + "\nsources: [" + steering +
            "]\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## Step\n");
  for (const char *arguments : {"lessons", "lessons --json", "explain added", "explain added --format latex",
                                "explain added --format json"}) {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(isHarmless(ran.out + ran.err)) << arguments;
  }
  EXPECT_NE(run("lessons").out.find("added  T\uFFFD[31m\uFFFD31m\uFFFD\uFFFD\n"), std::string::npos);
}

TEST_F(Program, ASessionThatWouldSteerTheTerminal_DoesNot) {
  const std::string steering = R"("T\u001b[31m\u009b\u0007\u202e")";
  const std::vector<std::string> sessions{
      sessionWith(steering, "0"),
      sessionWith("\"x\"", steering),
      sessionWith("\"x\"", "0", "[{\"name\":" + steering + ",\"point\":[1,2,3]}]"),
      sessionWith("\"x\"", "0", "[{\"name\":\"Q\",\"point\":[1,2," + steering + "]}]"),
      sessionWith("\"x\"", "0", "[{\"name\":\"Q\"," + steering + ":[1,2,3]}]"),
      sessionWith("\"x\"", "0", "[{\"name\":\"Q\",\"construction\":" + steering + ",\"of\":{}}]"),
      sessionWith("\"x\"", "0",
                  "[{\"name\":\"d\",\"construction\":\"signed-distance\",\"of\":{" + steering +
                      ":\"Q\",\"E\":" + steering + "}}]"),
      "{" + steering + ":1}"};
  for (const std::string &session : sessions) {
    write("a.halfspace", session);
    expectRefused("explain a.halfspace", "a.halfspace");
    EXPECT_TRUE(isHarmless(contentOf(inFolder(".err")))) << contentOf(inFolder(".err"));
  }
}

TEST_F(Program, ArgumentsThatWouldSteerTheTerminal_DoNot) {
  const std::string steering = "'\x1B[31m\xC2\x9B\x07\u202E'";
  for (const std::string &arguments :
       {"explain " + steering, "explain ./" + steering,
        "explain signed-distance --set " + steering + "=1,2,3",
        "explain signed-distance --set Q=1,2," + steering, "--" + steering,
        "render signed-distance --size 64x64 -o no/" + steering, steering, "eval " + steering}) {
    expectRefused(arguments, "");
    EXPECT_TRUE(isHarmless(contentOf(inFolder(".err")))) << arguments;
  }
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

TEST_F(Program, Render_LeavesShadowsOut_WhereTheLessonHasNone) {
  const std::string lesson = contentOf(TEST_LESSONS_FOLDER "/signed-distance.md");
  const std::string camera = "\ncamera:";
  write("shaded.md", lesson);
  write("plain.md",
        std::string(lesson).replace(lesson.find(camera), camera.size(), "\nshadows: false" + camera));
  EXPECT_EQ(run("render shaded.md -o shaded.png --size 160x100").status, 0);
  EXPECT_EQ(run("render plain.md -o plain.png --size 160x100").status, 0);
  EXPECT_NE(contentOf(inFolder("shaded.png")), contentOf(inFolder("plain.png")));
}

TEST_F(Program, RenderFrames_AreTheSameForTheSameSeed_AndThoseDrawnOneByOne) {
  const std::string flight = "render photon-torpedo --size 160x100 --set seed=7";
  for (const char *folder : {"first", "again"}) {
    std::filesystem::create_directory(inFolder(folder));
    EXPECT_EQ(run(flight + " --frames 160:162 -o " + folder + "/%03d.png").status, 0);
  }
  for (const char *name : {"160.png", "161.png", "162.png"})
    EXPECT_EQ(contentOf(inFolder("first") / name), contentOf(inFolder("again") / name)) << name;
  EXPECT_NE(contentOf(inFolder("first/160.png")), contentOf(inFolder("first/161.png")));
  EXPECT_EQ(run(flight + " --frame 162 -o one.png").status, 0);
  EXPECT_EQ(contentOf(inFolder("one.png")), contentOf(inFolder("first/162.png")));
  EXPECT_EQ(run(flight + "8 --frame 162 -o other.png").status, 0);
  EXPECT_NE(contentOf(inFolder("other.png")), contentOf(inFolder("one.png")));
}

TEST_F(Program, RenderFrame_WithoutAStep_DrawsTheStepOfTheFlight) {
  const std::string flight = "render photon-torpedo --size 160x100 --frame 40 ";
  EXPECT_EQ(run(flight + "-o flight.png").status, 0);
  EXPECT_EQ(run(flight + "--step 7 -o seventh.png").status, 0);
  EXPECT_EQ(run(flight + "--step 2 -o second.png").status, 0);
  EXPECT_EQ(contentOf(inFolder("flight.png")), contentOf(inFolder("seventh.png")));
  EXPECT_NE(contentOf(inFolder("flight.png")), contentOf(inFolder("second.png")));
}

TEST_F(Program, RenderFrame_ThatIsNotThere_IsRefused) {
  expectRefused("render photon-torpedo --frame 601 -o a.png", "the nearest is 600");
  expectRefused("render photon-torpedo --frames 590:601 -o %d.png", "the nearest is 600");
  EXPECT_FALSE(std::filesystem::exists(inFolder("590.png")));
  expectRefused("render signed-distance --frame 1 -o a.png", "no flight");
  expectRefused("render photon-torpedo --frames 0:3 -o a.png", "%04d");
  expectRefused("render photon-torpedo --frames 3:0 -o %d.png", "--frames");
}

TEST_F(Program, RenderFrame_ThatIsEmpty_IsRefused) {
  expectRefused("render photon-torpedo --frames '' -o x%04d.png", "--frames");
  expectRefused("render photon-torpedo --frame '' -o x%04d.png", "--frame");
  EXPECT_FALSE(fs::exists(inFolder("x%04d.png")));
}

TEST_F(Program, RenderOfASessionFile_DrawsItsStepAndItsView) {
  const std::string begin = R"({"format":"halfspace","version":1,"lesson":"signed-distance","step":)";
  const std::string scene = R"(,"scene":[{"name":"E","plane":{"P0":["5","4","7"],"n":["1","2","2"]}},
    {"name":"Q","point":["11","15","8"]},
    {"name":"distance","construction":"signed-distance","of":{"E":"E","Q":"Q"}}])";
  write("first.halfspace", begin + "0" + scene + "}");
  write("third.halfspace", begin + "2" + scene + "}");
  write("seen.halfspace",
        begin + "2" + scene + R"(,"view":{"from":[0,0,1],"at":[6,8,4],"height":30,"orthographic":true}})");
  for (const std::string name : {"first", "third", "seen"})
    EXPECT_EQ(run("render " + name + ".halfspace --size 160x100 -o " + name + ".png").status, 0);
  EXPECT_EQ(run("render signed-distance --step 3 --size 160x100 -o step.png").status, 0);
  EXPECT_EQ(run("render first.halfspace --step 3 --size 160x100 -o asked.png").status, 0);
  const auto drawn = [this](const std::string &name) { return contentOf(inFolder(name + ".png")); };
  EXPECT_EQ(drawn("third"), drawn("step"));
  EXPECT_EQ(drawn("asked"), drawn("step"));
  EXPECT_NE(drawn("first"), drawn("third"));
  EXPECT_NE(drawn("seen"), drawn("third"));
}

TEST_F(Program, InAFolderThatIsGone_DoesWhatCanBeDone_AndEndsInOrder) {
  const auto ranThere = [this](const std::string &arguments) {
    return shell("there=$PWD && mkdir gone && cd gone && rmdir ../gone && exec env HOME=/ '" HALFSPACE_PROGRAM
                 "' " +
                 arguments + " >$there/.out 2>$there/.err");
  };
  EXPECT_EQ(ranThere("lessons").status, 0);
  const Ran written = ranThere("new-lesson mine");
  EXPECT_EQ(written.status, 2);
  EXPECT_EQ(written.err, "halfspace: mine.md: This cannot be written: there is no such folder.\n");
}

TEST_F(Program, RenderFlatWithoutEnoughMemory_IsRefused) {
  const Ran ran = shell("ulimit -v 1500000 && exec env HOME=/ '" HALFSPACE_PROGRAM
                        "' render ray-plane-picture --flat --size 16000x16000 -o a.png >.out 2>.err");
  EXPECT_EQ(ran.status, 2);
  EXPECT_TRUE(ran.err.ends_with("halfspace: a.png: There is not enough memory for this picture.\n"))
      << ran.err;
}

TEST_F(Program, Eval_OfAPipeThatNobodyWritesTo_SaysThatItWaits_AndAnswersThen) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  const Ran ran = shell("{ '" HALFSPACE_PROGRAM "' eval pipe >.out 2>.err & "
                        "until grep -q waiting .err 2>/dev/null; do sleep 0.1; done; "
                        "echo '{}' >pipe; wait $!; }");
  EXPECT_EQ(ran.status, 1) << ran.err; // a question without a kind
  EXPECT_EQ(ran.err,
            "halfspace: pipe: Nothing has come out of this pipe yet: waiting for whoever writes to it.\n");
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
}

TEST_F(Program, RenderSet_DrawsTheChangedScene) {
  EXPECT_EQ(run("render signed-distance -o start.png --size 160x100").status, 0);
  EXPECT_EQ(run("render signed-distance -o again.png --size 160x100").status, 0);
  EXPECT_EQ(run("render signed-distance -o moved.png --size 160x100 --set Q=1,1,1").status, 0);
  EXPECT_EQ(contentOf(inFolder("start.png")), contentOf(inFolder("again.png")));
  EXPECT_NE(contentOf(inFolder("start.png")), contentOf(inFolder("moved.png")));
}

class RenderOnto : public Program {
protected:
  const std::string small = "render signed-distance --size 64x64 -o ";

  void SetUp() override {
    Program::SetUp();
    ASSERT_EQ(run(small + "plain.png").status, 0);
    m_plain = contentOf(inFolder("plain.png"));
    ASSERT_FALSE(m_plain.empty());
  }
  void expectDrawn(const std::string &name) const {
    const Ran ran = run(small + name);
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.out + ran.err, "");
  }
  const std::string &plain() const { return m_plain; }

private:
  std::string m_plain;
};

TEST_F(RenderOnto, ALink_ChangesItsTargetAndKeepsTheLink) {
  fs::create_directory(inFolder("there"));
  write("there/a.png", "old");
  fs::create_symlink("there/a.png", inFolder("link.png"));
  expectDrawn("link.png");
  EXPECT_EQ(contentOf(inFolder("there/a.png")), plain());
  EXPECT_EQ(fs::read_symlink(inFolder("link.png")), "there/a.png");
}

TEST_F(RenderOnto, APipeThatIsRead_GivesItThePicture) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  expectRefused(small + "pipe", "pipe: This cannot be written: nobody reads from it");
  const int reader = open(inFolder("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  expectDrawn("pipe");
  std::string got(plain().size() + 1, '\0');
  const auto count = read(reader, got.data(), got.size());
  close(reader);
  EXPECT_EQ(count, static_cast<ssize_t>(plain().size()));
  EXPECT_TRUE(got.starts_with(plain()));
  EXPECT_TRUE(fs::is_fifo(inFolder("pipe")));
}

TEST_F(RenderOnto, ADevice_LeavesItOne) {
  expectRefused(small + "/dev/full", "there is no room left on the disk");
  if (mknod(inFolder("null").c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) { // only root may
    expectDrawn("null");
    EXPECT_TRUE(fs::is_character_file(inFolder("null")));
  }
}

TEST_F(RenderOnto, AReadOnlyFile_IsRefusedAndUnchanged) {
  write("a.png", "old");
  ASSERT_EQ(chmod(inFolder("a.png").c_str(), 0444), 0);
  expectRefused(small + "a.png", "a.png: This cannot be written: it is read-only");
  EXPECT_EQ(contentOf(inFolder("a.png")), "old");
}

TEST_F(RenderOnto, AFileBesideAPlantedLink_LeavesAloneWhereThatLeads) {
  write("victim", "mine");
  for (const char *name : {"a.png.part", "a.part", ".a.png.part", "a.png.tmp", "a.png~"})
    fs::create_symlink("victim", inFolder(name));
  expectDrawn("a.png");
  EXPECT_EQ(contentOf(inFolder("a.png")), plain());
  EXPECT_EQ(contentOf(inFolder("victim")), "mine");
}

TEST_F(Program, RenderBeyondTheLargestFileAllowed_IsRefused) {
  expectRefused("render signed-distance -o a.png --size 160x100", "the file would be larger than it may be",
                "prlimit --fsize=1000");
  EXPECT_FALSE(fs::exists(inFolder("a.png")));
}

/// In seconds of processor time and bytes of memory: six times what the largest scene takes.
constexpr const char *limits = "prlimit --cpu=8 --as=4294967296";

TEST_F(Program, RenderOfARayAlmostAlongItsPlane_EndsWithinLimits) {
  const Ran ran = run("render ray-plane-dot --set P0=0,0,0 --set n=0,0,1 --set Q=1,1,1 --set r=1,0,-1e-20 "
                      "-o a.png --size 160x100",
                      limits);
  EXPECT_EQ(ran.status, 0) << ran.err;
}

TEST_F(Program, RenderOfAsManyObjectsAsAreRead_EndsWithinLimits) {
  const auto number = [](int i) { return std::to_string(i * 7919 % 25 - 12); };
  const auto vector = [&](int i) { return Json{number(i), number(3 * i + 1), number(5 * i + 2)}; };
  for (const std::string kind : {"triangle", "plane"}) {
    Json scene = Json::array();
    for (int i = 0; i < 1000; ++i) {
      const std::string name = "O" + std::to_string(i);
      if (kind == "plane")
        scene.push_back(
            {{"name", name}, {"plane", {{"P0", vector(i)}, {"n", {"1", number(i), number(2 * i)}}}}});
      else
        scene.push_back({{"name", name},
                         {"triangle", {{"P0", vector(i)}, {"P1", vector(i + 400)}, {"P2", vector(i + 77)}}}});
    }
    write("many.halfspace",
          Json{{"format", "halfspace"}, {"version", 1}, {"lesson", "many"}, {"step", 0}, {"scene", scene}}
              .dump());
    const Ran ran = run("render many.halfspace -o " + kind + ".png --size 160x100", limits);
    EXPECT_EQ(ran.status, 0) << kind << " " << ran.err;
    EXPECT_EQ(picture(kind + ".png").width(), 160);
  }
}

TEST_F(Program, RenderOfVeryManyTrianglesOneBehindAnother_EndsWithinLimits_AndSaysWhatItLeavesOut) {
  Json scene = Json::array();
  for (int i = 0; i < 1000; ++i)
    scene.push_back(
        {{"name", "T" + std::to_string(i)},
         {"triangle", {{"P0", {"0", "0", "1"}}, {"P1", {"20", "0", "1"}}, {"P2", {"0", "20", "1"}}}}});
  write("stack.halfspace",
        Json{{"format", "halfspace"}, {"version", 1}, {"lesson", "stack"}, {"step", 0}, {"scene", scene}}
            .dump());
  const Ran ran = run("render stack.halfspace -o stack.png --size 640x400", limits);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("So many surfaces"), std::string::npos) << ran.err;
  EXPECT_EQ(picture("stack.png").width(), 640);
}

TEST_F(Program, RenderWhereNothingCanBeWritten_IsRefused) {
  expectRefused("render signed-distance -o no-such-folder/a.png --size 64x64", "no-such-folder/a.png");
  expectRefused("render signed-distance -o . --size 64x64", "cannot be written");
}

TEST_F(Program, ReadMesh_IsInNoHelpAndWritesTheMeshForTheWindow) {
  EXPECT_EQ(run("--help").out.find("read-mesh"), std::string::npos);
  write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Ran ran = run("read-mesh one.obj");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(ran.out.starts_with("halfspace mesh 1\n")) << ran.out;
  const Ran refused = run("read-mesh none.obj");
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(refused.out.starts_with("halfspace mesh 1\nE")) << refused.out;
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

TEST_F(Program, WhereNothingCanBePrinted_SaysSoAndEndsWithTwo) {
  for (const char *arguments :
       {"lessons", "lessons --json", "explain signed-distance", "explain signed-distance --format latex",
        "explain signed-distance --format json", "--help", "explain --help", "--version"})
    for (const auto &[out, reason] :
         {std::pair{">/dev/full", "there is no room left on the disk"}, {">&-", ""}}) {
      SCOPED_TRACE(std::string(arguments) + out);
      const Ran ran = runWith("2>.err </dev/null " + std::string(out), arguments);
      EXPECT_EQ(ran.status, 2);
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
      EXPECT_TRUE(ran.err.starts_with("halfspace: Standard output cannot be written: ")) << ran.err;
      EXPECT_NE(ran.err.find(reason), std::string::npos) << ran.err;
    }
}

TEST_F(Program, WithoutStandardStreams_DoesWhatCanBeDone) {
  EXPECT_EQ(runWith(">&- 2>&- <&-", "lessons").status, 2);
  EXPECT_EQ(runWith(">&- 2>&- <&-", "explain no-such-lesson").status, 2);
  EXPECT_EQ(runWith(">&- 2>&- <&-", "render signed-distance --size 64x64 -o a.png").status, 0);
  EXPECT_EQ(picture("a.png").size(), QSize(64, 64));
}

TEST_F(Program, TheWindow_WithoutADisplay_IsRefusedWithOneSentence) {
  expectRefused("", "needs a display");
  expectRefused("signed-distance", "needs a display");
  expectRefused("", "needs a display", "DISPLAY=:9999");
  // Without this folder Wayland's library complains of its own.
  expectRefused("signed-distance", "needs a display",
                "WAYLAND_DISPLAY=wayland-9999 XDG_RUNTIME_DIR='" + folder().string() + "'");
}

} // namespace
} // namespace halfspace
