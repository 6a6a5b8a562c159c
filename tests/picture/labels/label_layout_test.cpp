#include "widgets/picture/labels/label_layout.h"

#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace halfspace {
namespace {

constexpr PixelSize size{800, 600};

LabelRequest labelAt(const std::string &id, glm::dvec2 pixel, glm::dvec2 extent = {60, 24}) {
  return {id, extent, {{pixel, {1, -1}, 9}}};
}

bool overlap(const PlacedLabel &a, const PlacedLabel &b) {
  const glm::dvec2 common =
      glm::min(a.topLeft + a.extent, b.topLeft + b.extent) - glm::max(a.topLeft, b.topLeft);
  return common.x > 0 && common.y > 0;
}

TEST(LabelLayout, AloneALabelStandsOnTheSideThatIsLiked) {
  const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, {}, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_GE(placed[0].topLeft.x, 400);
  EXPECT_LE(placed[0].topLeft.y + 24, 300);
  EXPECT_FALSE(placed[0].needsLeader);
}

TEST(LabelLayout, LabelsOfNeighbouringPointsDoNotCoverEachOther) {
  std::vector<LabelRequest> requests;
  LabelObstacles points;
  for (int i = 0; i < 5; ++i) {
    const glm::dvec2 pixel(400 + 12 * i, 300 + 7 * (i % 2));
    requests.push_back(labelAt("P" + std::to_string(i), pixel));
    points.discs.push_back({pixel, 9});
  }
  const auto placed = LabelLayout().place(requests, points, size, 1);
  ASSERT_EQ(placed.size(), 5U);
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = i + 1; j < placed.size(); ++j)
      EXPECT_FALSE(overlap(placed[i], placed[j])) << i << " and " << j;
}

/// How far a label is from a pixel.
double distanceFrom(const PlacedLabel &label, glm::dvec2 pixel) {
  return distanceTo(PixelBox{label.topLeft, label.topLeft + label.extent}, pixel);
}

TEST(LabelLayout, OfTwoPointsSideBySide_EachIsNearerToItsOwn) {
  for (int degrees = 0; degrees < 360; degrees += 15)
    for (const double apart : {22.0, 40.0, 70.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      const std::array pixels{glm::dvec2(400, 300),
                              glm::dvec2(400, 300) + apart * glm::dvec2(std::cos(angle), std::sin(angle))};
      LabelObstacles points;
      for (const glm::dvec2 pixel : pixels)
        points.discs.push_back({pixel, 9, points.discs.size()});
      const auto placed =
          LabelLayout().place({labelAt("H", pixels[0]), labelAt("F", pixels[1])}, points, size, 1);
      ASSERT_EQ(placed.size(), 2U);
      for (const std::size_t own : {0U, 1U})
        EXPECT_TRUE(placed[own].needsLeader ||
                    distanceFrom(placed[own], pixels[own]) <= distanceFrom(placed[own], pixels[1 - own]))
            << placed[own].id << ", " << degrees << "°, " << apart;
    }
}

TEST(LabelLayout, OfAPointOnAnEdge_IsNotStruckThrough) {
  for (int degrees = 0; degrees < 180; degrees += 15) {
    const double angle = degrees * std::numbers::pi / 180;
    const glm::dvec2 way = 300.0 * glm::dvec2(std::cos(angle), std::sin(angle));
    LabelObstacles edge;
    edge.segments.push_back({glm::dvec2(400, 300) - way, glm::dvec2(400, 300) + way});
    const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, edge, size, 1);
    ASSERT_EQ(placed.size(), 1U);
    const PixelBox box{placed[0].topLeft, placed[0].topLeft + placed[0].extent};
    EXPECT_LT(lengthInside(box, edge.segments[0].from, edge.segments[0].to), 24) << degrees << "°";
  }
}

