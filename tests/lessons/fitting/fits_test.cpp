// What can be made of selected objects.
#include "lessons/construction/construction.h"
#include "lessons/fitting/fits.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/object/solid.h"
#include "lessons/scene/edit.h"
#include "lessons/scene/evaluation.h"
#include "lessons/scene/fresh_names.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/typed_scene.h"
#include "lessons/typed/write_line.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using Ids = std::vector<std::string>;

/// An object for each role of a construction, and nothing else.
Scene sceneFor(const Construction &construction) {
  Scene scene;
  for (std::size_t i = 0; i < construction.roles.size(); ++i) {
    const Kind &kind = *findKind(kindsSeenAs(construction.roles[i].kind).front());
    Object object(kind);
    kind.settle(object);
    scene.entries.push_back({"object" + std::to_string(i), std::move(object)});
  }
  return scene;
}

Ids namesIn(const Scene &scene) {
  Ids names;
  for (const Entry &entry : scene.entries)
    names.push_back(entry.name);
  return names;
}

const Fit *fitOf(const std::vector<Fit> &fits, std::string_view construction) {
  const auto found = std::find_if(fits.begin(), fits.end(), [&](const Fit &fit) {
    const auto *use = std::get_if<ConstructionUse>(&fit.entry.content);
    return use && use->id == construction;
  });
  return found == fits.end() ? nullptr : &*found;
}

/// The ids in the roles of the use, in the order of the roles.
Ids idsIn(const Fit &fit) { return referencesIn(fit.entry); }

Scene playground() {
  return *readTypedScene("A = (1, 2, 3)\n"
                         "B = (4, -1/2, 6)\n"
                         "C = (0, 5, 1)\n"
                         "E: x + 2y + 2z = 27\n"
                         "F = plane(A, B, C)\n"
                         "g = line(A, B)\n"
                         "r = A + t(-1, 3, 2)\n"
                         "v = (1, 2, 3)\n"
                         "w = B - A\n"
                         "k = 3/2\n"
                         "T = triangle(A, B, C)\n"
                         "S = sphere(A, 3)\n"
                         "d = distance(A, E)\n"
                         "P = point-on-line(g, 2)\n",
                         "");
}

std::string kindIn(const Fit &fit) { return std::string(kindOf(fit.entry)->word); }

/// The kinds of the objects that fit.
Ids kindsOf(const std::vector<Fit> &fits) {
  Ids kinds;
  for (const Fit &fit : fits)
    if (kindOf(fit.entry))
      kinds.push_back(kindIn(fit));
  return kinds;
}

TEST(Fits, OfAllThatAConstructionLooksAt_InAnyOrder_HaveIt) {
  for (const Construction &construction : constructions()) {
    const Scene scene = sceneFor(construction);
    Ids selected = namesIn(scene);
    do {
      const std::vector<Fit> fits = fitsFor(scene, selected);
      const Fit *fit = fitOf(fits, construction.id);
      ASSERT_TRUE(fit && !fit->wanted) << construction.id;
      EXPECT_TRUE(apply(scene, AddEntry{scene.entries.size(), fit->entry})) << construction.id;
      EXPECT_EQ(idsIn(*fit).size(), selected.size()) << construction.id;
    } while (selected.size() <= 3 && std::next_permutation(selected.begin(), selected.end()));
  }
}

TEST(Fits, WithOneObjectLeftOut_WantOneOfItsKind) {
  for (const Construction &construction : constructions()) {
    const Scene scene = sceneFor(construction);
    for (std::size_t left = 0; construction.roles.size() > 1 && left < construction.roles.size(); ++left) {
      Ids selected = namesIn(scene);
      selected.erase(selected.begin() + static_cast<std::ptrdiff_t>(left));
      const std::vector<Fit> fits = fitsFor(scene, selected);
      const Fit *fit = fitOf(fits, construction.id);
      ASSERT_TRUE(fit && fit->wanted) << construction.id << left;
      EXPECT_EQ(fit->wanted->kind, construction.roles[left].kind) << construction.id;
      Entry whole = fit->entry;
      std::get<ConstructionUse>(whole.content).roles[fit->wanted->role] = scene.entries[left].name;
      EXPECT_TRUE(apply(scene, AddEntry{scene.entries.size(), whole})) << construction.id;
    }
  }
}

TEST(Fits, OfTwoOfAKind_StandInTheOrderOfSelection) {
  const Scene scene = playground();
  const auto roles = [&](const Ids &selected) {
    return std::get<ConstructionUse>(fitOf(fitsFor(scene, selected), "cross-product")->entry.content).roles;
  };
  EXPECT_EQ(roles({"v", "w"}).at("u"), RoleObjects("v"));
  EXPECT_EQ(roles({"w", "v"}).at("u"), RoleObjects("w"));
}

