#include "lessons/scene/evaluation.h"

#include "lessons/lesson/condition.h"
#include "lessons/reading/typed_number.h"
#include "lessons/term/plain_text.h"
#include "lessons/typed/typed_scene.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

using namespace test;

/// A second plane and the distance of the first one's foot from it.
Scene chainedScene() {
  Scene scene = distanceScene();
  scene.entries.push_back({"G", PlaneObject{{0, 0, 0}, {0, 0, 1}}});
  scene.entries.push_back({"beyond", ConstructionUse{"signed-distance", {{"E", "G"}, {"Q", "distance.F"}}}});
  return scene;
}

/// The foot exists only where the ray crosses the plane.
Scene hitScene() {
  return {{planeE(),
           rayL(),
           {"meeting", ConstructionUse{"ray-plane-dot", {{"E", "E"}, {"L", "L"}}}},
           {"G", PlaneObject{{0, 0, 0}, {0, 0, 1}}},
           {"height", ConstructionUse{"signed-distance", {{"E", "G"}, {"Q", "meeting.H"}}}}}};
}

Object changed(const Scene &scene, const std::string &name, std::size_t index, const ExactVec3 &value) {
  Object object = *findObject(scene, name);
  coordinate(object, index) = value;
  return object;
}

std::string textOf(const Working &working, const std::string &id) {
  const WorkingLine *line = findLine(working, id);
  return line ? plainText(*line) : "";
}

TEST(Evaluate, TheStartOfTheDistanceLesson_IsTenAwayOnThePositiveSide) {
  const Evaluation evaluation = evaluate(distanceScene());
  const Outcome &outcome = lastOutcome(evaluation);
  EXPECT_EQ(outcome.told->name, "positive");
  ASSERT_FALSE(outcome.values->empty());
  EXPECT_EQ(std::get<Surd>(outcome.values->at(0).value), Surd(30));
  EXPECT_EQ(std::get<Surd>(outcome.values->at(1).value), Surd(10));
  EXPECT_EQ(outcome.explanation->ids().size(), 8U);
}

TEST(Evaluate, APlanesLabel_HasItsEquationAsOneGroup) {
  const Scene scene = edited(distanceScene(), {ChangeObject{"E", PlaneObject{{5, 4, 7}, {-6, 6, 2}}}});
  const Figure figure = figureOf(evaluate(scene));
  const Mark *plane = findMark(figure, "E");
  ASSERT_NE(plane, nullptr);
  const std::string label = baseOf(*plane).label + baseOf(*plane).numbers;
  EXPECT_TRUE(label.starts_with("E\\colon\\ {-6x") && label.ends_with("}")) << label; // a sign, no difference
}

TEST(Evaluate, AnObjectThatNoConstructionLooksAt_IsDrawnAllTheSame) {
  Scene scene = distanceScene();
  scene.entries.push_back({"F", PointObject{{1, 2, 3}}});
  scene.entries.push_back(triangleT());
  const Figure figure = figureOf(evaluate(scene));
  const Mark *point = findMark(figure, "F");
  ASSERT_NE(point, nullptr);
  EXPECT_EQ(std::get<PointMark>(*point).at, Place(1, 2, 3));
  EXPECT_NE(findMark(figure, "T"), nullptr);
  EXPECT_NE(findMark(figure, "T.P2"), nullptr);
}

TEST(Evaluate, DegenerateObjects_AreDrawnWithoutWhatTheyLack) {
  const Scene scene{{{"E", PlaneObject{{1, 1, 1}, {0, 0, 0}}}, {"L", RayObject{}}, {"T", TriangleObject{}}}};
  const Figure figure = figureOf(evaluate(scene));
  EXPECT_NE(findMark(figure, "E.P0"), nullptr);
  EXPECT_NE(findMark(figure, "T.P0"), nullptr);
  for (const char *lacking : {"E", "E.n", "L", "L.r", "T"})
    EXPECT_EQ(findMark(figure, lacking), nullptr) << lacking;
}

TEST(Evaluate, TwoConstructions_HaveAnOutcomeEachAndEveryMarkOnce) {
  Scene scene = distanceScene();
  scene.entries.push_back({"S", PointObject{{0, 0, 0}}});
  scene.entries.push_back({"second", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "S"}}}});
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(evaluation.find("distance")->outcome->told->name, "positive");
  EXPECT_EQ(evaluation.find("second")->outcome->told->name, "negative");
  EXPECT_EQ(evaluation.lastConstruction()->name, "second");
  std::set<std::string> ids;
  for (const Mark &mark : figureOf(evaluation).marks)
    EXPECT_TRUE(ids.insert(baseOf(mark).id).second) << baseOf(mark).id << " stands twice";
  for (const char *id : {"E.n", "Q", "S", "distance.F", "second.F"})
    EXPECT_TRUE(ids.contains(id)) << id;
}