TEST(LabelLayout, OfALabelInPassing_NoOtherTakesNotice) {
  std::vector<LabelRequest> crowd;
  for (int i = 0; i < 8; ++i)
    crowd.push_back(labelAt("P" + std::to_string(i), {20 + 45 * (i % 4), 30 + 40 * (i / 4)}));
  constexpr PixelSize narrow{200, 100};
  const auto before = LabelLayout().place(crowd, {}, narrow, 1);
  const auto isLike = [&](const LabelRequest &other) {
    std::vector<LabelRequest> all = crowd;
    all.push_back(other);
    const auto placed = LabelLayout().place(all, {}, narrow, 1);
    return std::equal(before.begin(), before.end(), placed.begin(),
                      [](const auto &a, const auto &b) { return a.topLeft == b.topLeft; });
  };
  LabelRequest note = labelAt("note", {100, 50}, {120, 40});
  EXPECT_FALSE(isLike(note));
  note.stand = LabelStand::Passing;
  EXPECT_TRUE(isLike(note));
}

TEST(LabelLayout, AtEveryBorderALabelStaysOnTheScreen) {
  for (const glm::dvec2 corner :
       {glm::dvec2(1, 1), glm::dvec2(799, 1), glm::dvec2(1, 599), glm::dvec2(799, 599)}) {
    const auto placed = LabelLayout().place({labelAt("Q", corner)}, {}, size, 1);
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_GE(placed[0].topLeft.x, 0);
    EXPECT_GE(placed[0].topLeft.y, 0);
    EXPECT_LE(placed[0].topLeft.x + 60, 800);
    EXPECT_LE(placed[0].topLeft.y + 24, 600);
  }
}

