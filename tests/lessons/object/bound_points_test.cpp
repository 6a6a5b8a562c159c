// Points that lie on other objects: what they keep, wherever those go.
#include "lessons/object/bound_point.h"

#include "lessons/scene/edit.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/hand/snapping.h"
#include "lessons/term/plain_text.h"
#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"
#include "tests/test_name.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <random>

namespace halfspace {
namespace {

using namespace test;

Entry sphereS() { return {"S", objectOf("sphere", {{1, 2, 3}, {q(5, 2), 0, 0}})}; }

/// Where the point P of a scene is.
ExactVec3 placeOfP(const Scene &scene) {
  const Evaluation evaluation = evaluate(scene);
  const EvaluatedEntry *point = evaluation.find("P");
  if (!point->missing.empty())
    throw std::domain_error(point->missing);
  return point->looksAt.front()->object[0];
}

/// Hosts and places at random. Lengths are never 0; what else could be without extent is made anew.
class Randomly {
public:
  explicit Randomly(std::uint64_t seed) : m_engine(seed) {}
  Rational number() {
    return Rational(static_cast<int>(m_engine() % 41) - 20, 1 + static_cast<int>(m_engine() % 4));
  }
  ExactVec3 vector() {
    const Rational x = number();
    const Rational y = number();
    return {x, y, number()};
  }
  Object host(std::string_view kind) {
    Object host = anyHost(kind);
    while (!hasExtent(host))
      host = anyHost(kind);
    return host;
  }
  Object bound(const Kind &kind) {
    Object bound(kind);
    for (std::size_t i = 0; i < bound.size(); ++i)
      bound[i] = numbersIn(coordinatesOf(bound)[i].role) == 3 ? vector() : ExactVec3(number(), 0, 0);
    kind.settle(bound);
    return bound;
  }

private:
  Object anyHost(std::string_view kind) {
    Object host = *makeObject(kind);
    for (std::size_t i = 0; i < host.size(); ++i)
      host[i] = numbersIn(coordinatesOf(host)[i].role) == 3 ? vector() : ExactVec3(abs(number()) + 1, 0, 0);
    return host;
  }
  static bool hasExtent(const Object &host) {
    return kindOf(host) == "triangle" ? !isZero(normalOfCorners(host)) : !isZero(host[1]);
  }

  std::mt19937_64 m_engine;
};

/// Whether a place lies on a host, told by its equations and not by its freedoms; for what goes on beyond a
/// triangle's edges, in its plane.
bool liesOn(const Object &host, const ExactVec3 &at, bool beyondEdges) {
  const std::string_view kind = kindOf(host);
  const ExactVec3 way = at - host[0];
  if (kind == "line")
    return isZero(cross(way, host[1]));
  if (kind == "ray")
    return isZero(cross(way, host[1])) && dot(way, host[1]) >= 0;
  if (kind == "plane")
    return dot(way, host[1]) == 0;
  if (kind == "sphere")
    return dot(way, way) == host[1].x * host[1].x;
  const ExactVec3 normal = normalOfCorners(host);
  bool isWithin = dot(way, normal) == 0;
  for (std::size_t i = 0; i < 3 && !beyondEdges; ++i)
    isWithin = isWithin && dot(cross(host[(i + 1) % 3] - host[i], at - host[i]), normal) >= 0;
  return isWithin;
}

class EveryBoundKind : public testing::TestWithParam<std::string> {
protected:
  const Kind &kind() const { return *findKind(GetParam()); }
  std::string_view hostKind() const { return kind().binding->host; }
  bool liesOn(const Object &host, const ExactVec3 &at) const {
    return halfspace::liesOn(host, at, kind().word == "point-on-triangle-plane");
  }
};

TEST_P(EveryBoundKind, WithAnyFreedoms_LiesOnItsHostExactly) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Randomly random(seed);
    const Object host = random.host(hostKind());
    const auto at = placeOn(random.bound(kind()), host);
    ASSERT_TRUE(at);
    EXPECT_TRUE(liesOn(host, *at)) << seed;
  }
}