TEST(Evaluate, APatch_ReachesTheFeetOfAllConstructions) {
  Scene scene = distanceScene();
  scene.entries.push_back({"S", PointObject{{30, 15, 8}}});
  scene.entries.push_back({"second", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "S"}}}});
  const Figure figure = figureOf(evaluate(scene));
  const auto &patch = std::get<PlanePatchMark>(*findMark(figure, "E"));
  const auto &foot = std::get<PointMark>(*findMark(figure, "second.F"));
  EXPECT_EQ(patch.covers.size(), 2U);
  EXPECT_EQ(patch.covers.back(), foot.at);
}

TEST(Evaluate, AResult_FeedsALaterConstruction) {
  const Evaluation evaluation = evaluate(chainedScene());
  // The foot is (23/3, 25/3, 4/3): its distance from z = 0 is its height.
  EXPECT_EQ(std::get<Surd>(*findValue(evaluation, "beyond.signed_distance")), Surd(Rational(4, 3)));
  EXPECT_EQ(findValue(evaluation, "signed_distance"), std::nullopt) << "two have one";
  EXPECT_EQ(std::get<Word>(*findValue(evaluation, "distance.case")).name, "positive");
}

TEST(Evaluate, WhatTwoEntriesHave_SaysWhoseItIs) {
  const Working working = workingOf(evaluate(chainedScene()));
  EXPECT_EQ(textOf(working, "distance.f"), "f_distance(Q) = n_E·(Q − P₀_E) = (1, 2, 2)·(6, 11, 1) = 30");
  EXPECT_EQ(textOf(working, "beyond.f"), "f_beyond(F_distance) = n_G·(F_distance − P₀_G) = "
                                         "(0, 0, 1)·(23/3, 25/3, 4/3) = 4/3");
  EXPECT_EQ(findLine(working, "beyond.foot")->sentence,
            "The foot: from F_distance straight along n_G to the plane, its nearest point.");
}

/// The names of the entries that another evaluation does not share.
std::set<std::string> notShared(const Evaluation &evaluation, const Evaluation &with) {
  std::set<std::string> names;
  for (std::size_t place = 0; place < evaluation.entries.size(); ++place)
    if (evaluation.entries.shared(place) != with.entries.shared(place))
      names.insert(evaluation.entries[place].name);
  return names;
}

TEST(Evaluate, AMoveOfOneObject_EvaluatesWhatDependsOnItAlone) {
  const Scene scene = chainedScene();
  const Evaluation before = evaluate(scene);
  const auto changedBy = [&](const ChangeObject &change) {
    const Evaluation after = evaluate(edited(scene, {change}), before);
    EXPECT_EQ(after.plan, before.plan);
    return notShared(after, before);
  };
  EXPECT_EQ(changedBy({"G", changed(scene, "G", 0, {0, 0, 1})}), (std::set<std::string>{"G", "beyond"}));
  EXPECT_EQ(changedBy({"Q", changed(scene, "Q", 0, {1, 2, 3})}),
            (std::set<std::string>{"Q", "distance", "beyond"}));
  EXPECT_EQ(changedBy({"Q", *findObject(scene, "Q")}), std::set<std::string>{"Q"}) << "it is as it was";
}

TEST(Evaluate, AMoveThatLeavesAResultAsItWas_TakesOverAllThatFollowsFromTheResult) {
  const Scene scene = chainedScene();
  const Evaluation before = evaluate(scene);
  const Evaluation after = evaluate( // along the normal: the foot stays
      edited(scene, {ChangeObject{"Q", changed(scene, "Q", 0, {12, 17, 10})}}), before);
  EXPECT_NE(after.find("distance")->outcome, before.find("distance")->outcome);
  EXPECT_EQ(after.find("beyond")->outcome, before.find("beyond")->outcome);
}

TEST(Evaluate, WhatNobodyLooksAt_IsNotMade) {
  const Evaluation evaluation = evaluate(chainedScene());
  for (const EvaluatedEntry &entry : evaluation.entries) {
    const Outcome &outcome = *entry.outcome;
    EXPECT_FALSE(outcome.told.isMade() || outcome.values.isMade() || outcome.explanation.isMade() ||
                 outcome.figure.isMade() || outcome.nearby.isMade() || outcome.crossings.isMade())
        << entry.name;
  }
}

