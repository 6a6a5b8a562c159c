#include "lessons/scene/file/session_file.h"
#include "lessons/scene/scene_checker.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const std::string file = "my.halfspace";

Session startSession() { return {"signed-distance", 2, distanceScene()}; }

/// A session file around a scene.
std::string around(const std::string &scene) {
  return R"({"format":"halfspace","version":1,"lesson":"x","step":0,"scene":)" + scene + "}";
}

/// A session file with a view, which stands in the second line.
std::string withView(const std::string &view) {
  return R"({"format":"halfspace","version":3,"lesson":"x","step":0,"scene":[],
"view":)" +
         view + "}";
}

/// The problem of a text that must not be read; with a sentence, and with the file's name.
Problem problemOf(const std::string &text) {
  const auto session = readSession(text, file);
  if (session) {
    ADD_FAILURE() << "was read: " << text.substr(0, 200);
    return {};
  }
  EXPECT_GE(session.problem().sentence.size(), 15U);
  EXPECT_EQ(session.problem().file, file);
  return session.problem();
}

bool mentions(const Problem &problem, const std::string &words) {
  return problem.sentence.find(words) != std::string::npos;
}

TEST(SessionFile, WrittenAndReadAgain_IsTheSameSession) {
  Session session = startSession();
  session.scene.entries.push_back(rayL());
  session.scene.entries.push_back(triangleT());
  setCoordinate(session.scene, {"Q", 0}, {q(-10, 3), q(1, 1000), q(7)});
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
}

TEST(SessionFile, ColorOfAnObject_IsKept_AndNoneIsNotWritten) {
  Session session = startSession();
  EXPECT_EQ(writeSession(session).find("color"), std::string::npos);
  session.scene.entries.change(0, [](Entry &entry) { entry.color = Hue::Purple; });
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(again->scene.entries.front().color, Hue::Purple);
}

TEST(SessionFile, WhatIsHiddenOrLocked_IsKept_AndElseNotWritten) {
  Session session = startSession();
  EXPECT_EQ(writeSession(session).find("hidden"), std::string::npos);
  session.scene.entries.change(0, [](Entry &entry) { entry.isHidden = entry.isLocked = true; });
  session.scene.entries.change(2, [](Entry &entry) { entry.isHidden = true; });
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
  problemOf(around(R"([{"name":"Q","hidden":"perhaps","point":[1,2,3]}])"));
}

TEST(SessionFile, LinesAndLabels_AreKept_AndElseNotWritten) {
  Session session = startSession();
  EXPECT_EQ(writeSession(session).find("\"label\""), std::string::npos);
  session.scene.entries.change(0, [](Entry &entry) { entry.line = LineStyle::Dashed; });
  session.scene.entries.change(2, [](Entry &entry) { entry.label = LabelText::Value; });
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, session);
  problemOf(around(R"([{"name":"Q","stroke":"wavy","point":[1,2,3]}])"));
  problemOf(around(R"([{"name":"Q","label":"price","point":[1,2,3]}])"));
}

TEST(SessionFile, WithAColorThatIsNone_SaysWhichThereAre_AndGuesses) {
  const Problem problem = problemOf(around(R"([{"name":"Q","color":"purpel","point":[1,2,3]}])"));
  EXPECT_TRUE(mentions(problem, "“purpel” is none of these")) << problem.sentence;
  EXPECT_TRUE(mentions(problem, "green, purple, pink")) << problem.sentence;
  EXPECT_TRUE(mentions(problem, "“purple”")) << problem.sentence;
  EXPECT_EQ(problem.field, "scene[0].color");
  problemOf(around(R"([{"name":"Q","color":["blue"],"point":[1,2,3]}])"));
  problemOf(around(R"([{"name":"Q","color":3,"point":[1,2,3]}])"));
}

TEST(SessionFile, WithAColorOfWhatIsNotDrawn_IsNotRead) {
  const std::string number = R"("number":{"value":"1","from":"0","to":"2","step":"1"})";
  EXPECT_TRUE(readSession(around(R"([{"name":"k",)" + number + "}]"), file));
  problemOf(around(R"([{"name":"k","color":"blue",)" + number + "}]"));
}