TEST_P(EveryBoundKind, MovedToAPlace_LiesOnItsHostAndNowhereNearer) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Randomly random(seed);
    const Object host = random.host(hostKind());
    const Object bound = random.bound(kind());
    const Handle handle = boundHandle("P", bound, host, *placeOn(bound, host));
    const ExactVec3 wanted = random.vector();
    const auto at = placeOn(movedTo(bound, handle, wanted), host);
    ASSERT_TRUE(liesOn(host, *at)) << seed;
    // A sphere's nearest place is no fraction: it is found to 1/1000 of s and t.
    const double slack = hostKind() == "sphere" ? 0.05 : 0;
    const double found = glm::distance(toDouble(*at), toDouble(wanted));
    for (int i = 0; i < 200; ++i)
      EXPECT_LE(found, glm::distance(toDouble(*placeOn(random.bound(kind()), host)), toDouble(wanted)) +
                           1e-9 + slack)
          << seed;
  }
}

TEST_P(EveryBoundKind, MovedToWhereItIs_StaysThere) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Randomly random(seed);
    const Object host = random.host(hostKind());
    const Object bound = random.bound(kind());
    const ExactVec3 at = *placeOn(bound, host);
    EXPECT_EQ(placeOn(movedTo(bound, boundHandle("P", bound, host, at), at), host), at) << seed;
  }
}

TEST_P(EveryBoundKind, DraggedOverTheGrid_LiesOnItsHostWithShortFreedoms) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Randomly random(seed);
    const Scene scene{{{"H", random.host(hostKind())}, {"P", random.bound(kind()), "H"}}};
    const Handle dragged = handle(scene, "P");
    const SnappedPlace rest = snap({scene,
                                    dragged,
                                    snapTargets(scene, dragged),
                                    toDouble(random.vector()),
                                    {},
                                    q(1, 2),
                                    [](const Place &a, const Place &b) { return glm::distance(a, b) * 100; },
                                    0});
    EXPECT_TRUE(liesOn(*dragged.host, rest.at)) << seed;
    const Object moved = movedTo(*findObject(scene, "P"), dragged, rest.at);
    if (kindOf(moved) != "point-on-plane") {
      for (std::size_t i = 0; i < moved.size(); ++i)
        EXPECT_EQ((moved[i].x * 1000).denominator(), 1) << "a step of 1/1000 at the finest";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBoundKind, testing::ValuesIn([] {
                           std::vector<std::string> words;
                           for (const Kind &kind : kinds())
                             if (kind.binding)
                               words.emplace_back(kind.word);
                           return words;
                         }()),
                         test::testName);

TEST(PointOnPlane, WhereThePlaneTurnsOrItsNormalGrows_StaysInItOrWhereItIs) {
  const Scene scene{{planeE(), {"P", objectOf("point-on-plane", {{5, 6, 5}}), "E"}}};
  EXPECT_EQ(placeOfP(scene), ExactVec3(5, 6, 5)) << "it lies in the plane already";
  const auto withNormal = [&](const ExactVec3 &n) {
    return placeOfP(edited(scene, {ChangeObject{"E", PlaneObject{{5, 4, 7}, n}}}));
  };
  EXPECT_EQ(withNormal({3, 6, 6}), ExactVec3(5, 6, 5));
  EXPECT_EQ(withNormal({-1, -2, -2}), ExactVec3(5, 6, 5));
  EXPECT_EQ(withNormal({0, 0, 1}), ExactVec3(5, 6, 7)) << "the foot of its place";
  EXPECT_THROW(withNormal({0, 0, 0}), std::domain_error);
}

TEST(PointOnPlane, DraggedOnTheGrid_HasTwoCoordinatesOnItAndTheThirdExactly) {
  const Scene scene{{planeE(), {"P", objectOf("point-on-plane", {{5, 6, 5}}), "E"}}};
  const Handle dragged = handle(scene, "P");
  EXPECT_EQ(dragged.normal, ExactVec3(1, 2, 2));
  EXPECT_EQ(movedToGrid(*findObject(scene, "P"), dragged, {q(61, 10), q(39, 10), q(66, 10)}, 1)[0],
            ExactVec3(6, 4, q(13, 2)));
}

