#include "widgets/picture/labels/label_page.h"

#include "tests/picture/labels/vectors_only.h"

namespace halfspace {
namespace {

const LabelStyle style{{0, 0, 0}, {255, 255, 255}, 20};
const View view{{}, {800, 600}, 1};

WrittenLabel labelAt(const std::string &id, const std::string &latex, glm::dvec2 pixel) {
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

TEST(LabelSetter, OfTheSameLatex_GivesTheSameFormula_ForAsLongAsItIsInUse) {
  const LabelSetter set = vectorsOnly();
  const LabelFormula first = set("P_0");
  EXPECT_EQ(set("P_0"), first);
  EXPECT_NE(set("P_1"), first);
  for (int frame = 0; frame < 20; ++frame) {
    for (int i = 0; i < 100; ++i)
      static_cast<void>(set(std::to_string(100 * frame + i)));
    ASSERT_EQ(set("P_0"), first) << frame;
  }
}

TEST(LabelSetter, OfWhatIsNoLatex_SetsItsSource) { EXPECT_FALSE(vectorsOnly()("\\frac{a")->glyphs.empty()); }

TEST(LabelShapes, AreLeadersUnderLabels_AndNameTheirMarks) {
  WrittenLabel mark = labelAt("Q", "Q", {400, 300});
  mark.isMark = true;
  std::vector<LabelOnPage> page =
      LabelPage().place({mark, labelAt("tick", "5", {100, 500})}, {}, vectorsOnly(), view);
  ASSERT_EQ(page.size(), 2U);
  page.back().place.needsLeader = true;
  const Color gray{9, 9, 9};
  const std::vector<Shape> shapes = shapesOf(page, gray, 2);
  ASSERT_EQ(shapes.size(), 3U);
  const auto *leader = std::get_if<LeaderShape>(&shapes[0].form);
  ASSERT_TRUE(leader);
  EXPECT_EQ(shapes[0].color, gray);
  EXPECT_EQ(leader->from, page.back().place.anchor);
  EXPECT_EQ(leader->width, 2);
  const auto *label = std::get_if<LabelShape>(&shapes[1].form);
  ASSERT_TRUE(label);
  EXPECT_EQ(shapes[1].mark, "Q");
  EXPECT_EQ(label->formula, page.front().formula);
  EXPECT_EQ(label->box.low, page.front().place.topLeft);
  EXPECT_EQ(label->box.extent(), page.front().place.extent);
  EXPECT_EQ(shapes[2].mark, "") << "a number at an axis is no mark";
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