TEST(Fits, OfSeveralForAList_AllStandInIt) {
  const Scene scene = playground();
  const auto fits = fitsFor(scene, Ids{"F", "r", "E"});
  const Fit *fit = fitOf(fits, "ray-plane-substitution");
  ASSERT_TRUE(fit && !fit->wanted);
  EXPECT_EQ(std::get<ConstructionUse>(fit->entry.content).roles.at("planes"), RoleObjects(Ids{"F", "E"}));
  EXPECT_FALSE(fitOf(fits, "ray-plane-dot")) << "it would not look at both planes";
}

TEST(Fits, WhereTheSceneHasNoObjectOfTheKind_DoNotWantOne) {
  const Scene scene = playground();
  EXPECT_TRUE(fitOf(fitsFor(scene, Ids{"A"}), "signed-distance"));
  EXPECT_FALSE(fitOf(fitsFor(scene, Ids{"A", "B"}), "camera-ray")) << "there is no screen";
  EXPECT_FALSE(fitOf(fitsFor(scene, Ids{"r", "k"}), "nearest-hit")) << "there is no mesh";
}

TEST(Fits, WithObjectsThatConstructionsMake_HaveTheirIds) {
  const Scene scene = playground();
  const auto fits = fitsFor(scene, Ids{"d.F", "E"});
  const Fit *fit = fitOf(fits, "signed-distance");
  ASSERT_TRUE(fit);
  EXPECT_EQ(std::get<ConstructionUse>(fit->entry.content).roles.at("Q"), RoleObjects("d.F"));
}

TEST(Fits, OfNothingThatIsThere_AreNone) {
  const Scene scene = playground();
  EXPECT_TRUE(fitsFor(scene, Ids()).empty());
  EXPECT_TRUE(fitsFor(scene, (Ids{"nobody", "Q.x"})).empty());
  EXPECT_EQ(fitsFor(scene, Ids{"A", "A", "nobody"}).size(), fitsFor(scene, Ids{"A"}).size());
}

TEST(Fits, OfASceneThatIsFull_AreNone) {
  Scene scene;
  for (std::size_t i = 0; i < maxSceneEntries; ++i)
    scene.entries.push_back({"v" + std::to_string(i), VectorObject{ExactVec3(0), {1, 2, 3}}});
  EXPECT_TRUE(fitsFor(scene, Ids{"v1", "v2"}).empty());
}

TEST(Fits, OfPointsVectorsAndNumbers_HaveTheObjectsThatTheyTell) {
  const Scene scene = playground();
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"A", "B"})), (Ids{"line", "ray", "segment", "vector"}));
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"A", "B", "d.F"})), (Ids{"plane", "triangle"}));
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"v", "A"})), (Ids{"plane", "line", "ray", "vector"}));
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"k", "P"})), (Ids{"sphere"}));
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"A", "B", "C", "P"})), (Ids{"tetrahedron"}));
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"A"})), Ids());
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"A", "E"})), Ids());
}

TEST(Fits, OfWhatPointsCanLieOn_HaveAPointThere_ButNotOfSeveral) {
  const Scene scene = playground();
  EXPECT_EQ(kindsOf(fitsFor(scene, Ids{"E"})), (Ids{"point-on-plane"}));
  for (const Fit &fit : fitsFor(scene, Ids{"E"})) {
    EXPECT_EQ(fit.entry.on, kindOf(fit.entry) ? "E" : "");
  }
}

TEST(Fits, OfObjectsWithCorners_HaveThePlanesOfTheirFaces_ByThePointsThatAreTheirCorners) {
  const Scene scene = *readTypedScene("A = (1, 2, 3)\nB = (4, 0, 6)\nC = (0, 5, 1)\nD = (0, 0, 9)\n"
                                      "W = tetrahedron(A, B, C, D)\nT = triangle(A, B, (7, 7, 7))\n",
                                      "");
  const auto linesOf = [&](const char *id) {
    Ids lines;
    for (const Fit &fit : fitsFor(scene, Ids{id}))
      if (kindOf(fit.entry) && kindIn(fit) == "plane")
        lines.push_back(lineFor(fit.entry));
    return lines;
  };
  EXPECT_EQ(linesOf("W"),
            (Ids{"E = plane(A, B, C)", "E = plane(A, B, D)", "E = plane(A, C, D)", "E = plane(B, C, D)"}));
  EXPECT_EQ(linesOf("T"), (Ids{"E = plane(A, B, T.P2)"}));
}

TEST(Fits, OfAConstructionThatMakesOneObject_AreThoseOfThat) {
  const Scene scene = *readTypedScene("A = (1, 2, 3)\nB = (4, 0, 6)\nm = midpoint(A, B)\nE: z = 1\n", "");
  const auto fits = fitsFor(scene, Ids{"m", "E"});
  ASSERT_TRUE(fitOf(fits, "signed-distance"));
  EXPECT_EQ(lineFor(fitOf(fits, "signed-distance")->entry), "d = signed-distance(E, m.M)");
}