TEST(PointOnLine, WhereTheLineTurns_KeepsItsLambda) {
  const Entry line{"g", LineObject{{1, 0, 0}, {2, 4, 6}}};
  const Scene scene{{line, {"P", withNumbers("point-on-line", {q(-1, 2)}), "g"}}};
  EXPECT_EQ(placeOfP(scene), ExactVec3(0, -2, -3));
  EXPECT_EQ(placeOfP(edited(scene, {ChangeObject{"g", LineObject{{1, 0, 0}, {0, 0, 1}}}})),
            ExactVec3(1, 0, q(-1, 2)));
  EXPECT_EQ(placeOfP(edited(scene, {ChangeObject{"g", LineObject{{1, 0, 0}, {0, 0, 0}}}})),
            ExactVec3(1, 0, 0));
}

TEST(PointOnRay, BehindItsStart_IsRefusedWhenTypedAndStopsWhenDragged) {
  const Scene scene{{rayL(), {"P", withNumbers("point-on-ray", {2}), "L"}}};
  EXPECT_EQ(placeOfP(scene), ExactVec3(9, 21, 12));
  EXPECT_EQ(withValue({"x", 0, scene}, "P.lambda=-1").problem().sentence,
            "“lambda” cannot be -1 here: 0 is the nearest that fits.");
  EXPECT_EQ(placeOfP(withValue({"x", 0, scene}, "lambda=1/2")->scene), ExactVec3(q(21, 2), q(33, 2), 9));
  EXPECT_EQ(movedTo(*findObject(scene, "P"), handle(scene, "P"), {100, 0, 0})[0].x, 0);
}

TEST(PointOnTriangle, AtTheMiddle_StaysTheMiddleOfEveryTriangle) {
  const Scene scene{{triangleT(), {"P", withNumbers("point-on-triangle", {q(1, 3), q(1, 3)}), "T"}}};
  EXPECT_EQ(placeOfP(scene), ExactVec3(5, q(20, 3), q(13, 3)));
  EXPECT_EQ(placeOfP(edited(scene, {ChangeObject{"T", TriangleObject{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}}})),
            ExactVec3(1, 1, 0));
}

TEST(PointOnTriangle, OfATriangleThatIsALineOrAPoint_MovesAsFarAsThereIsRoom) {
  for (const TriangleObject &flat :
       {TriangleObject{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}, TriangleObject{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}},
        TriangleObject{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}) {
    const Scene scene{{{"T", flat}, {"P", withNumbers("point-on-triangle", {q(1, 2), q(1, 4)}), "T"}}};
    const Object moved = movedTo(*findObject(scene, "P"), handle(scene, "P"), {9, 1, 1});
    const ExactVec3 end = flat.p2.x == 0 ? ExactVec3(0) : ExactVec3(4, 0, 0);
    EXPECT_EQ(placeOn(moved, flat), end);
  }
}

