#include "widgets/exports/painting.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr double pageWidth = 240;

/// A piece of the line through two places, from one part of its way to another.
PaintedThing pieceOf(double begin, double end, double reach, const std::string &mark, const Paper &paper) {
  const Place from(6, -3, 1);
  const Place to(-8, 4, 2);
  PaintedThing thing;
  thing.spine = {paper.spotOf(glm::mix(from, to, begin)), paper.spotOf(glm::mix(from, to, end))};
  thing.reach = reach;
  thing.parts.push_back({{}, {}, Pen{}, mark});
  return thing;
}

TEST(PaintingOrder, OfWhatLiesInOneLine_HasTheThickerOverTheThinner_HoweverFarTheyReach) {
  for (const bool orthographic : {false, true}) {
    ShapeList list;
    list.view = {{}, {1200, 800}, 1};
    list.view.camera.target = {0, 0, 0};
    list.view.camera.orthographic = orthographic;
    const Paper paper(list, pageWidth);
    for (const auto &[begin, end] : {std::pair(0.0, 1.0), {0.3, 0.9}, {0.5, 1.0}, {0.1, 0.35}})
      for (const bool isThickFirst : {false, true}) {
        std::vector<PaintedThing> things{pieceOf(0.2, 0.8, 4, "thick", paper),
                                         pieceOf(begin, end, 2, "thin", paper)};
        if (!isThickFirst)
          std::swap(things[0], things[1]);
        const std::vector<PathPart> parts = inPaintingOrder(Veils(paper), {}, std::move(things));
        ASSERT_EQ(parts.size(), 2U);
        EXPECT_EQ(parts.back().mark, "thick") << "from " << begin << " to " << end;
      }
  }
}

} // namespace
} // namespace halfspace