TEST(LabelLayout, OffTheScreenTheNextAnchorIsUsed) {
  LabelRequest patch = labelAt("E", {-50, 100});
  EXPECT_TRUE(LabelLayout().place({patch}, {}, size, 1).empty());
  patch.anchors.push_back({{200, 200}, {1, 0}, 4});
  const auto placed = LabelLayout().place({patch}, {}, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_EQ(placed[0].anchor, glm::dvec2(200, 200));
}

TEST(LabelLayout, AlwaysStandsOnWholePixels) {
  const auto placed = LabelLayout().place({labelAt("Q", {400.37, 300.81})}, {}, size, 1);
  EXPECT_EQ(placed[0].topLeft, glm::round(placed[0].topLeft));
}

TEST(LabelLayout, StaysWhereItIsFine_WhereverItsLikedSideTurnsTo) {
  LabelLayout layout;
  LabelRequest request = labelAt("Q", {400, 300});
  const glm::dvec2 before = layout.place({request}, {}, size, 1)[0].topLeft;
  request.anchors.front().toward = {-1, 1};
  EXPECT_EQ(layout.place({request}, {}, size, 1)[0].topLeft, before);
}

TEST(LabelLayout, KeepsItsSideWhileAnotherPassesNearby) {
  LabelLayout layout;
  const glm::dvec2 before = layout.place({labelAt("Q", {400, 300})}, {}, size, 1)[0].topLeft;
  // A line now runs a little through the label: that alone is no reason to jump.
  LabelObstacles line;
  line.segments.push_back({before + glm::dvec2(0, 20), before + glm::dvec2(12, 24)});
  EXPECT_EQ(layout.place({labelAt("Q", {400, 300})}, line, size, 1)[0].topLeft, before);
}

TEST(LabelLayout, LeavesASideThatAnotherLabelTakes) {
  LabelLayout layout;
  const auto first = layout.place({labelAt("Q", {400, 300})}, {}, size, 1);
  LabelRequest pinned{"tick", {60, 24}, {{first[0].topLeft + glm::dvec2(30, 12), {}, 0}}, LabelStand::Pinned};
  const auto placed = layout.place({pinned, labelAt("Q", {400, 300})}, {}, size, 1);
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_EQ(placed[0].topLeft, first[0].topLeft);
  EXPECT_FALSE(overlap(placed[0], placed[1]));
}

TEST(LabelLayout, HemmedInALabelMovesAwayAndGetsALeaderLine) {
  LabelObstacles crowd;
  for (int x = -4; x <= 4; ++x)
    for (int y = -2; y <= 2; ++y)
      crowd.discs.push_back({{400 + 22 * x, 300 + 18 * y}, 9});
  const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, crowd, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_TRUE(placed[0].needsLeader);
}

TEST(LabelLayout, PinnedALabelIsCentredOnItsAnchor) {
  const LabelRequest tick{"tick", {60, 24}, {{{400, 300}, {}, 9}}, LabelStand::Pinned};
  const auto placed = LabelLayout().place({tick}, {}, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_EQ(placed[0].topLeft, glm::dvec2(370, 288));
}

TEST(LabelLayout, PinnedALabelIsLeftOutWhereItCannotBeRead) {
  const LabelRequest tick{"tick", {60, 24}, {{{400, 300}, {}, 9}}, LabelStand::Pinned};
  const auto count = [&](const LabelObstacles &obstacles, glm::dvec2 at = {400, 300}) {
    LabelRequest moved = tick;
    moved.anchors.front().pixel = at;
    return LabelLayout().place({moved}, obstacles, size, 1).size();
  };
  LabelObstacles ball;
  ball.discs.push_back({{400, 300}, 30});
  EXPECT_EQ(count(ball), 0U);
  LabelObstacles line;
  line.segments.push_back({{300, 300}, {500, 300}, true});
  EXPECT_EQ(count(line), 0U);
  line.segments.front().isThick = false;
  EXPECT_EQ(count(line), 1U);
  LabelObstacles card;
  card.covered.push_back({{420, 290}, {600, 310}});
  EXPECT_EQ(count(card), 0U);
  EXPECT_EQ(count({}, {10, 300}), 0U) << "it would not be where it belongs";
  LabelRequest second = tick;
  second.id = "second";
  EXPECT_EQ(LabelLayout().place({tick, second}, {}, size, 1).size(), 1U);
}

TEST(LabelLayout, UnderWhatCoversThePictureNoLabelStands) {
  LabelObstacles card;
  card.covered.push_back({{380, 100}, {800, 320}});
  const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, card, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  const PixelBox &box = card.covered.front();
  EXPECT_TRUE(placed[0].topLeft.x + 60 <= box.low.x || placed[0].topLeft.y >= box.high.y);
  card.covered.front() = {{0, 0}, {800, 600}};
  EXPECT_TRUE(LabelLayout().place({labelAt("Q", {400, 300})}, card, size, 1).empty());
}

/// One room for both, where they lie on one another by half, and one for A alone, where a thick line crosses
/// it: worse for A, and better for both together.
TEST(LabelLayout, OfTwoInEachOthersWay_OneMakesRoomForBoth) {
  LabelObstacles obstacles;
  obstacles.covered = {{{0, 0}, {800, 280}},
                       {{0, 310}, {800, 600}},
                       {{0, 280}, {190, 310}},
                       {{280, 280}, {300, 310}},
                       {{396, 280}, {800, 310}}};
  obstacles.segments.push_back({{200, 295}, {270, 295}, true});
  const auto placed =
      LabelLayout().place({labelAt("A", {290, 295}), labelAt("B", {402, 295})}, obstacles, size, 1);
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_FALSE(overlap(placed[0], placed[1]));
  EXPECT_LT(placed[0].topLeft.x, 280);
}

TEST(LabelLayout, CrossedByAThickLineOnAllSidesALabelRatherGoesFar) {
  LabelObstacles lines;
  for (int row = 220; row <= 380; row += 10)
    lines.segments.push_back({{340, row}, {460, row}, true});
  const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, lines, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_TRUE(placed[0].needsLeader);
  const glm::dvec2 low = placed[0].topLeft;
  EXPECT_TRUE(low.x >= 460 || low.x + 60 <= 340 || low.y >= 380 || low.y + 24 <= 220);
}

TEST(LabelLayout, ForWhatComesAndGoesNoOtherLabelMoves) {
  const auto alone = LabelLayout().place({labelAt("Q", {400, 300})}, {}, size, 1);
  LabelRequest note = labelAt("note", {400, 300});
  note.stand = LabelStand::Passing;
  LabelObstacles tools;
  tools.tools.push_back({{400, 300}, alone[0].topLeft + glm::dvec2(60, 0)});
  const auto both = LabelLayout().place({note, labelAt("Q", {400, 300})}, tools, size, 1);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].topLeft, alone[0].topLeft);
  EXPECT_FALSE(overlap(both[0], both[1]));
}