TEST(PointOnTrianglePlane, BeyondTheEdges_GoesOnAndKeepsItsFreedomsWithTheTriangle) {
  const Scene scene{{triangleT(), {"P", withNumbers("point-on-triangle-plane", {2, q(-1, 2)}), "T"}}};
  const TriangleObject other{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const Scene changed = edited(scene, {ChangeObject{"T", other}});
  EXPECT_EQ(placeOfP(changed), ExactVec3(6, -2, 0));
  const Object moved = movedTo(*findObject(changed, "P"), handle(changed, "P"), {-3, 8, 5});
  EXPECT_EQ(placeOn(moved, other), ExactVec3(-3, 8, 0)) << "the foot";
}

TEST(PointOnTrianglePlane, OfATriangleThatIsALineOrAPoint_MovesAsFarAsThereIsRoom) {
  for (const TriangleObject &flat :
       {TriangleObject{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}, TriangleObject{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}},
        TriangleObject{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}) {
    const Scene scene{{{"T", flat}, {"P", withNumbers("point-on-triangle-plane", {q(1, 2), q(1, 4)}), "T"}}};
    const Object moved = movedTo(*findObject(scene, "P"), handle(scene, "P"), {9, 1, 1});
    const bool isPoint = isZero(flat.p1) && isZero(flat.p2);
    EXPECT_EQ(placeOn(moved, flat), isPoint ? ExactVec3(0) : ExactVec3(9, 0, 0));
  }
}

TEST(PointOnSphere, TowardsItsLowestPoint_ComesAsNearAsOneSees) {
  const Scene scene{{sphereS(), {"P", withNumbers("point-on-sphere", {0, 0}), "S"}}};
  EXPECT_EQ(placeOfP(scene), ExactVec3(1, 2, q(11, 2))) << "the highest";
  const Object lowest = movedTo(*findObject(scene, "P"), handle(scene, "P"), {1, 2, -100});
  EXPECT_NEAR(toDouble(placeOn(lowest, std::get<Object>(sphereS().content))->z), 0.5, 1e-4);
  EXPECT_EQ(movedTo(lowest, handle(scene, "P"), {1, 2, 3}), lowest) << "the centre says nothing";
}

TEST(BoundPoint, NearAnEdgeOfAnotherObject_CatchesWhereItsHostMeetsIt) {
  const Entry line{"g", LineObject{{0, 0, 0}, {1, 0, 0}}};
  const Entry corner{"Q", PointObject{{q(1, 3), 0, 0}}};
  const Entry beside{"R", PointObject{{2, q(1, 20), 0}}};
  const Scene scene{{line, corner, beside, {"P", withNumbers("point-on-line", {1}), "g"}}};
  const Handle dragged = handle(scene, "P");
  const auto to = [&](double x) {
    return snap({scene,
                 dragged,
                 snapTargets(scene, dragged),
                 {x, 0, 0},
                 Flat::line({0, 0, 0}, {1, 0, 0}),
                 1,
                 [](const Place &a, const Place &b) { return glm::distance(a, b) * 100; },
                 10});
  };
  EXPECT_EQ(to(0.35).at, ExactVec3(q(1, 3), 0, 0));
  EXPECT_EQ(to(0.35).caughtBy, "point Q");
  EXPECT_EQ(to(2.02).at, ExactVec3(2, 0, 0));
  EXPECT_EQ(to(2.02).caughtBy, "") << "R is not on the line";
}

TEST(BoundPoint, ForOtherHandles_IsAPlaceToCatchAtUnlessItMovesWithThem) {
  const Entry line{"g", LineObject{{0, 0, 0}, {1, 0, 0}}};
  const Entry third{"P", withNumbers("point-on-line", {q(1, 3)}), "g"};
  const Scene scene{{line, third, {"Q", PointObject{{5, 5, 0}}}}};
  const auto to = [&](const std::string &id) {
    return snap({scene,
                 handle(scene, id),
                 snapTargets(scene, handle(scene, id)),
                 {0.35, 0, 0},
                 Flat::plane({0, 0, 0}, {0, 0, 1}),
                 1,
                 [](const Place &a, const Place &b) { return glm::distance(a, b) * 100; },
                 10})
        .caughtBy;
  };
  EXPECT_EQ(to("Q"), "point P");
  EXPECT_EQ(to("g.A"), "") << "P goes where the line goes";
}

/// Two planes, the line where they meet, a point on it, and its distance from a third plane.
Scene meetingScene() {
  return {{planeE(),
           {"F", PlaneObject{{2, 6, 0}, {0, 1, 1}}},
           {"meet", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}},
           {"P", withNumbers("point-on-line", {2}), "meet.g"},
           {"G", PlaneObject{{0, 0, 0}, {0, 0, 1}}},
           {"distance", ConstructionUse{"signed-distance", {{"E", "G"}, {"Q", "P"}}}}}};
}