TEST(Evaluate, AnObjectCalledLikeALetterOfTheConstruction_IsToldApartFromIt) {
  const Scene scene = edited(distanceScene(), {RenameEntry{"Q", "w"}});
  const Working working = workingOf(evaluate(scene));
  EXPECT_EQ(textOf(working, "distance.cosine").substr(0, 24), "cos θ = (n·w_distance)");
  EXPECT_NE(textOf(working, "distance.f").find("w − P₀"), std::string::npos);
}

TEST(Evaluate, ANameWithHyphensOrUnderscores_IsWrittenAsOneWord) {
  const Scene scene = edited(distanceScene(), {RenameEntry{"Q", "q_1-2"}});
  const Working working = workingOf(evaluate(scene));
  EXPECT_NE(textOf(working, "distance.f").find("q_1-2 − P₀"), std::string::npos);
  EXPECT_NE(latexOf(*findLine(working, "distance.f")).find("\\operatorname{q\\_1\\mbox{-}2}"),
            std::string::npos);
}

TEST(Evaluate, ANameOfTheScene_StandsInsteadOfTheRoles) {
  Scene scene = edited(distanceScene(), {RenameEntry{"E", "G"}, RenameEntry{"Q", "S2"}});
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(textOf(workingOf(evaluation), "distance.f"), "f(S₂) = n·(S₂ − P₀) = (1, 2, 2)·(6, 11, 1) = 30");
  EXPECT_TRUE(lastOutcome(evaluation).told->description.find("S₂ lies on the side") != std::string::npos);
  const Figure figure = figureOf(evaluation);
  EXPECT_EQ(baseOf(*findMark(figure, "G")).label, "G");
  EXPECT_EQ(baseOf(*findMark(figure, "S2")).label, "S_2");
}

TEST(Evaluate, WhereTheLookedAtIsNotMade_SaysSoAndComesBack) {
  const Scene scene = hitScene();
  const Evaluation there = evaluate(scene);
  EXPECT_EQ(there.find("height")->outcome->told->name, "positive");
  // (2, −1, 0) is perpendicular to n: the ray runs parallel to the plane.
  const Scene parallel = edited(scene, {ChangeObject{"L", changed(scene, "L", 1, {2, -1, 0})}});
  const Evaluation gone = evaluate(parallel, there);
  EXPECT_EQ(gone.find("height")->outcome->told->name, "missing-object");
  EXPECT_EQ(gone.find("height")->outcome->told->description,
            "r·n_E = 0 but (P₀_E − Q)·n_E is not: the ray runs parallel to the plane and never meets it. So "
            "there is no H to go on with.");
  EXPECT_TRUE(gone.find("height")->outcome->told->degenerate);
  EXPECT_EQ(evaluate(scene, gone).find("height")->outcome->told->name, "positive");
}

TEST(Evaluate, WhatIsThereButHasRoots_SaysThatNothingCanBeMadeOfIt) {
  const Evaluation evaluation = evaluate(*readTypedScene(
      "A = (0, 0, 0)\nB = (2, 0, 0)\nC = (0, 2, 0)\nD = (0, 0, 2)\nc = circumsphere(A, B, C, D)\n", "typed"));
  const auto &offers = evaluation.find("c")->offers;
  const auto sphere =
      std::find_if(offers.begin(), offers.end(), [](const OfferedObject &made) { return made.name == "S"; });
  ASSERT_NE(sphere, offers.end());
  EXPECT_EQ(sphere->whyNot, "The numbers of S are no fractions: nothing can be made of it.");
}

TEST(Evaluate, AChainWhoseNumbersGrowWithoutEnd_EndsWithASentence) {
  const Rational odd = 1 / (powerOfTen(coordinateDigits - 1) + 7);
  Scene scene{{{"E", PlaneObject{{odd, 1, 2}, {1, odd, 3}}},
               {"G", PlaneObject{{0, odd, 1}, {odd, 2, 1}}},
               {"d0", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "P"}}}}}};
  scene.entries.insert(0, {"P", PointObject{{3, odd, 5}}});
  for (int i = 1; i < 300; ++i)
    scene.entries.push_back(
        {"d" + std::to_string(i),
         ConstructionUse{"signed-distance",
                         {{"E", i % 2 == 0 ? "E" : "G"}, {"Q", "d" + std::to_string(i - 1) + ".F"}}}});
  const Evaluation evaluation = evaluate(scene);
  ASSERT_EQ(evaluation.entries.size(), scene.entries.size());
  EXPECT_EQ(lastOutcome(evaluation).told->name, "missing-object");
  EXPECT_NE(evaluation.find("d2")->outcome->told->name, "missing-object");
}

