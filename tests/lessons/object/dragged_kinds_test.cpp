// Each handle of each kind: where it is, what a drag of it moves, and what stays as it is.
#include "lessons/scene/file/session_file.h"
#include "tests/lessons/object/spelled_objects.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

/// A drag of one handle, and the coordinates that are others afterwards.
struct Dragged {
  std::string kind;
  std::string handle; ///< of K
  ExactVec3 at;
  ExactVec3 way;
  std::map<std::string, ExactVec3> changed;
};

void PrintTo(const Dragged &dragged, std::ostream *stream) {
  *stream << dragged.handle << " of a " << dragged.kind;
}

struct EveryHandle : testing::TestWithParam<Dragged> {};

TEST_P(EveryHandle, WhenDragged_MovesItsOwnAndKeepsAllElse) {
  const Dragged &drag = GetParam();
  const Scene scene = spelledScene(spelledEntry(drag.kind));
  const Handle grabbed = handle(scene, drag.handle);
  EXPECT_EQ(grabbed.at, drag.at);
  const Object before = *findObject(scene, "K");
  const Object after = movedTo(before, grabbed, grabbed.at + drag.way);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto changed = drag.changed.find(std::string(coordinatesOf(before)[i].name));
    EXPECT_EQ(after[i], changed == drag.changed.end() ? before[i] : changed->second)
        << coordinatesOf(before)[i].name;
  }
}

const std::vector<Dragged> positions{{"point", "K", {1, 2, 3}, {1, 1, 1}, {{"", {2, 3, 4}}}},
                                     {"segment", "K.B", {5, 2, 3}, {0, 0, 1}, {{"B", {5, 2, 4}}}},
                                     {"line", "K.A", {1, 2, 3}, {1, 0, 0}, {{"A", {2, 2, 3}}}},
                                     {"polygon", "K.P2", {4, 4, 0}, {1, 1, 0}, {{"P2", {5, 5, 0}}}},
                                     {"tetrahedron", "K.P3", {0, 0, 4}, {0, 0, -1}, {{"P3", {0, 0, 3}}}},
                                     {"prism", "K.P1", {3, 0, 0}, {1, 0, 0}, {{"P1", {4, 0, 0}}}},
                                     {"box", "K.P0", {1, 2, 3}, {-1, -2, -3}, {{"P0", {0, 0, 0}}}},
                                     {"screen", "K.P0", {1, 2, 3}, {0, 1, 0}, {{"P0", {1, 3, 3}}}},
                                     {"sphere", "K.c", {1, 2, 3}, {5, 0, 0}, {{"c", {6, 2, 3}}}}};

const std::vector<Dragged> directions{{"vector", "K.v", {1, 2, 5}, {1, 0, 0}, {{"v", {1, 0, 2}}}},
                                      {"ray", "K.r", {1, 2, 5}, {0, 0, -2}, {{"r", {0, 0, 0}}}},
                                      {"plane", "K.n", {1, 2, 5}, {0, 2, -2}, {{"n", {0, 2, 0}}}},
                                      {"screen", "K.u", {5, 2, 3}, {4, 0, 0}, {{"u", {8, 0, 0}}}},
                                      {"screen", "K.v", {1, 2, 0}, {0, 1, 3}, {{"v", {0, 1, 0}}}},
                                      {"prism", "K.h", {0, 0, 5}, {1, 1, 0}, {{"h", {1, 1, 5}}}}};

/// Along an axis, whichever way the hand goes; a length is never below 0.
const std::vector<Dragged> alongAxes{{"box", "K.a", {5, 2, 3}, {2, 9, 9}, {{"a", {6, 0, 0}}}},
                                     {"box", "K.b", {1, 7, 3}, {9, -1, 9}, {{"b", {4, 0, 0}}}},
                                     {"box", "K.c", {1, 2, 9}, {0, 0, -8}, {{"c", {2, 0, 0}}}},
                                     {"sphere", "K.R", {5, 2, 3}, {3, 4, 0}, {{"R", {7, 0, 0}}}},
                                     {"sphere", "K.R", {5, 2, 3}, {-4, 0, 0}, {{"R", {0, 0, 0}}}},
                                     {"plane", "K.offset", {1, 2, 3}, {7, 7, 1}, {{"P0", {1, 2, 4}}}}};

const std::vector<Dragged> wholes{
    {"segment", "K.whole", {3, 2, 3}, {1, 1, 1}, {{"A", {2, 3, 4}}, {"B", {6, 3, 4}}}},
    {"triangle", "K.whole", {1, 1, 0}, {0, 0, 2}, {{"P0", {0, 0, 2}}, {"P1", {3, 0, 2}}, {"P2", {0, 3, 2}}}},
    {"prism", "K.whole", {1, 1, 0}, {1, 0, 0}, {{"P0", {1, 0, 0}}, {"P1", {4, 0, 0}}, {"P2", {1, 3, 0}}}},
    {"tetrahedron",
     "K.whole",
     {1, 1, 1},
     {-1, 0, 0},
     {{"P0", {-1, 0, 0}}, {"P1", {3, 0, 0}}, {"P2", {-1, 4, 0}}, {"P3", {-1, 0, 4}}}}};