TEST(Fits, OfASegmentBetweenPoints_HaveWhatCanBeMadeOfThese) {
  const Scene scene = *readTypedScene("A = (1, 2, 3)\nB = (4, 0, 6)\ns = segment(A, B)\n"
                                      "t = segment((0, 0, 0), (1, 1, 1))\n",
                                      "");
  const auto fits = fitsFor(scene, Ids{"s"});
  ASSERT_TRUE(fitOf(fits, "midpoint"));
  EXPECT_EQ(lineFor(fitOf(fits, "midpoint")->entry), "m = midpoint(A, B)");
  EXPECT_TRUE(fitOf(fits, "point-point"));
  EXPECT_FALSE(fitOf(fitsFor(scene, Ids{"t"}), "midpoint")) << "its ends are no objects";
}

TEST(Fits, OfPoints_AreTheObjectsThatAreTypedBetweenThem) {
  const Scene scene = playground();
  const auto checkTyped = [&](const Ids &points, const std::string &arguments) {
    for (const Fit &fit : fitsFor(scene, points)) {
      if (!kindOf(fit.entry))
        continue;
      const std::string line = fit.entry.name + " = " + kindIn(fit) + arguments;
      EXPECT_EQ(std::get<Entry>(readLine(line, scene)), fit.entry) << line;
    }
  };
  checkTyped({"A", "B"}, "(A, B)");
  checkTyped({"C", "A", "d.F"}, "(C, A, d.F)");
}

/// Calls a function with each selection of up to three objects of a scene.
template <class Function> void forEachSelection(const Ids &all, Function function) {
  for (const std::string &a : all)
    for (const std::string &b : all)
      for (const std::string &c : all)
        function(Ids{a, b, c});
}

TEST(Fits, OfAnySelection_CanBeAddedAndTyped) {
  const Scene scene = playground();
  Ids all = namesIn(scene);
  all.push_back("d.F");
  std::size_t whole = 0;
  forEachSelection(all, [&](const Ids &selected) {
    for (const Fit &fit : fitsFor(scene, selected)) {
      if (fit.wanted)
        continue;
      ++whole;
      const auto added = apply(scene, AddEntry{scene.entries.size(), fit.entry});
      ASSERT_TRUE(added) << added.problem().sentence;
      const auto read = readLine(lineFor(fit.entry), scene);
      ASSERT_TRUE(std::holds_alternative<Entry>(read)) << lineFor(fit.entry);
      EXPECT_EQ(std::get<Entry>(read), fit.entry) << lineFor(fit.entry);
      EXPECT_NE(evaluate(*added).find(fit.entry.name), nullptr);
    }
  });
  EXPECT_GT(whole, 1000U);
}

TEST(FreshNames, OfWhatIsThereOrMade_AreOthers) {
  const Scene scene = *readTypedScene("A = (1, 2, 3)\nC = (1, 2, 4)\nE: x + 2y + 2z = 27\n"
                                      "d = distance(A, E)\nP = (0, 0, 1)\ng = line(A, C)",
                                      "");
  const FreshNames names(scene);
  EXPECT_EQ(names.ofKind(*findKind("point")), "B");
  EXPECT_EQ(names.ofKind(*findKind("point-on-line")), "B");
  EXPECT_EQ(names.ofKind(*findKind("plane")), "G") << "F is what d makes";
  EXPECT_EQ(names.ofKind(*findKind("line")), "h");
  EXPECT_EQ(names.ofKind(*findKind("segment")), "s");
  EXPECT_EQ(names.ofUse(*findConstruction("signed-distance")), "d1");
  EXPECT_EQ(names.ofUse(*findConstruction("three-methods")), "t1") << "t is the parameter of lines";
}

TEST(FreshNames, AreNotWrittenLikeNamesThatAreThere) {
  Scene scene;
  for (const char *name : {"S", "S_1", "S3"})
    scene.entries.push_back({name, SphereObject{{0, 0, 0}, 1}});
  EXPECT_EQ(FreshNames(scene).ofKind(*findKind(SphereObject::kind)), "S2");
}

TEST(FreshNames, OfEachKindAndConstruction_CanBeNamesHoweverManyThereAre) {
  Scene scene;
  for (int round = 0; round < 12; ++round) {
    for (const Kind &kind : kinds())
      if (!kind.binding) {
        Object object(kind);
        kind.settle(object);
        const std::string name = FreshNames(scene).ofKind(kind);
        ASSERT_FALSE(scene.entries.find(name));
        scene.entries.push_back({name, object});
      }
    for (const Construction &construction : constructions())
      EXPECT_FALSE(scene.entries.find(FreshNames(scene).ofUse(construction)));
  }
  const auto problem = checkScene(scene);
  EXPECT_FALSE(problem) << problem->sentence;
}

} // namespace
} // namespace halfspace