TEST(Evaluate, AfterAnEdit_KeepsTheOutcomesThatItDoesNotTouch) {
  const Scene scene = chainedScene();
  const Evaluation before = evaluate(scene);
  const Evaluation after =
      evaluate(edited(scene, {ChangeObject{"G", changed(scene, "G", 0, {0, 0, 1})}}), before);
  for (const char *same : {"E", "Q", "distance"})
    EXPECT_EQ(after.find(same)->outcome, before.find(same)->outcome) << same;
  for (const char *other : {"G", "beyond"})
    EXPECT_NE(after.find(other)->outcome, before.find(other)->outcome) << other;
  const Evaluation moved =
      evaluate(edited(scene, {ChangeObject{"Q", changed(scene, "Q", 0, {0, 0, 1})}}), before);
  for (const char *dependent : {"distance", "beyond"})
    EXPECT_NE(moved.find(dependent)->outcome, before.find(dependent)->outcome) << dependent;
  EXPECT_EQ(moved.find("E")->outcome, before.find("E")->outcome);
}

TEST(Evaluate, AfterTheLettersChange_WritesThemAnew) {
  const Evaluation before = evaluate(distanceScene());
  const Evaluation after = evaluate(chainedScene(), before);
  EXPECT_NE(textOf(workingOf(after), "distance.f").find("n_E"), std::string::npos);
}

TEST(Evaluate, Lines_AreMadeWhenLookedAtAndThenKept) {
  const Evaluation evaluation = evaluate(distanceScene());
  const Explanation &lines = *lastOutcome(evaluation).explanation;
  const WorkingLine *line = lines.find("f");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(lines.find("f"), line);
  EXPECT_EQ(lines.find("no-such"), nullptr);
}

TEST(Evaluate, ASceneThatNoReaderWouldPass_IsEvaluatedAsFarAsItGoes) {
  const Scene scene{{pointQ(),
                     {"a", ConstructionUse{"no-such", {}}},
                     {"b", ConstructionUse{"signed-distance", {{"E", "Q"}, {"Q", "Q"}}}},
                     {"c", ConstructionUse{"signed-distance", {}}}}};
  EXPECT_EQ(evaluate(scene).entries.size(), 1U);
  EXPECT_EQ(evaluate(scene).lastConstruction(), nullptr);
}

TEST(FindConstruction, OfAnUnknownId_FindsNone) {
  EXPECT_EQ(findConstruction("no-such"), nullptr);
  ASSERT_NE(findConstruction("ray-plane-dot"), nullptr);
  EXPECT_EQ(findConstruction("ray-plane-dot")->id, "ray-plane-dot");
}

TEST(FigureOf, AScene_HasNoLabelsThatSomebodyHasHidden_AndAllItsMarks) {
  Scene scene = distanceScene();
  const Evaluation before = evaluate(scene);
  const Figure whole = figureOf(before);
  scene.labels = {{"E", {{}, true}}, {"Q", {LabelSpot{{1, 2}}, true}}, {"E.n", {LabelSpot{{1, 2}}, false}}};
  const Figure figure = figureOf(evaluate(scene, before));
  ASSERT_EQ(figure.marks.size(), whole.marks.size());
  for (std::size_t i = 0; i < whole.marks.size(); ++i) {
    const MarkBase &mark = baseOf(figure.marks[i]);
    const bool isHidden = mark.id == "E" || mark.id == "Q";
    EXPECT_EQ(mark.id, baseOf(whole.marks[i]).id);
    EXPECT_EQ(mark.label, isHidden ? "" : baseOf(whole.marks[i]).label);
    EXPECT_EQ(mark.numbers, isHidden ? "" : baseOf(whole.marks[i]).numbers);
  }
  EXPECT_EQ(std::get<PointMark>(*findMark(figure, "Q")).coordinates, "");
}