INSTANTIATE_TEST_SUITE_P(Positions, EveryHandle, testing::ValuesIn(positions));
INSTANTIATE_TEST_SUITE_P(Directions, EveryHandle, testing::ValuesIn(directions));
INSTANTIATE_TEST_SUITE_P(AlongAxes, EveryHandle, testing::ValuesIn(alongAxes));
INSTANTIATE_TEST_SUITE_P(Wholes, EveryHandle, testing::ValuesIn(wholes));

std::vector<std::string> handleIds(const std::string &kind) {
  std::vector<std::string> ids;
  for (const Handle &each : handlesOf(spelledScene(spelledEntry(kind))))
    ids.push_back(each.id);
  return ids;
}

TEST(Handles, OfSolidsAndBalls_AreTheirCornersAndLengths) {
  using Ids = std::vector<std::string>;
  EXPECT_EQ(handleIds("box"), (Ids{"K.P0", "K.a", "K.b", "K.c"}));
  EXPECT_EQ(handleIds("sphere"), (Ids{"K.c", "K.R"}));
  EXPECT_EQ(handleIds("prism"), (Ids{"K.P0", "K.h", "K.P1", "K.P2", "K.whole"}));
  EXPECT_EQ(handleIds("tetrahedron"), (Ids{"K.P0", "K.P1", "K.P2", "K.P3", "K.whole"}));
  EXPECT_EQ(handleIds("number"), Ids()) << "it is no part of the picture";
}

TEST(Handles, OfAWhole_SnapTheirFirstCornerToTheGrid) {
  for (const char *kind : {"triangle", "polygon", "tetrahedron", "prism", "segment"}) {
    const Scene scene = spelledScene(spelledEntry(kind));
    const Handle whole = handle(scene, "K.whole");
    EXPECT_EQ(whole.at - whole.base, (*findObject(scene, "K"))[0]) << kind;
    EXPECT_FALSE(whole.hasAxis());
  }
}

TEST(Handles, OfFractions_MoveByExactlyThem) {
  const Scene scene = spelledScene("{name: K, sphere: {c: [1/3, 0, 0], R: 1/7}}");
  const Handle radius = handle(scene, "K.R");
  EXPECT_EQ(radius.at, ExactVec3(q(10, 21), 0, 0));
  EXPECT_EQ(movedTo(*findObject(scene, "K"), radius, {1, 0, 0})[1].x, q(2, 3));
}

/// The object after its kind has settled what cannot be.
Object settled(Object object) {
  object.kind().settle(object);
  return object;
}

TEST(Settle, LengthsBelowZero_AreZeroAndNothingElseMoves) {
  for (const auto &[kind, index] : {std::pair{"sphere", 1U}, {"box", 2U}}) {
    Object object = spelledObject(kind);
    object[index].x = -3;
    Object expected = object;
    expected[index].x = 0;
    EXPECT_EQ(settled(object), expected) << kind;
  }
  EXPECT_EQ(settled(spelledObject("box")), spelledObject("box"));
}

struct NumberSettled {
  ExactVec3 given; ///< value, from, to
  Rational value;
  Rational to;
};

struct SettledNumbers : testing::TestWithParam<NumberSettled> {};

TEST_P(SettledNumbers, AreWithinTheirBoundsWhichAreTheRightWayRound) {
  Object number = spelledObject("number");
  for (std::size_t i = 0; i < 3; ++i)
    number[i].x = GetParam().given[static_cast<int>(i)];
  number = settled(number);
  EXPECT_EQ(number[0].x, GetParam().value);
  EXPECT_EQ(number[1].x, GetParam().given.y) << "the lower bound stays";
  EXPECT_EQ(number[2].x, GetParam().to);
}

INSTANTIATE_TEST_SUITE_P(Numbers, SettledNumbers,
                         testing::Values(NumberSettled{{1, 0, 3}, 1, 3}, NumberSettled{{9, 0, 3}, 3, 3},
                                         NumberSettled{{-9, 0, 3}, 0, 3}, NumberSettled{{1, 2, -5}, 2, 2}));

TEST(Settle, TheNumbersOfAScreensPixels_AreWholeAndAtLeastOne) {
  const auto settledWidth = [](const Rational &width) {
    Object screen = spelledObject("screen");
    screen[3].x = width;
    return settled(screen)[3].x;
  };
  EXPECT_EQ(settledWidth(4), 4);
  EXPECT_EQ(settledWidth(q(7, 2)), 3);
  EXPECT_EQ(settledWidth(0), 1);
  EXPECT_EQ(settledWidth(-5), 1);
  EXPECT_EQ(settledWidth(1920), 64) << "more of them could not be told apart";
}

TEST(Settle, AScreenWithoutPixels_GetsIntoNoScene) {
  const Scene scene = spelledScene(spelledEntry("screen"));
  Object without = *findObject(scene, "K");
  without[3].x = 0;
  EXPECT_EQ((*findObject(edited(scene, {ChangeObject{"K", without}}), "K"))[3].x, 1);
  EXPECT_FALSE(apply(scene, AddEntry{1, {"M", without}}));
  EXPECT_FALSE(withValue({"x", 0, scene}, "K.w=0"));
  EXPECT_THROW(spelledScene("{name: K, screen: {P0: [1, 2, 3], u: [4, 0, 0], v: [0, 0, 3], w: 0, h: 3}}"),
               std::invalid_argument);
}

TEST(Settle, AStepBelowZero_IsNone) {
  Object number = spelledObject("number");
  number[3].x = -1;
  EXPECT_EQ(settled(number)[3].x, 0);
}

} // namespace
} // namespace halfspace