TEST(BoundPoint, OnALineThatAConstructionMakes_FeedsTheNextAndFollows) {
  const Scene scene = meetingScene();
  const ExactVec3 at = placeOfP(scene);
  EXPECT_EQ(at, ExactVec3(15, 1, 5)) << "two directions from the line's point";
  EXPECT_EQ(lastCase(scene), "positive");
  const ExactVec3 tilted = placeOfP(edited(scene, {ChangeObject{"F", PlaneObject{{2, 6, 0}, {0, 1, 2}}}}));
  EXPECT_EQ(dot(tilted - ExactVec3(5, 4, 7), ExactVec3(1, 2, 2)), 0);
  EXPECT_EQ(dot(tilted - ExactVec3(2, 6, 0), ExactVec3(0, 1, 2)), 0);
  const auto handles = handlesOf(scene);
  EXPECT_TRUE(std::any_of(handles.begin(), handles.end(), [](const Handle &each) { return each.id == "P"; }));
}

TEST(BoundPoint, FarOutOnALine_HasItsLineDrawnUpToIt) {
  const Scene scene = edited(meetingScene(), {ChangeObject{"P", withNumbers("point-on-line", {40})}});
  const Figure figure = figureOf(evaluate(scene));
  const Mark *mark = findMark(figure, "meet.g");
  const auto *line = mark ? std::get_if<LineMark>(mark) : nullptr;
  ASSERT_TRUE(line);
  const auto [low, high] = endsOf(*line);
  const Place at = toDouble(placeOfP(scene));
  EXPECT_GT(glm::dot(at - low, high - low), 0);
  EXPECT_GT(glm::dot(high - at, high - low), 0) << "it does not end before the point";
}

TEST(BoundPoint, OnALineThatIsNotThereNow_SaysSoAndComesBack) {
  const Scene parallel = edited(meetingScene(), {ChangeObject{"F", PlaneObject{{0, 0, 0}, {1, 2, 2}}}});
  const Evaluation evaluation = evaluate(parallel);
  EXPECT_EQ(
      evaluation.find("P")->missing,
      "The normals are multiples of each other, and no point lies in both planes: E and F are parallel. "
      "So there is no g to go on with.");
  EXPECT_EQ(lastCase(parallel), "missing-object");
  EXPECT_TRUE(evaluation.find("P")->outcome->figure->marks.empty());
  for (const Handle &each : handlesOf(parallel))
    EXPECT_NE(each.id, "P") << "what is not there is not grabbed";
  const Scene again = edited(parallel, {ChangeObject{"F", PlaneObject{{2, 6, 0}, {0, 1, 1}}}});
  EXPECT_EQ(placeOfP(again), placeOfP(meetingScene()));
}

TEST(BoundPoint, InALine_HasAPlaceButNoCoordinatesToScrub) {
  const Scene scene = meetingScene();
  const Evaluation evaluation = evaluate(scene);
  const Given<Object> &point = *evaluation.find("P")->looksAt.front();
  EXPECT_FALSE(point.isFree);
  const auto &at = evaluation.find("P")->outcome->values->front();
  EXPECT_EQ(plainText(*termOf(at.value)), "(" + toText(placeOfP(scene).x) + ", " + toText(placeOfP(scene).y) +
                                              ", " + toText(placeOfP(scene).z) + ")");
}

TEST(BoundPoint, InAFile_SaysWhatItLiesOnAndMustLieOnTheRightKind) {
  const auto read = [](const std::string &point) {
    return readSession(R"({"format":"halfspace","version":2,"lesson":"x","step":0,"scene":[)"
                       R"({"name":"g","line":{"A":["0","0","0"],"v":["1","0","0"]}},)"
                       R"({"name":"P",)" +
                           point + "}]}",
                       "x");
  };
  const auto good = read(R"("point-on-line":{"on":"g","lambda":"1/2"})");
  ASSERT_TRUE(good) << good.problem().text();
  EXPECT_EQ(placeOfP(good->scene), ExactVec3(q(1, 2), 0, 0));
  EXPECT_EQ(*readSession(writeSession(*good), "x"), *good);
  EXPECT_FALSE(read(R"("point-on-line":{"lambda":"1/2"})"));
  EXPECT_FALSE(read(R"("point-on-line":{"on":"h","lambda":"1/2"})"));
  EXPECT_FALSE(read(R"("point-on-line":{"on":"P","lambda":"1/2"})"));
  EXPECT_EQ(read(R"("point-on-ray":{"on":"g","lambda":"1/2"})").problem().sentence,
            "Here a ray is expected, but “g” is a line.");
  EXPECT_FALSE(read(R"("point":{"on":"g"})"));
}

