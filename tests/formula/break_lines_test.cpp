#include "tests/formula/laid_out.h"

#include "widgets/formula/break_lines.h"

#include <cmath>

namespace halfspace::math {
namespace {

const std::vector<std::string> lines{
    "\\vec u^{\\perp} = (\\vec u\\cdot\\vec u)\\vec v - (\\vec u\\cdot\\vec v)\\vec u = 80(-4,-7,9)",
    "a+b+c+d+e+f+g+h+i+j+k+l+m+n+o+p+q+r+s+t+u+v+w+x+y+z",
    "1\\cdot 2\\cdot 3\\cdot 4\\cdot 5\\cdot 6\\cdot 7\\cdot 8\\cdot 9\\cdot 10",
    "s=\\frac 14,\\quad t=\\frac 12,\\quad s+t=\\frac 34",
    "\\mark{a}{x=\\mark{b}{(a_1+a_2)}\\cdot b+c_1+c_2+c_3+\\frac{\\mark{q}{1}}{2}}+e+f+g"};

LineRules width(double em) {
  LineRules rules;
  rules.width = em;
  return rules;
}

/// The line that a height belongs to.
std::size_t lineAt(const Layout &layout, double y) {
  for (std::size_t i = 0; i < layout.lines.size(); ++i)
    if (y >= layout.lines[i].baseline - layout.lines[i].ascent - rounding &&
        y <= layout.lines[i].baseline + layout.lines[i].depth + rounding)
      return i;
  ADD_FAILURE() << "no line at " << y;
  return 0;
}

TEST(BreakLines, WhatFits_StaysAsItIs) {
  const Layout whole = laidOut("a=b+c");
  const Layout same = breakLines(whole, width(whole.width));
  EXPECT_EQ(same.lines.size(), 1U);
  EXPECT_EQ(same.width, whole.width);
  EXPECT_EQ(same.glyphs.back().x, whole.glyphs.back().x);
}

TEST(BreakLines, AllShapes_AreKeptAndOnlyMoved) {
  for (const std::string &source : lines) {
    const Layout whole = laidOut(source);
    for (double em = 2; em < whole.width; em += 1.3) {
      const Layout broken = breakLines(whole, width(em));
      ASSERT_EQ(broken.glyphs.size(), whole.glyphs.size());
      EXPECT_EQ(broken.rules.size(), whole.rules.size());
      EXPECT_GT(broken.lines.size(), 1U);
      for (std::size_t i = 0; i < whole.glyphs.size(); ++i) {
        EXPECT_EQ(broken.glyphs[i].glyph, whole.glyphs[i].glyph);
        const Line &line = broken.lines[lineAt(broken, inkOf(broken.glyphs[i]).y)];
        EXPECT_NEAR(broken.glyphs[i].y - line.baseline, whole.glyphs[i].y, rounding) << source;
      }
    }
  }
}

TEST(BreakLines, ALineTooWide_HadNoPlaceToBreak) {
  for (const std::string &source : lines) {
    const Layout whole = laidOut(source);
    double widest = 0; // what cannot be broken
    for (std::size_t i = 0, begin = 0; i < whole.pieces.size(); ++i) {
      if (whole.pieces[i].before != Break::Never)
        begin = i;
      widest = std::max(widest, whole.pieces[i].right - whole.pieces[begin].x);
    }
    LineRules rules = width(widest + 2);
    EXPECT_LE(breakLines(whole, rules).width, rules.width + rounding) << source;
  }
}

TEST(BreakLines, Lines_DoNotTouchEachOther) {
  for (const std::string &source : lines) {
    const Layout broken = breakLines(laidOut(source), width(8));
    for (std::size_t i = 1; i < broken.lines.size(); ++i)
      EXPECT_NEAR(broken.lines[i].baseline - broken.lines[i].ascent -
                      (broken.lines[i - 1].baseline + broken.lines[i - 1].depth),
                  LineRules().gap, rounding);
    EXPECT_NEAR(broken.depth, broken.lines.back().baseline + broken.lines.back().depth, rounding);
    EXPECT_NEAR(broken.ascent, broken.lines.front().ascent, rounding);
  }
}

TEST(BreakLines, ARelation_IsPreferredToASignBehindIt) {
  const Layout broken = breakLines(laidOut("x = a+b+c = d+e+f"), width(10.5));
  ASSERT_EQ(broken.lines.size(), 2U);
  EXPECT_NEAR(glyphsOf(broken, '=')[1].x, broken.lines[1].left, rounding);
}

TEST(BreakLines, BehindASideOnSeveralLines_TheNextRelationBeginsALine) {
  const Layout broken = breakLines(laidOut("x = a+b+c+d+e+f+g = h"), width(10.5));
  ASSERT_EQ(broken.lines.size(), 3U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'g').y), 1U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'h').y), 2U);
  EXPECT_NEAR(glyphsOf(broken, '=')[1].x, broken.lines[2].left, rounding);
}

TEST(BreakLines, AFarRelation_IsNotWaitedFor) {
  const Layout broken = breakLines(laidOut("x = a+b+c+d+e+f+g+h+i+j+k"), width(12));
  ASSERT_GE(broken.lines.size(), 2U);
  EXPECT_EQ(lineAt(broken, glyphsOf(broken, '=')[0].y), 0U);
  EXPECT_GT(broken.lines[0].right, 8);
}