TEST(LabelLayout, WithoutRoomWhatComesAndGoesIsLeftOut) {
  LabelObstacles crowd;
  for (int x = 0; x <= 800; x += 20)
    for (int y = 0; y <= 600; y += 20)
      crowd.discs.push_back({{x, y}, 9});
  LabelRequest note = labelAt("note", {400, 300});
  EXPECT_EQ(LabelLayout().place({note}, crowd, size, 1).size(), 1U);
  note.stand = LabelStand::Passing;
  EXPECT_TRUE(LabelLayout().place({note}, crowd, size, 1).empty());
}

/// The line that leads to a label.
LabelObstacles::Segment leaderOf(const PlacedLabel &label) {
  return leaderTo({label.topLeft, label.topLeft + label.extent}, label.anchor);
}

TEST(LabelLayout, OfManyWithLeaders_NoneIsStruckThroughByAnothersLeader) {
  LabelObstacles crowd;
  for (int x = -5; x <= 5; ++x)
    for (int y = -3; y <= 3; ++y)
      crowd.discs.push_back({{400 + 22 * x, 300 + 18 * y}, 9});
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 4; ++i)
    requests.push_back(labelAt("P" + std::to_string(i), {367 + 22 * i, 300}));
  const auto placed = LabelLayout().place(requests, crowd, size, 1);
  ASSERT_EQ(placed.size(), 4U);
  for (const PlacedLabel &label : placed) {
    ASSERT_TRUE(label.needsLeader);
    const auto leader = leaderOf(label);
    for (const PlacedLabel &other : placed)
      EXPECT_TRUE(other.id == label.id ||
                  lengthInside({other.topLeft, other.topLeft + other.extent}, leader.from, leader.to) == 0)
          << label.id << " through " << other.id;
  }
}

TEST(LabelLayout, OfTwoLinesSideBySide_EachIsNearerToItsOwn) {
  for (const double apart : {14.0, 20.0, 26.0}) {
    LabelObstacles lines;
    std::vector<LabelRequest> requests;
    for (const std::size_t i : {0U, 1U}) {
      const double y = 300 + apart * static_cast<double>(i);
      lines.segments.push_back({{100, y}, {700, y}, false, i});
      LabelRequest request{"g" + std::to_string(i), {20, 24}, {}};
      for (const double x : {400.0, 500.0, 300.0})
        request.anchors.push_back({{x, y}, {0, -1}, 5});
      request.owner = i;
      requests.push_back(request);
    }
    const auto placed = LabelLayout().place(requests, lines, size, 1);
    ASSERT_EQ(placed.size(), 2U);
    EXPECT_LT(placed[0].topLeft.y, 300) << "above both, " << apart;
    EXPECT_GT(placed[1].topLeft.y, 300 + apart) << "below both, " << apart;
  }
}

TEST(LabelLayout, OfAnArrowThatEndsInAPointWithALabel_StandsBesideItsShaft) {
  LabelRequest arrow{"v", {20, 24}, {{{400, 300}, {1, -0.4}, 9}, {{300, 300}, {0, -1}, 5}}};
  arrow.owner = 0;
  LabelObstacles obstacles;
  obstacles.segments.push_back({{200, 300}, {400, 300}, true, 0});
  EXPECT_GT(LabelLayout().place({arrow}, obstacles, size, 1)[0].topLeft.x, 390) << "beyond its tip";
  obstacles.discs.push_back({{400, 300}, 9, 1});
  EXPECT_LT(LabelLayout().place({arrow}, obstacles, size, 1)[0].topLeft.x, 350) << "it would be the point's";
}

TEST(LabelLayout, OfALineWithAnArrowOnIt_DoesNotStandBesideTheArrow) {
  LabelRequest line{"g", {20, 24}, {{{400, 300}, {0, -1}, 5}, {{550, 300}, {0, -1}, 5}}};
  line.owner = 0;
  LabelObstacles obstacles;
  obstacles.segments.push_back({{100, 300}, {700, 300}, false, 0});
  EXPECT_LT(LabelLayout().place({line}, obstacles, size, 1)[0].topLeft.x, 420);
  obstacles.segments.push_back({{350, 300}, {450, 300}, true, 1});
  EXPECT_GT(LabelLayout().place({line}, obstacles, size, 1)[0].topLeft.x, 500);
}