std::string refusalOf(const Scene &scene, const Edit &edit) {
  const auto result = apply(scene, edit);
  return result ? "" : result.problem().sentence;
}

TEST(BoundPoint, WhenItsHostIsEdited_GoesWithItOrKeepsIt) {
  const Scene scene{{{"g", LineObject{{0, 0, 0}, {1, 0, 0}}},
                     {"h", LineObject{{0, 0, 5}, {0, 1, 0}}},
                     {"E", PlaneObject{}},
                     {"P", withNumbers("point-on-line", {3}), "g"}}};
  EXPECT_NE(refusalOf(scene, RemoveEntry{"g"}), "");
  EXPECT_EQ(edited(scene, {RemoveEntry{"g", true}}).entries.size(), 2U);
  EXPECT_EQ(edited(scene, {RenameEntry{"g", "k"}}).entries.back().on, "k");
  EXPECT_EQ(placeOfP(edited(scene, {RebindRole{"P", hostRole, "h"}})), ExactVec3(0, 3, 5));
  EXPECT_NE(refusalOf(scene, RebindRole{"P", hostRole, "E"}), "");
  EXPECT_NE(refusalOf(scene, RebindRole{"P", "Q", "h"}), "");
  EXPECT_NE(refusalOf(scene, RebindRole{"h", hostRole, "g"}), "") << "a line lies on nothing";
  EXPECT_NE(refusalOf(scene, MoveEntry{"P", 0}), "");
  EXPECT_NE(refusalOf(scene, AddEntry{4, {"S", PointObject{}, "g"}}), "");
}

TEST(FreedomStep, ForAnyLength_MovesThePointTwoStepsOfTheGridAtMost) {
  for (const Rational &gridStep : {Rational(1), q(1, 2), q(1, 10), q(1, 1000)})
    for (const int length : {1, 3, 40, 1000, 1000000}) {
      const Rational step = freedomStep(gridStep, Rational(length) * length);
      EXPECT_LE(step * length, 2 * gridStep);
      EXPECT_GT(step * length * 5, 2 * gridStep) << "and is no finer than it must be";
    }
  EXPECT_EQ(freedomStep(1, 1), 1);
  EXPECT_EQ(freedomStep(1, 0), 1) << "of what does not move";
  EXPECT_EQ(freedomStep(q(1, 10), Rational(1000000000) * 1000000000), finestFreedom);
}

TEST(BoundPoint, BesideALetterOfAConstruction_SaysWhoseItsOwnIs) {
  const Scene scene{{triangleT(),
                     rayL(),
                     {"P", withNumbers("point-on-ray", {1}), "L"},
                     {"hit", ConstructionUse{"ray-triangle-perp", {{"T", "T"}, {"L", "L"}}}}}};
  const Evaluation evaluation = evaluate(scene);
  EXPECT_EQ(plainText(evaluation.find("P")->own->letters.front()), "λ_P");
  EXPECT_FALSE(evaluation.find("hit")->naming.shared.contains("λ")) << "no other is plain";
}

TEST(BoundPoint, OnTheStageOfALargeScene_IsHandledWhereItIsSeen) {
  const Scene scene{{{"E", PlaneObject{{500, 0, 0}, {1, 0, 0}}},
                     {"F", PlaneObject{{0, 500, 0}, {0, 1, 0}}},
                     {"meet", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}},
                     {"P", withNumbers("point-on-line", {300}), "meet.g"}}};
  const PlacedScene placed(scene, evaluate(scene));
  ASSERT_EQ(placed.bound.size(), 1U);
  EXPECT_EQ(placed.bound.front().point->object[0], ExactVec3(500, 500, 300));
  EXPECT_EQ(PlacedScene(scene).bound.front().host->object, placed.bound.front().host->object);
  EXPECT_EQ(handle(scene, "P").at, ExactVec3(500, 500, 300));
}

} // namespace
} // namespace halfspace