TEST(SessionFile, View_IsKeptToAMillionth) {
  Session session = startSession();
  session.view = ChosenView{{{0.25, -1, 0.5}, {1.0 / 3, 2, -7}, 12.5}, true};
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  ASSERT_TRUE(again->view);
  EXPECT_EQ(again->view->view.from, session.view->view.from);
  EXPECT_NEAR(again->view->view.at.x, 1.0 / 3, 1e-6);
  EXPECT_EQ(again->view->view.at.z, -7);
  EXPECT_EQ(again->view->view.height, 12.5);
  EXPECT_TRUE(again->view->orthographic);
  session.view->orthographic = false;
  EXPECT_FALSE(readSession(writeSession(session), file)->view->orthographic);
}

TEST(SessionFile, WithoutAView_HasNone_AsThoseOfOlderVersions) {
  EXPECT_EQ(writeSession(startSession()).find("view"), std::string::npos);
  for (const char *version : {"1", "2", "3", "4", "5"}) {
    const auto session = readSession(
        std::string(R"({"format":"halfspace","lesson":"x","step":0,"scene":[],"version":)") + version + "}",
        file);
    ASSERT_TRUE(session) << session.problem().text();
    EXPECT_FALSE(session->view);
  }
}

TEST(SessionFile, BrokenView_IsRefusedWithLineAndField) {
  for (const auto &[view, field] : {std::pair(R"({"from":[0,0,0]})", "view.from"),
                                    {R"({"from":[1,2]})", "view.from"},
                                    {R"({"from":"top"})", "view.from"},
                                    {R"({"at":[1,2,"x"]})", "view.at"},
                                    {R"({"at":[1,2,"1e999"]})", "view.at"},
                                    {R"({"height":0})", "view.height"},
                                    {R"({"height":-3})", "view.height"},
                                    {R"({"height":"nan"})", "view.height"},
                                    {R"({"orthographic":"perhaps"})", "view.orthographic"},
                                    {R"({"zoom":2})", "view.zoom"},
                                    {"3", "view"}}) {
    const Problem problem = problemOf(withView(view));
    EXPECT_EQ(problem.field, field) << view;
    EXPECT_EQ(problem.line, 2) << view;
  }
}

/// A session file with labels by hand, which stand in the second line.
std::string withLabels(const std::string &labels) {
  return R"({"format":"halfspace","version":5,"lesson":"x","step":0,"scene":[{"name":"Q","point":[1,2,3]}],
"labels":)" +
         labels + "}";
}

TEST(SessionFile, LabelsThatWereMovedOrHidden_AreKept) {
  Session session = startSession();
  EXPECT_EQ(writeSession(session).find("labels"), std::string::npos);
  session.scene.labels = {{"E", {{}, true}},
                          {"Q", {LabelSpot{{1.5, -2.25}, LabelSpot::Side::Left}, false}},
                          {"distance.F", {LabelSpot{{-100, 0.01}, LabelSpot::Side::Right}, true}},
                          {"distance.F/angle", {LabelSpot{{0, 3}, LabelSpot::Side::Middle}, false}}};
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(again->scene.labels, session.scene.labels);
  EXPECT_EQ(*again, session);
}