TEST(LabelLayout, OfTwoSideBySide_AreNotReadAsOne) {
  const auto placed = LabelLayout().place({labelAt("h", {400, 300}), labelAt("v", {465, 302})}, {}, size, 1);
  ASSERT_EQ(placed.size(), 2U);
  const bool areInOneRow =
      placed[0].topLeft.y < placed[1].topLeft.y + 24 && placed[1].topLeft.y < placed[0].topLeft.y + 24;
  const double gap = placed[1].topLeft.x - (placed[0].topLeft.x + 60);
  EXPECT_TRUE(!areInOneRow || gap >= 8) << gap;
}

TEST(LabelLayout, OfARowOfPinnedLabelsWithoutRoomForAll_EverySecondIsThere) {
  std::vector<LabelRequest> numbers;
  for (int i = 1; i <= 6; ++i)
    numbers.push_back({"tick " + std::to_string(i),
                       {30, 20},
                       {{{200 + 22 * i, 300}, {}, 0}},
                       LabelStand::Pinned,
                       nobody,
                       {1, i}});
  std::vector<std::string> ids;
  for (const PlacedLabel &label : LabelLayout().place(numbers, {}, size, 1))
    ids.push_back(label.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"tick 2", "tick 4", "tick 6"}));
}

TEST(LabelLayout, WhenTheCrowdIsGoneALabelComesBackFromAfar) {
  LabelLayout layout;
  LabelObstacles crowd;
  for (int x = -4; x <= 4; ++x)
    for (int y = -2; y <= 2; ++y)
      crowd.discs.push_back({{400 + 22 * x, 300 + 18 * y}, 9});
  ASSERT_TRUE(layout.place({labelAt("Q", {400, 300})}, crowd, size, 1)[0].needsLeader);
  EXPECT_FALSE(layout.place({labelAt("Q", {400, 300})}, {}, size, 1)[0].needsLeader);
}

TEST(LabelLayout, WithALineOnTheLikedSideALabelTakesAnother) {
  LabelObstacles line;
  line.segments.push_back({{390, 280}, {500, 280}});
  const auto placed = LabelLayout().place({labelAt("Q", {400, 300})}, line, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  const double top = placed[0].topLeft.y;
  EXPECT_TRUE(top > 280 || top + 24 < 280) << "it does not cross the line";
  EXPECT_LT(glm::distance(placed[0].anchor, placed[0].topLeft), 100) << "nor does it go far";
}

TEST(LabelLayout, OnAFinerScreenALabelStandsTwiceAsFarOff) {
  const auto gapAt = [](double pixelRatio) {
    LabelRequest request = labelAt("Q", {400, 300});
    request.anchors[0] = {{400, 300}, {1, 0}, 0};
    return LabelLayout().place({request}, {}, size, pixelRatio)[0].topLeft.x - 400;
  };
  EXPECT_GT(gapAt(1), 0);
  EXPECT_DOUBLE_EQ(gapAt(2), 2 * gapAt(1));
}

TEST(LabelLayout, WithoutALikedSideALabelStandsSomewhereBesideItsAnchor) {
  LabelRequest request = labelAt("T", {400, 300});
  request.anchors[0].toward = {0, 0};
  const auto placed = LabelLayout().place({request}, {}, size, 1);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_LT(glm::distance(placed[0].topLeft + glm::dvec2(30, 12), glm::dvec2(400, 300)), 80);
}

TEST(LabelLayout, ForgottenForAFrameALabelIsPlacedAnew) {
  LabelLayout layout;
  LabelObstacles crowd;
  crowd.discs.push_back({{430, 280}, 20});
  const glm::dvec2 dodging = layout.place({labelAt("Q", {400, 300})}, crowd, size, 1)[0].topLeft;
  const glm::dvec2 kept = layout.place({labelAt("Q", {400, 300})}, {}, size, 1)[0].topLeft;
  EXPECT_EQ(kept, dodging) << "it stays where it was";
  (void)layout.place({}, {}, size, 1);
  EXPECT_NE(layout.place({labelAt("Q", {400, 300})}, {}, size, 1)[0].topLeft, dodging);
}

} // namespace
} // namespace halfspace
