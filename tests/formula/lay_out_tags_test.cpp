#include "tests/formula/laid_out.h"

#include <set>

namespace halfspace::math {
namespace {

/// The one box of a tag.
Rectangle boxOf(const Layout &layout, const std::string &name) {
  std::vector<Rectangle> boxes;
  for (const TagBox &tagBox : layout.tagBoxes)
    if (layout.tags[static_cast<std::size_t>(tagBox.tag)].id == TagId(name))
      boxes.push_back(tagBox.box);
  EXPECT_EQ(boxes.size(), 1U) << name;
  return boxes.empty() ? Rectangle() : boxes.front();
}

void expectContains(const Rectangle &box, const Rectangle &inside, const std::string &where) {
  // As far as an italic letter may stand out of its room.
  constexpr double overhang = 0.06;
  EXPECT_LE(box.x, inside.x + overhang) << where;
  EXPECT_GE(box.right(), inside.right() - overhang) << where;
  EXPECT_LE(box.y, inside.y + rounding) << where;
  EXPECT_GE(box.bottom(), inside.bottom() - rounding) << where;
}

const std::vector<std::string> tagged{"\\mark{a}{x+y}=z",
                                      "\\frac{\\mark{a}{x}+1}{\\mark{b}{\\sqrt{\\mark{c}{y}}}}",
                                      "\\left(\\mark{a}{\\frac 12}\\right)^{\\mark{b}{n}}_{\\mark{c}i}",
                                      "\\mark{a}{x}^2+\\mark{b}{\\vec{\\mark{c}{u}}}",
                                      "\\begin{pmatrix}\\mark{a}{1}&2\\\\3&\\mark{b}{4}\\end{pmatrix}",
                                      "\\sum_{\\mark{a}{i}=1}^{\\mark{b}n}\\mark{c}{\\mark{d}{x_i}}",
                                      "\\text{so $\\mark{a}x$}\\underbrace{\\mark{b}{y}}_{\\mark{c}{z}}",
                                      "\\mark{a}{\\sum}_{i}"};

TEST(Tags, ABox_ContainsWhatIsTagged) {
  for (const std::string &source : tagged) {
    const Layout layout = laidOut(source);
    std::vector<Rectangle> boxes(layout.tags.size());
    for (const TagBox &tagBox : layout.tagBoxes)
      boxes[static_cast<std::size_t>(tagBox.tag)] = tagBox.box;
    int found = 0;
    for (const PlacedGlyph &glyph : layout.glyphs)
      for (int tag = glyph.ink.tag; tag != noTag;
           tag = layout.tags[static_cast<std::size_t>(tag)].parent, ++found)
        expectContains(boxes[static_cast<std::size_t>(tag)], inkOf(glyph), source);
    EXPECT_GT(found, 0) << source;
  }
}

TEST(Tags, ABox_IsNoLargerThanWhatIsTagged) {
  for (const std::string &source : tagged) {
    const Layout layout = laidOut(source);
    for (const TagBox &tagBox : layout.tagBoxes) {
      EXPECT_LE(tagBox.box.right(), layout.width + rounding) << source;
      EXPECT_GE(tagBox.box.y, -layout.ascent - rounding) << source;
      EXPECT_LE(tagBox.box.bottom(), layout.depth + rounding) << source;
    }
  }
  const Layout layout = laidOut("a+\\mark{m}{b}+c");
  EXPECT_NEAR(boxOf(layout, "m").width, laidOut("b").width, rounding);
  EXPECT_NEAR(boxOf(layout, "m").x, letterIn(layout, 'b').x, rounding);
}

TEST(Tags, Inner_ComeAfterOuterAndKnowThem) {
  const Layout layout = laidOut("\\mark{a}{x+\\frac{\\mark{b}{y}}{\\mark{c}{z}}}\\mark{d}{w}");
  ASSERT_EQ(layout.tags.size(), 4U);
  EXPECT_EQ(layout.tags[0].id, TagId("a"));
  EXPECT_EQ(layout.tags[1].id, TagId("b"));
  EXPECT_EQ(layout.tags[2].id, TagId("c"));
  EXPECT_EQ(layout.tags[3].id, TagId("d"));
  EXPECT_EQ(layout.tags[0].parent, noTag);
  EXPECT_EQ(layout.tags[1].parent, 0);
  EXPECT_EQ(layout.tags[2].parent, 0);
  EXPECT_EQ(layout.tags[3].parent, noTag);
}

TEST(Tags, TheSameNameTwice_IsTwoTags) {
  const Layout layout = laidOut("\\mark{a}{x}+\\mark{a}{y}");
  EXPECT_EQ(layout.tags.size(), 2U);
  EXPECT_EQ(layout.tagBoxes.size(), 2U);
}

TEST(Tags, ByIndex_StandAmongThoseByNameAndChangeNoPlace) {
  const auto formulaWith = [](Row number) {
    return row(math::tagged("outer", row(letter('x'), symbol('+', AtomClass::Bin), std::move(number))));
  };
  const Layout plain = layOut(formulaWith(number("12")), fonts());
  const Layout layout = layOut(formulaWith(row(math::tagged(std::size_t{7}, number("12")))), fonts());
  ASSERT_EQ(layout.tags.size(), 2U);
  EXPECT_EQ(layout.tags[1].id, TagId(std::size_t{7}));
  EXPECT_EQ(layout.tags[1].parent, 0);
  ASSERT_EQ(layout.glyphs.size(), plain.glyphs.size());
  for (std::size_t i = 0; i < plain.glyphs.size(); ++i)
    EXPECT_EQ(layout.glyphs[i].x, plain.glyphs[i].x);
}

TEST(Tags, RulesOfATaggedFraction_AreTagged) {
  const Layout layout = laidOut("\\mark{a}{\\frac 12}\\frac 34");
  ASSERT_EQ(layout.rules.size(), 2U);
  EXPECT_EQ(layout.rules[0].ink.tag, 0);
  EXPECT_EQ(layout.rules[1].ink.tag, noTag);
}

TEST(Tags, AnEmptyTag_HasABoxWithoutSize) {
  const Rectangle box = boxOf(laidOut("x\\mark{a}{}y"), "a");
  EXPECT_EQ(box.width, 0);
  EXPECT_EQ(box.height, 0);
}

TEST(Colours, TheInnermost_IsTheInk) {
  const Layout layout = laidOut("a\\color{red}{b\\color{blue}{c}d}e");
  EXPECT_EQ(letterIn(layout, 'a').ink.color, std::nullopt);
  EXPECT_EQ(letterIn(layout, 'b').ink.color, (Color{255, 0, 0}));
  EXPECT_EQ(letterIn(layout, 'c').ink.color, (Color{0, 0, 255}));
  EXPECT_EQ(letterIn(layout, 'd').ink.color, (Color{255, 0, 0}));
  EXPECT_EQ(letterIn(layout, 'e').ink.color, std::nullopt);
}

TEST(Colours, AMiddleFence_HasTheColourAroundIt) {
  const Layout layout = laidOut("\\left(\\frac ab\\color{red}{\\middle/}c\\right)");
  int red = 0;
  for (const PlacedGlyph &glyph : layout.glyphs)
    red += glyph.ink.color ? 1 : 0;
  EXPECT_EQ(red, 1);
}

} // namespace
} // namespace halfspace::math