TEST(BreakLines, InsideParentheses_OnlyWithoutAnotherWay) {
  const Layout broken = breakLines(laidOut("(a+b+c+d)^2\\cdot(e+f+g+h)"), width(10));
  ASSERT_EQ(broken.lines.size(), 2U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'd').y), 0U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'e').y), 1U);
}

TEST(BreakLines, InsideParentheses_ALineEndsBehindACommaRatherThanBeforeASign) {
  const Layout broken = breakLines(laidOut("(a-b-c,d-e-f,g-h-i)"), width(9));
  ASSERT_EQ(broken.lines.size(), 3U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'c').y), 0U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'd').y), 1U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'f').y), 1U);
  EXPECT_EQ(lineAt(broken, letterIn(broken, 'g').y), 2U);
}

TEST(BreakLines, APlusThatLeavesALineHalfEmpty_IsBetterThanATimesThatFillsIt) {
  for (const char *latex : {"abcd+efg\\cdot hijk", "(abcd+efg\\cdot hijk)"}) {
    LineRules rules = width(6);
    rules.indent = 0;
    const Layout broken = breakLines(laidOut(latex), rules);
    ASSERT_EQ(broken.lines.size(), 2U) << latex;
    EXPECT_EQ(lineAt(broken, letterIn(broken, 'd').y), 0U) << latex;
    EXPECT_EQ(lineAt(broken, letterIn(broken, 'e').y), 1U) << latex;
  }
}

TEST(BreakLines, BetweenStatements_IsBetterThanBeforeARelation) {
  const Layout broken = breakLines(laidOut("s=1,\\quad t=2"), width(5));
  ASSERT_EQ(broken.lines.size(), 2U);
  EXPECT_NEAR(letterIn(broken, 't').x, 0, rounding);
}

TEST(BreakLines, FurtherRelations_StandBelowTheFirst) {
  const Layout broken = breakLines(laidOut("x=a+b+c+d+e=f+g+h+i+j=k"), width(11));
  const auto relations = glyphsOf(broken, '=');
  ASSERT_EQ(relations.size(), 3U);
  EXPECT_NEAR(relations[1].x, relations[0].x, rounding);
  LineRules plain = width(11);
  plain.belowRelation = false;
  const Layout indented = breakLines(laidOut("x=a+b+c+d+e=f+g+h+i+j=k"), plain);
  EXPECT_NEAR(glyphsOf(indented, '=')[1].x, plain.indent, rounding);
}

TEST(BreakLines, ATagAcrossLines_HasABoxOnEach) {
  const Layout whole = laidOut(lines.back());
  const Layout broken = breakLines(whole, width(9));
  ASSERT_GE(broken.lines.size(), 2U);
  for (const PlacedGlyph &glyph : broken.glyphs)
    for (int tag = glyph.ink.tag; tag != noTag; tag = broken.tags[static_cast<std::size_t>(tag)].parent) {
      const bool isCovered =
          std::any_of(broken.tagBoxes.begin(), broken.tagBoxes.end(), [&](const TagBox &tagBox) {
            const Rectangle ink = inkOf(glyph);
            return tagBox.tag == tag && tagBox.box.x <= ink.x + 0.06 &&
                   tagBox.box.right() >= ink.right() - 0.06 && tagBox.box.y <= ink.y + rounding &&
                   tagBox.box.bottom() >= ink.bottom() - rounding;
          });
      EXPECT_TRUE(isCovered) << "tag " << tag;
    }
  const auto boxesOfOuter = std::count_if(broken.tagBoxes.begin(), broken.tagBoxes.end(),
                                          [](const TagBox &tagBox) { return tagBox.tag == 0; });
  EXPECT_GT(boxesOfOuter, 1);
  EXPECT_LE(static_cast<std::size_t>(boxesOfOuter), broken.lines.size());
}

TEST(BreakLines, ATagWithinALine_KeepsItsSize) {
  const Layout whole = laidOut(lines.back());
  const Layout broken = breakLines(whole, width(9));
  const auto sizeOf = [](const Layout &layout, const std::string &name) {
    for (const TagBox &tagBox : layout.tagBoxes)
      if (layout.tags[static_cast<std::size_t>(tagBox.tag)].id == TagId(name))
        return std::pair(tagBox.box.width, tagBox.box.height);
    return std::pair(0.0, 0.0);
  };
  EXPECT_NEAR(sizeOf(broken, "q").first, sizeOf(whole, "q").first, rounding);
  EXPECT_NEAR(sizeOf(broken, "b").second, sizeOf(whole, "b").second, rounding);
}

TEST(BreakLines, WithoutAnyPlaceToBreak_TheLineStaysWhole) {
  const Layout broken = breakLines(laidOut("\\frac{a+b+c+d+e}{f}"), width(1));
  EXPECT_EQ(broken.lines.size(), 1U);
  EXPECT_EQ(breakLines(laidOut("\\left(a+b\\right)"), width(1)).lines.size(), 1U);
}

TEST(BreakLines, WidthsThatAreNone_LeaveTheLineWhole) {
  EXPECT_EQ(breakLines(laidOut("a=b"), width(0)).lines.size(), 1U);
  EXPECT_EQ(breakLines(laidOut("a=b"), width(-1)).lines.size(), 1U);
  EXPECT_EQ(breakLines(laidOut("a=b"), width(std::nan(""))).lines.size(), 1U);
  EXPECT_EQ(breakLines(laidOut(""), width(1)).lines.size(), 1U);
}

} // namespace
} // namespace halfspace::math
