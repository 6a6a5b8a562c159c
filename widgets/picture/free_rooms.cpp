#include "widgets/picture/free_rooms.h"

#include "widgets/picture/screen_shapes.h"

#include <algorithm>

namespace halfspace {
namespace {

/// What is left of a room on the four sides of a rectangle in it.
std::vector<PixelBox> roomsAround(const PixelBox &hole, const PixelBox &room) {
  std::vector<PixelBox> rooms{{room.low, {hole.low.x, room.high.y}},
                              {{hole.high.x, room.low.y}, room.high},
                              {room.low, {room.high.x, hole.low.y}},
                              {{room.low.x, hole.high.y}, room.high}};
  std::erase_if(rooms, [](const PixelBox &each) {
    const glm::dvec2 extent = each.extent();
    return extent.x <= 0 || extent.y <= 0;
  });
  return rooms;
}

bool lieIn(const PixelBox &inner, const PixelBox &outer) {
  return glm::max(inner.low, outer.low) == inner.low && glm::min(inner.high, outer.high) == inner.high;
}

} // namespace

std::vector<PixelBox> freeRooms(const PixelBox &room, const std::vector<PixelBox> &covered) {
  std::vector<PixelBox> free{room};
  for (const PixelBox &hole : covered) {
    std::vector<PixelBox> rest;
    const auto keep = [&](const PixelBox &found) {
      const auto holds = [&](const PixelBox &other) { return lieIn(found, other); };
      if (std::none_of(rest.begin(), rest.end(), holds))
        rest.push_back(found);
    };
    // Those that stay whole first: of the pieces only those count that lie in none of them.
    std::stable_partition(free.begin(), free.end(),
                          [&](const PixelBox &each) { return overlapArea(each, hole) == 0; });
    for (const PixelBox &each : free)
      if (overlapArea(each, hole) == 0)
        keep(each);
      else
        for (const PixelBox &piece : roomsAround(hole, each))
          keep(piece);
    free = std::move(rest);
  }
  return free;
}

} // namespace halfspace
