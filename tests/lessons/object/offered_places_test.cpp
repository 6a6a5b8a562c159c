// What the handles of others snap to on each kind of object, and what its own handles snap to.
#include "lessons/scene/hand/snap_targets.h"

#include "lessons/object/solid.h"
#include "tests/lessons/object/spelled_objects.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using namespace test;

const std::string freePoint = "{name: Z, point: [9, 9, 9]}";

/// The targets of a handle of the last object, by their names.
std::map<std::string, SnapTarget> targetsIn(const std::string &entries, const std::string &id) {
  const Scene scene = spelledScene(entries);
  std::map<std::string, SnapTarget> targets;
  for (SnapTarget &target : snapTargets(scene, handle(scene, id)))
    targets.emplace(target.name, target);
  return targets;
}

/// What a free point finds on an object of this kind.
std::map<std::string, SnapTarget> offeredBy(const std::string &kind) {
  return targetsIn(spelledEntry(kind) + ", " + freePoint, "Z");
}

bool takes(const SnapTarget &target, const ExactVec3 &place) {
  return target.places.contains(place) && (!target.counts || target.counts(place));
}

struct Offer {
  std::string kind;
  std::string name;
  ExactVec3 at; ///< a place of it
};

void PrintTo(const Offer &offer, std::ostream *stream) { *stream << offer.name << " of a " << offer.kind; }

struct EveryOffer : testing::TestWithParam<Offer> {};

TEST_P(EveryOffer, OfAKind_IsFoundByOthersUnderItsName) {
  const auto targets = offeredBy(GetParam().kind);
  const auto found = targets.find(GetParam().name);
  ASSERT_NE(found, targets.end());
  EXPECT_TRUE(takes(found->second, GetParam().at));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EveryOffer,
    testing::Values(Offer{"point", "point K", {1, 2, 3}}, Offer{"ray", "start Q", {1, 2, 3}},
                    Offer{"vector", "start of K", {1, 2, 3}}, Offer{"vector", "tip of K", {1, 2, 5}},
                    Offer{"line", "point A", {1, 2, 3}}, Offer{"line", "line K", {1, 2, -40}},
                    Offer{"segment", "corner B", {5, 2, 3}}, Offer{"segment", "edge AB", {3, 2, 3}},
                    Offer{"plane", "plane K", {77, -5, 3}}, Offer{"triangle", "corner P₁", {3, 0, 0}},
                    Offer{"triangle", "edge P₀P₂", {0, 1, 0}}, Offer{"triangle", "plane K", {50, 50, 0}},
                    Offer{"plane-through-points", "plane K", {50, 50, 0}},
                    Offer{"polygon", "corner P₃", {0, 4, 0}}, Offer{"polygon", "edge P₀P₃", {0, 1, 0}},
                    Offer{"polygon", "edge P₁P₂", {4, 1, 0}}, Offer{"tetrahedron", "corner P₃", {0, 0, 4}},
                    Offer{"prism", "corner P₂", {0, 3, 0}}, Offer{"prism", "corner P₀", {0, 0, 0}},
                    Offer{"prism", "edge P₀P₁", {1, 0, 0}}, Offer{"prism", "edge P₀P₂", {0, 1, 0}},
                    Offer{"tetrahedron", "edge P₀P₂", {0, 1, 0}},
                    Offer{"tetrahedron", "edge P₁P₃", {2, 0, 2}}, Offer{"box", "corner P₀", {1, 2, 3}},
                    Offer{"screen", "corner P₀", {1, 2, 3}}, Offer{"screen", "plane K", {50, 2, -7}},
                    Offer{"sphere", "centre c", {1, 2, 3}}));

TEST(Offers, OfSolids_AreAllCornersAndEdges) {
  for (const auto &[kind, corners, edges] :
       {std::tuple("box", 8U, 12U), {"prism", 6U, 9U}, {"tetrahedron", 4U, 6U}}) {
    const Object solid = spelledObject(kind);
    Surroundings found;
    offerSolid({"K", letter("K"), std::vector<Symbol>(solid.size(), letter("P")), solid}, found);
    EXPECT_EQ(found.points.size(), corners) << kind;
    EXPECT_EQ(found.edges.size(), edges) << kind;
  }
}

TEST(Offers, OfAnEdge_EndWithItsEnds) {
  const auto targets = offeredBy("segment");
  const SnapTarget &edge = targets.at("edge AB");
  EXPECT_TRUE(takes(edge, {1, 2, 3}) && takes(edge, {5, 2, 3}));
  EXPECT_TRUE(edge.places.contains({6, 2, 3})) << "on the line of the edge";
  EXPECT_FALSE(takes(edge, {6, 2, 3}) || takes(edge, {0, 2, 3}));
}