TEST(SessionFile, OffsetsOfLabels_AreKeptToAHundredth) {
  Session session = startSession();
  session.scene.labels = {{"Q", {LabelSpot{{1.0 / 3, 1e9}}}}};
  const auto again = readSession(writeSession(session), file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(again->scene.labels.at("Q").spot->offset, glm::dvec2(0.33, mostLabelOffset));
  EXPECT_EQ(*readSession(writeSession(*again), file), *again);
}

TEST(SessionFile, LabelsThatSayNothing_AreNone) {
  for (const char *labels : {"{}", R"({"Q":{}})", R"({"Q":{"hidden":false}})", R"({"Q":{"side":"left"}})"}) {
    const auto session = readSession(withLabels(labels), file);
    ASSERT_TRUE(session) << session.problem().text();
    EXPECT_TRUE(session->scene.labels.empty()) << labels;
  }
}

TEST(SessionFile, BrokenLabels_AreRefusedWithLineAndField) {
  for (const auto &[labels, field] : {std::pair("3", "labels"),
                                      {"[]", "labels"},
                                      {R"({"Q":[1,2]})", "labels.Q"},
                                      {R"({"Q":3})", "labels.Q"},
                                      {R"({"R":{"hidden":true}})", "labels.R"},
                                      {R"({"":{"hidden":true}})", "labels"},
                                      {R"({"Q":{"at":[1]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[1,2,3]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[1,"x"]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[1,"1e999"]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[0,100.01]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[-101,0]}})", "labels.Q.at"},
                                      {R"({"Q":{"at":[0,1],"side":"top"}})", "labels.Q.side"},
                                      {R"({"Q":{"at":[0,1],"side":3}})", "labels.Q.side"},
                                      {R"({"Q":{"hidden":"perhaps"}})", "labels.Q.hidden"},
                                      {R"({"Q":{"color":"red"}})", "labels.Q.color"}}) {
    const Problem problem = problemOf(withLabels(labels));
    EXPECT_EQ(problem.field, field) << labels << ": " << problem.sentence;
    EXPECT_EQ(problem.line, 2) << labels;
  }
}

TEST(SessionFile, WithTooManyLabelsOrTooLongIds_IsRefused) {
  std::string labels = "{\"Q\":{\"hidden\":true}";
  for (std::size_t i = 0; i < mostLabelsByHand; ++i)
    labels += ",\"Q/" + std::to_string(i) + "\":{\"hidden\":true}";
  const Problem tooMany = problemOf(withLabels(labels + "}"));
  EXPECT_TRUE(mentions(tooMany, "at most 200 are read")) << tooMany.text();
  EXPECT_TRUE(mentions(problemOf(withLabels("{\"Q." + std::string(longestMarkId, 'n') + "\":{}}")),
                       "at most 200 bytes"));
}

TEST(Session, LookedAtFromElsewhere_IsTheSame) {
  Session session = startSession();
  session.view = ChosenView{};
  EXPECT_EQ(session, startSession());
}

TEST(SessionFile, Coordinates_AreExactTexts) {
  Session session = startSession();
  setCoordinate(session.scene, {"Q", 0}, {q(-10, 3), 15, 8});
  EXPECT_NE(writeSession(session).find("\"-10/3\""), std::string::npos);
}

TEST(SessionFile, NumbersWithoutQuotes_AreReadAsTheyAreSpelled) {
  const auto session = readSession(around(R"([{"name":"Q","point":[0.1,-2,1.5e-3]}])"), file);
  ASSERT_TRUE(session) << session.problem().text();
  EXPECT_EQ(coordinate(*findObject(session->scene, "Q"), 0), ExactVec3(q(1, 10), q(-2), q(3, 2000)));
}

TEST(SessionFile, CutOffAnywhere_IsAProblem) {
  const std::string whole = writeSession(startSession());
  for (std::size_t length = 0; length + 2 < whole.size(); ++length)
    problemOf(whole.substr(0, length));
}

TEST(SessionFile, DamagedInTheThirdLine_SaysSo) {
  EXPECT_EQ(problemOf("{\n\"format\": \"halfspace\",\n\"version\": @\n}").line, 3);
}

TEST(SessionFile, OfAnotherProgram_SaysThatItIsNone) {
  EXPECT_TRUE(mentions(problemOf(R"({"format":"geogebra","version":1})"), "not a Halfspace session"));
  problemOf("[]");
  problemOf("3");
  problemOf("");
}

TEST(SessionFile, OfANewerVersion_AsksForAnUpdateWhateverElseItHolds) {
  const Problem problem = problemOf(R"({"format":"halfspace","version":)" +
                                    std::to_string(sessionFileVersion + 1) + R"(,"worlds":[]})");
  EXPECT_TRUE(mentions(problem, "newer version"));
  EXPECT_EQ(problem.field, "version");
}

TEST(SessionFile, LargerThanTheLimit_IsRefusedBeforeItIsRead) {
  EXPECT_TRUE(mentions(problemOf(std::string(maxSessionBytes + 1, ' ')), "too large"));
}

TEST(SessionFile, NestedTooDeeply_IsRefused) {
  EXPECT_TRUE(mentions(problemOf(around(std::string(100000, '['))), "too deeply"));
}

TEST(SessionFile, WithMillionsOfValues_IsRefusedEarly) {
  std::string many = "[0";
  for (int i = 0; i < 200000; ++i)
    many += ",0";
  EXPECT_TRUE(mentions(problemOf(around(many + "]")), "too much"));
}

TEST(SessionFile, WithTooManyEntries_IsRefused) {
  std::string entries = "[{}";
  for (std::size_t i = 0; i < maxSceneEntries; ++i)
    entries += ",{}";
  EXPECT_TRUE(mentions(problemOf(around(entries + "]")), "may have 1000"));
}

TEST(SessionFile, WithAKeyTwice_IsRefused) {
  EXPECT_TRUE(mentions(problemOf(R"({"format":"halfspace","format":"halfspace"})"), "twice"));
}

TEST(SessionFile, WithANameTwice_NamesTheSecondEntryAndItsLine) {
  const Problem problem =
      problemOf(around("[{\"name\":\"Q\",\"point\":[1,2,3]},\n{\"name\":\"Q\",\"point\":[1,2,3]}]"));
  EXPECT_TRUE(mentions(problem, "taken"));
  EXPECT_EQ(problem.field, "scene[1].name");
  EXPECT_EQ(problem.line, 2);
}

TEST(SessionFile, WithANameThatWouldBeLatex_IsRefused) {
  EXPECT_TRUE(mentions(problemOf(around(R"([{"name":"\\mark{","point":[1,2,3]}])")), "cannot be a name"));
  EXPECT_TRUE(mentions(problemOf(around(R"([{"name":"E.n","point":[1,2,3]}])")), "cannot be a name"));
  problemOf(around(R"([{"name":"","point":[1,2,3]}])"));
}

TEST(SessionFile, WithAnUnknownConstruction_NamesIt) {
  const Problem problem = problemOf(around(R"([{"name":"c","construction":"no-such","of":{}}])"));
  EXPECT_TRUE(mentions(problem, "no-such"));
  EXPECT_EQ(problem.field, "scene[0].construction");
}

TEST(SessionFile, WithARoleOfTheWrongKind_SaysWhichKindIsExpected) {
  const Problem problem = problemOf(around(R"([{"name":"Q","point":[1,2,3]},
    {"name":"d","construction":"signed-distance","of":{"E":"Q","Q":"Q"}}])"));
  EXPECT_TRUE(mentions(problem, "a plane is expected"));
  EXPECT_EQ(problem.field, "scene[1].of.E");
}

TEST(SessionFile, WithARoleThatNamesAnEntryBelow_IsRefused) {
  const Problem problem = problemOf(around(
      R"([{"name":"p","construction":"plane-implicit","of":{"E":"E"}},{"name":"E","plane":{"P0":[0,0,0],"n":[0,0,1]}}])"));
  EXPECT_TRUE(mentions(problem, "Above this entry"));
}

TEST(SessionFile, WithARoleMissingOrTooMany_IsRefused) {
  const std::string plane = R"([{"name":"E","plane":{"P0":[0,0,0],"n":[0,0,1]}},)";
  EXPECT_EQ(problemOf(around(plane + R"({"name":"p","construction":"plane-implicit","of":{}}])")).field,
            "scene[1].of.E");
  problemOf(around(plane + R"({"name":"p","construction":"plane-implicit","of":{"E":"E","X":"E"}}])"));
}

TEST(SessionFile, WithNumbersThatAreHugeOrNone_IsRefused) {
  for (const char *number :
       {"1e999", "1e9999999999", "\"1e400\"", "10000000001", "\"NaN\"", "\"1/0\"", "null", "true", "\"\"",
        "[1]", "{}", "\"1/100000000000000000000000000000000000000001\""})
    problemOf(around(std::string(R"([{"name":"Q","point":[0,)") + number + ",0]}]"));
}

TEST(SessionFile, WithFieldsMissingOrUnknown_SaysWhich) {
  EXPECT_EQ(problemOf(around(R"([{"name":"E","plane":{"P0":[0,0,0]}}])")).field, "scene[0].plane.n");
  EXPECT_EQ(problemOf(around(R"([{"name":"E","plane":{"P0":[0,0,0],"n":[0,0,1],"m":[0,0,1]}}])")).field,
            "scene[0].plane.m");
  EXPECT_EQ(problemOf(around(R"([{"name":"E","point":[0,0]}])")).field, "scene[0].point");
  EXPECT_TRUE(mentions(problemOf(around(R"([{"name":"E","torus":[0,0,0]}])")), "what it is"));
  EXPECT_EQ(problemOf(R"({"format":"halfspace","version":1,"lesson":"x","step":-1,"scene":[]})").field,
            "step");
  EXPECT_EQ(problemOf(R"({"format":"halfspace","version":1,"lesson":"x","step":0})").field, "scene");
}

TEST(SessionFile, WithAByteBehindItsEnd_IsRefused) {
  const std::string whole = around("[]");
  ASSERT_TRUE(readSession(whole + " \n\t", file));
  for (const char end : {'\0', '\x1B', '\x7F', '\xFF', ']', '0'})
    problemOf(whole + end);
  EXPECT_EQ(problemOf(whole + "\n\n" + std::string(3, '\0')).line, 3);
}

TEST(SessionFile, WithALessonThatIsNoId_IsRefused) {
  for (const char *lesson : {"null", "5", "true", "[]", "{}", "\"\"", "\"A b\"", "\"../x\"", "\"\\u0000\""})
    EXPECT_EQ(problemOf(R"({"format":"halfspace","version":1,"step":0,"scene":[],"lesson":)" +
                        std::string(lesson) + "}")
                  .field,
              "lesson")
        << lesson;
}

TEST(SessionFile, WithAStep_ReadsItAsANumberOrInQuotes) {
  const auto with = [](const std::string &step) {
    return R"({"format":"halfspace","version":1,"lesson":"x","scene":[],"step":)" + step + "}";
  };
  for (const char *step : {"2", "\"2\""}) {
    const auto session = readSession(with(step), file);
    ASSERT_TRUE(session) << session.problem().text();
    EXPECT_EQ(session->step, 2);
  }
  for (const char *step : {"null", "true", "2.0", "2e0", "-1", "100001", "99999999999999999999", "\"two\"",
                           "\"2 \"", "\"\"", "[2]", "{}"})
    EXPECT_EQ(problemOf(with(step)).field, "step") << step;
}

TEST(SessionFile, WithInvalidUtf8_IsRefused) { problemOf(around("[{\"name\":\"\xFF\",\"point\":[1,2,3]}]")); }

TEST(WithValue, OfACoordinatesName_SetsItExactly) {
  const auto session = withValue(startSession(), "n = 0, -1/2, 1.5");
  ASSERT_TRUE(session) << session.problem().text();
  EXPECT_EQ(coordinate(*findObject(session->scene, "E"), 1), ExactVec3(0, q(-1, 2), q(3, 2)));
  EXPECT_TRUE(withValue(startSession(), "E.P0=1,2,3"));
}

TEST(WithValue, OfAnythingElse_SaysWhatToWrite) {
  EXPECT_TRUE(mentions(withValue(startSession(), "Q").problem(), "Q=11,15,8"));
  EXPECT_TRUE(mentions(withValue(startSession(), "X=1,2,3").problem(), "P0, n, Q"));
  EXPECT_TRUE(mentions(withValue(startSession(), "Q=1,2").problem(), "three numbers"));
  EXPECT_TRUE(mentions(withValue(startSession(), "Q=1,2,x").problem(), "not a number"));
  EXPECT_TRUE(mentions(withValue(startSession(), "Q=1,2,1e20").problem(), "too large"));
}

TEST(WithValue, BeyondWhatIsRead_SaysTooLargeOrTooLong) {
  for (const char *number : {"1e400", "1e401", "-1e401", "1e+401", "1E99999999999", "00012345678901.5"})
    EXPECT_TRUE(mentions(withValue(startSession(), "Q=0,0," + std::string(number)).problem(), "too large"))
        << number;
  for (const char *number : {"1e-400", "1e-401", "-1e-401", "1E-99999999999"})
    EXPECT_TRUE(mentions(withValue(startSession(), "Q=0,0," + std::string(number)).problem(), "too long"))
        << number;
  EXPECT_TRUE(mentions(withValue(startSession(), "Q=0,0,0." + std::string(300, '1')).problem(), "too long"));
  EXPECT_TRUE(mentions(withValue(startSession(), "Q=0,0,1/" + std::string(300, '1')).problem(), "too long"));
  for (const char *number : {"1e", "e401", "1e401x", "1/0", "--1"})
    EXPECT_TRUE(mentions(withValue(startSession(), "Q=0,0," + std::string(number)).problem(), "not a number"))
        << number;
}

} // namespace
} // namespace halfspace