TEST(FigureOf, AnEntryWithALabelOfItsOwn_SaysItsNameAlone_OrItsCoordinatesToo) {
  Scene scene = distanceScene();
  const Evaluation before = evaluate(scene);
  const auto say = [&](const char *name, LabelText text) {
    scene.entries.change(*scene.entries.placeOf(name), [&](Entry &entry) { entry.label = text; });
  };
  say("E", LabelText::Name);
  say("Q", LabelText::Value);
  const Figure figure = figureOf(evaluate(scene, before));
  const auto base = [&](const char *id) { return baseOf(*findMark(figure, id)); };
  EXPECT_NE(baseOf(*findMark(figureOf(before), "E")).numbers, "");
  EXPECT_EQ(base("E").numbers, "");
  EXPECT_EQ(base("E.P0").coordinates, "");
  EXPECT_EQ(base("Q").numbers, "{\\left(11,\\,15,\\,8\\right)}");
  EXPECT_EQ(base("Q").coordinates, "") << "they would stand there twice";
}

TEST(FigureOf, AnEntryInAnotherLineStyle_IsDrawnInIt_WhereNothingElseHasChanged) {
  Scene scene = distanceScene();
  const Evaluation before = evaluate(scene);
  scene.entries.change(*scene.entries.placeOf("E"), [](Entry &entry) { entry.line = LineStyle::Dotted; });
  const Evaluation after = evaluate(scene, before);
  EXPECT_EQ(baseOf(*findMark(figureOf(after), "E")).look.line, LineStyle::Dotted);
  EXPECT_EQ(baseOf(*findMark(figureOf(after), "Q")).look.line, std::nullopt);
}

TEST(FigureOf, AConstructionInALookOfItsOwn_HasItsResultsInIt_AndSoHasWhatLooksAtThem) {
  Scene scene = chainedScene();
  const Evaluation before = evaluate(scene);
  scene.entries.change(*scene.entries.placeOf("distance"), [](Entry &entry) {
    entry.color = Hue::Pink;
    entry.line = LineStyle::Dashed;
  });
  const Evaluation after = evaluate(scene, before);
  const Figure figure = figureOf(after);
  for (const Mark &mark : figureOf(before).marks) {
    const MarkBase &was = baseOf(mark);
    const Look &look = baseOf(*findMark(figure, was.id)).look;
    if (was.id.starts_with("distance.") && was.role == Role::Result) {
      EXPECT_EQ(look.hue, Hue::Pink) << was.id;
      EXPECT_EQ(look.line, LineStyle::Dashed) << was.id;
    } else {
      EXPECT_EQ(look, was.look) << was.id;
    }
  }
  EXPECT_EQ(hueOf(baseOf(*findMark(figure, "distance.F"))), Hue::Pink);
  EXPECT_EQ(after.find("beyond")->looksAt[1]->look.hue, Hue::Pink) << "the point that it speaks of";
}

TEST(FigureOf, AnAngleOrARadiusWithItsValue_IsMeasured) {
  const Figure figure = figureOf(evaluate(*readTypedScene(
      "E: z = 0\nF: x + z = 0\nphi = angle(E, F), value\n"
      "A = (0, 0, 0)\nB = (2, 0, 0)\nC = (0, 2, 0)\nD = (0, 0, 2)\nc = circumsphere(A, B, C, D), value\n",
      "typed")));
  EXPECT_EQ(baseOf(*findMark(figure, "phi.phi")).numbers, "= 45^{\\circ}");
  EXPECT_EQ(baseOf(*findMark(figure, "c.radius")).numbers, " = \\sqrt{3}");
}

TEST(Figure, OfAHiddenEntry_HasNothingOfIt_AndOthersGoOnToLookAtIt) {
  Scene scene = distanceScene();
  const Evaluation seen = evaluate(scene);
  scene.entries.change(*scene.entries.placeOf("Q"), [](Entry &entry) { entry.isHidden = true; });
  const Evaluation hidden = evaluate(scene, seen);
  const auto hasMarkOf = [](const Figure &figure, const std::string &entry) {
    return std::any_of(figure.marks.begin(), figure.marks.end(),
                       [&](const Mark &mark) { return entryOfMark(baseOf(mark).id) == entry; });
  };
  EXPECT_TRUE(hasMarkOf(figureOf(seen), "Q"));
  EXPECT_FALSE(hasMarkOf(figureOf(hidden), "Q"));
  EXPECT_TRUE(hasMarkOf(figureOf(hidden), "E"));
  EXPECT_TRUE(hasMarkOf(figureOf(hidden), "distance"));
  EXPECT_EQ(hidden.find("distance")->outcome, seen.find("distance")->outcome);
}

} // namespace
} // namespace halfspace