TEST(Offers, OfWhatHasNoExtent_LeaveOutWhatItHasNot) {
  const auto names = [](const std::string &entry) {
    std::vector<std::string> found;
    for (const auto &[name, target] : targetsIn(entry + ", " + freePoint, "Z"))
      if (name != "the origin")
        found.push_back(name);
    return found;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("{name: K, segment: {A: [1, 2, 3], B: [1, 2, 3]}}"), (Names{"corner A", "corner B"}));
  EXPECT_EQ(names("{name: K, line: {A: [1, 2, 3], v: [0, 0, 0]}}"), Names{"point A"});
  EXPECT_EQ(names("{name: K, plane: {P0: [1, 2, 3], n: [0, 0, 0]}}"), Names());
  const auto flat = names("{name: K, triangle: {P0: [0, 0, 0], P1: [1, 0, 0], P2: [2, 0, 0]}}");
  EXPECT_EQ(std::count(flat.begin(), flat.end(), "plane K"), 0) << "corners on one line span none";
}

TEST(Offers, OfAnObject_AreNotForItsOwnHandles) {
  EXPECT_EQ(targetsIn(spelledEntry("segment"), "K.A").size(), 1U) << "the origin alone";
  EXPECT_TRUE(targetsIn(spelledEntry("sphere") + ", {name: B, point: [0, 0, 0]}", "K.R").empty())
      << "a length is no place";
  EXPECT_TRUE(targetsIn(spelledEntry("triangle") + ", " + freePoint, "K.whole").empty());
}

TEST(Aims, OfATrianglesCorner_AreInLineWithTheOthers) {
  const auto lineOf = [](const std::string &corner, const std::string &name, const ExactVec3 &place) {
    const auto targets = targetsIn(spelledEntry("triangle"), corner);
    const auto found = targets.find(name);
    return found != targets.end() && takes(found->second, place);
  };
  EXPECT_TRUE(lineOf("K.P0", "in line with P₁ and P₂", {2, 1, 0}));
  EXPECT_TRUE(lineOf("K.P1", "in line with P₀ and P₂", {0, -7, 0}));
  EXPECT_TRUE(lineOf("K.P2", "in line with P₀ and P₁", {-7, 0, 0}));
}

TEST(Aims, OfAPlanesOffset_GoThroughThePointsOfOthers) {
  const auto targets = targetsIn(spelledEntry("plane") + ", " + freePoint, "K.offset");
  ASSERT_EQ(targets.count("through point Z"), 1U);
  EXPECT_TRUE(takes(targets.at("through point Z"), {1, 2, 9}));
  EXPECT_FALSE(takes(targets.at("through point Z"), {1, 2, 8}));
}

TEST(Aims, OfAPlanesNormal_AreTheAxes) {
  const auto targets = targetsIn(spelledEntry("plane") + ", " + freePoint, "K.n");
  EXPECT_EQ(targets.size(), 1U) << "a normal leads nowhere";
  EXPECT_EQ(targets.count("axis-parallel"), 1U);
}

/// A ray from the origin beside other objects, and what its direction catches at.
std::map<std::string, SnapTarget> aimsOfRay(const std::string &others) {
  return targetsIn(others + ", {name: L, ray: {Q: [0, 0, 0], r: [1, 1, 1]}}", "L.r");
}

TEST(Aims, OfADirection_GoThroughPointsBothWays) {
  const auto targets = aimsOfRay("{name: Z, point: [2, 4, 6]}");
  ASSERT_EQ(targets.count("through point Z"), 1U);
  const SnapTarget &through = targets.at("through point Z");
  EXPECT_TRUE(takes(through, {1, 2, 3}) && takes(through, {-1, -2, -3}));
  EXPECT_FALSE(takes(through, {0, 0, 0})) << "that is no direction";
  EXPECT_EQ(aimsOfRay("{name: Z, point: [0, 0, 0]}").count("through point Z"), 0U) << "the start itself";
}

TEST(Aims, OfADirection_CrossEdgesBetweenTheirEnds) {
  const auto targets = aimsOfRay("{name: K, segment: {A: [4, 1, 0], B: [4, -1, 0]}}");
  ASSERT_EQ(targets.count("through edge AB"), 1U);
  const SnapTarget &edge = targets.at("through edge AB");
  EXPECT_TRUE(takes(edge, {1, 0, 0}) && takes(edge, {4, 1, 0}) && takes(edge, {-2, 0, 0}));
  EXPECT_FALSE(takes(edge, {1, 1, 0})) << "beside it";
  EXPECT_FALSE(takes(edge, {0, 0, 0}));
  EXPECT_EQ(aimsOfRay("{name: K, segment: {A: [1, 0, 0], B: [4, 0, 0]}}").count("through edge AB"), 0U)
      << "from the line of the edge it is seen as a point";
}

TEST(Aims, OfADirection_LieInOrAlongPlanes) {
  EXPECT_EQ(aimsOfRay("{name: E, plane: {P0: [0, 0, 3], n: [0, 0, 1]}}").count("parallel to E"), 1U);
  const auto inside = aimsOfRay("{name: E, plane: {P0: [5, 5, 0], n: [0, 0, 1]}}");
  ASSERT_EQ(inside.count("in the plane E"), 1U);
  EXPECT_TRUE(takes(inside.at("in the plane E"), {3, -7, 0}));
  EXPECT_FALSE(takes(inside.at("in the plane E"), {3, -7, 1}));
  EXPECT_FALSE(takes(inside.at("in the plane E"), {0, 0, 0}));
}

} // namespace
} // namespace halfspace
