#include "widgets/picture/labels/label_page.h"

#include "tests/picture/labels/vectors_only.h"

namespace halfspace {
namespace {

const LabelStyle style{{0, 0, 0}, {255, 255, 255}, 20};
const View view{{}, {800, 600}, 1};

LabelText labelAt(const std::string &id, const std::string &latex, glm::dvec2 pixel) {
  return {id, latex, style, {{pixel, {1, -1}, 9}}};
}

TEST(LabelRoom, HoldsTheFormulaWithItsHaloAtEverySize) {
  const math::Layout fraction = math::laidOut("\\frac{a}{b}");
  for (const double pixels : {9.0, 20.0, 21.3, 55.0}) {
    const LabelRoom room = roomOf(fraction, {{}, {}, pixels});
    const double halo = haloWidth * pixels;
    EXPECT_GE(room.left, halo);
    EXPECT_GE(room.width - room.left - fraction.width * pixels, halo);
    EXPECT_GE(room.baseline - fraction.ascent * pixels, halo);
    EXPECT_GE(room.height - room.baseline - fraction.depth * pixels, halo);
    EXPECT_LE(room.width, fraction.width * pixels + 2 * halo + 6) << "and hardly more";
  }
}

TEST(LabelPage, OfLabels_HasTheirFormulasAsVectorsWhereTheyStand) {
  const auto page = LabelPage().place({labelAt("Q", "Q", {400, 300}), labelAt("E", "\\vec n_E", {100, 500})},
                                      {}, vectorsOnly(), view);
  ASSERT_EQ(page.size(), 2U);
  for (const LabelOnPage &label : page) {
    EXPECT_EQ(label.text.id, label.place.id);
    EXPECT_FALSE(label.formula->glyphs.empty());
    const LabelRoom room = roomOf(*label.formula, style);
    EXPECT_EQ(label.place.extent, glm::dvec2(room.width, room.height));
    const glm::dvec2 way = label.place.topLeft - label.text.anchors.front().pixel;
    EXPECT_LT(std::max(std::abs(way.x), std::abs(way.y)), 60) << "beside its anchor";
  }
}

TEST(LabelPage, WithEmptyLabelsOrSomeOffTheScreen_LeavesThemOut) {
  const auto page = LabelPage().place(
      {labelAt("a", "", {400, 300}), labelAt("b", "b", {-90, 300}), labelAt("c", "c", {400, 300})}, {},
      vectorsOnly(), view);
  ASSERT_EQ(page.size(), 1U);
  EXPECT_EQ(page.front().text.id, "c");
}

TEST(Leader, LeadsFromTheAnchorToTheNearestPlaceOfTheLabel) {
  PlacedLabel label{"Q", {100, 100}, {40, 20}, {50, 110}, true};
  const auto leader = leaderOf(label);
  ASSERT_TRUE(leader);
  EXPECT_EQ(leader->from, glm::dvec2(50, 110));
  EXPECT_EQ(leader->to, glm::dvec2(100, 110));
  label.needsLeader = false;
  EXPECT_FALSE(leaderOf(label));
}

} // namespace
} // namespace halfspace
