#include "widgets/picture/free_rooms.h"

#include "widgets/picture/screen_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

const PixelBox whole{{0, 0}, {800, 600}};

bool contains(const std::vector<PixelBox> &rooms, const PixelBox &wanted) {
  return std::find(rooms.begin(), rooms.end(), wanted) != rooms.end();
}

TEST(FreeRooms, WithNothingCovered_AreTheWholeRoom) {
  EXPECT_EQ(freeRooms(whole, {}), std::vector<PixelBox>{whole});
  EXPECT_EQ(freeRooms(whole, {{{900, 0}, {950, 50}}}), std::vector<PixelBox>{whole});
}

TEST(FreeRooms, BesideTwoCorners_ReachAsFarAsTheyCan) {
  const std::vector<PixelBox> covered{{{0, 550}, {400, 600}}, {{760, 0}, {800, 150}}};
  const auto rooms = freeRooms(whole, covered);
  EXPECT_EQ(rooms.size(), 4U);
  EXPECT_TRUE(contains(rooms, {{0, 0}, {760, 550}}));
  EXPECT_TRUE(contains(rooms, {{0, 150}, {800, 550}}));
  EXPECT_TRUE(contains(rooms, {{400, 0}, {760, 600}}));
  EXPECT_TRUE(contains(rooms, {{400, 150}, {800, 600}}));
  for (const PixelBox &room : rooms)
    for (const PixelBox &hole : covered)
      EXPECT_EQ(overlapArea(room, hole), 0);
}

TEST(FreeRooms, WithEverythingCovered_AreNone) { EXPECT_TRUE(freeRooms(whole, {whole}).empty()); }

} // namespace
} // namespace halfspace
