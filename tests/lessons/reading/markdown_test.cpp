#include "lessons/reading/markdown.h"

#include <gtest/gtest.h>

#include <array>

namespace halfspace {
namespace {

using Kind = MarkdownBlock::Kind;

Markdown read(std::string_view text) {
  auto markdown = readMarkdown(text);
  EXPECT_TRUE(markdown) << text;
  return markdown ? std::move(*markdown) : Markdown{};
}

std::vector<std::string> formulasIn(std::string_view text) {
  std::vector<std::string> all;
  for (const MarkdownFormula &formula : read(text).formulas)
    all.push_back((formula.large ? "large " : "") + writtenIn(formula) +
                  (formula.punctuation.empty() ? "" : " then " + formula.punctuation));
  return all;
}

std::string spelled(const MarkdownSpan &span) {
  const auto within = [&](bool on, std::string_view mark, const std::string &text) {
    return on ? std::string(mark) + text + std::string(mark) : text;
  };
  std::string text = span.kind == MarkdownSpan::Kind::LineBreak ? "/"
                     : span.kind == MarkdownSpan::Kind::Formula ? "$" + std::to_string(span.formula) + "$"
                     : span.kind == MarkdownSpan::Kind::Picture ? "!" + span.text + "<" + span.picture + ">"
                                                                : span.text;
  text = span.face.link.empty() ? text : "[" + text + "](" + span.face.link + ")";
  text = within(span.face.code, "`", text);
  text = within(span.face.struck, "~", text);
  text = within(span.face.emphasized, "*", text);
  return within(span.face.strong, "**", text);
}

/// A block on one line: `List-(Item(Paragraph(a)) Item(Paragraph(b)))`.
std::string spelled(const MarkdownBlock &block) {
  constexpr std::array names{"Paragraph", "Heading", "Code",  "Rule", "Quote",
                             "List",      "Item",    "Table", "Row",  "Cell"};
  std::string text = names.at(static_cast<std::size_t>(block.kind));
  text += block.level > 0 ? std::to_string(block.level) : "";
  text += block.mark != 0 ? std::string(1, block.mark) : "";
  text += block.number ? std::to_string(*block.number) : "";
  text += !block.ticked ? "" : *block.ticked ? "[x]" : "[ ]";
  text += block.heading ? "^" : "";
  text += block.side == MarkdownBlock::Side::Middle  ? "="
          : block.side == MarkdownBlock::Side::Right ? ">"
                                                     : "";
  std::string inside;
  for (const MarkdownSpan &span : block.spans)
    inside += (inside.empty() ? "" : "|") + spelled(span);
  for (const MarkdownBlock &child : block.children)
    inside += (inside.empty() ? "" : " ") + spelled(child);
  return inside.empty() ? text : text + "(" + inside + ")";
}

std::string blocksIn(std::string_view text) {
  std::string all;
  for (const MarkdownBlock &block : read(text).blocks)
    all += (all.empty() ? "" : " ") + spelled(block);
  return all;
}

using Formulas = std::vector<std::string>;

TEST(Markdown, WithFormulas_KeepsTheirLettersFromBeingMarkup) {
  EXPECT_EQ(formulasIn("Let $P_0$ and $Q_0$ be *points*."), (Formulas{"P_0", "Q_0"}));
  EXPECT_EQ(blocksIn("Let $P_0$ and $Q_0$ be *points*."), "Paragraph(Let |$0$| and |$1$| be |*points*|.)");
}

TEST(Markdown, WithAFormulaAloneInItsParagraph_MakesItLarge) {
  EXPECT_EQ(formulasIn("Words\n\n$\\frac{1}{2}$\n\nmore"), Formulas{"large \\frac{1}{2}"});
  EXPECT_EQ(formulasIn(" $a$ "), Formulas{"large a"});
  EXPECT_EQ(formulasIn("Words\n$a$"), Formulas{"a"});
  EXPECT_EQ(formulasIn("- $a$"), Formulas{"a"});
  EXPECT_EQ(formulasIn("so $$\\frac{1}{2}$$, it is"), Formulas{"large \\frac{1}{2}"});
  EXPECT_EQ(formulasIn("$$\na\n$$"), Formulas{"large a"});
}

TEST(Markdown, WithWhatBelongsToAFormula_DoesNotLetALineTearItOff) {
  EXPECT_EQ(formulasIn("now $t$ = $3$, or $u$ $\\approx 2$; not $v$ $w$"),
            (Formulas{"t = 3 then ,", "u  \\approx 2 then ;", "v", "w"}));
  EXPECT_EQ(blocksIn("now $t$ = $3$, so"), "Paragraph(now |$0$| so)");
  EXPECT_EQ(formulasIn("a $t$ = $u$ = $v$. $w$ = $$x$$"), (Formulas{"t = u", "v then .", "w", "large x"}));
  EXPECT_EQ(formulasIn("a $t$ = $3 and"), Formulas{"t"});
}

TEST(Markdown, WithLiveValues_NamesThemWhereFormulasWouldStand) {
  EXPECT_EQ(formulasIn("Now *{f}* and {distance.f}, so $t$ = {t}, {a} = {b}. {c} < $x$"),
            (Formulas{"{f}", "{distance.f} then ,", "t = {t} then ,", "{a} = {b} then .", "{c} < x"}));
  EXPECT_EQ(blocksIn("Now *{f}* [{t}](https://a.b)"), "Paragraph(Now |*$0$*| |[$1$](https://a.b))");
  EXPECT_EQ(blocksIn("| a |\n|---|\n| {f} |"), "Table(Row^(Cell(a)) Row(Cell($0$)))");
  EXPECT_EQ(formulasIn("Words\n\n{f}\n\nmore"), Formulas{"large {f}"});
  EXPECT_EQ(formulasIn("{a} {b}, $Q$ {Q}"), (Formulas{"{a}", "{b} then ,", "Q  {Q}"})) << "Q may be rounded";
}

TEST(Markdown, WithBracesThatAreNoLiveValue_LeavesThem) {
  EXPECT_EQ(formulasIn("{1} {} {a b} { \\{f} `{f}` [a](https://b.c/{f}) ![a]({f}.png)\n\n~~~\n{f}\n~~~"),
            Formulas());
  EXPECT_EQ(formulasIn("$\\frac{f}{2}$"), Formulas{"large \\frac{f}{2}"});
  EXPECT_EQ(formulasIn("5$ one\n\nand {f} 6$"), Formulas{"{f}"});
}

TEST(Markdown, WithDollarsThatAreNoFormula_LeavesThem) {
  for (const auto &[text, blocks] : std::vector<std::pair<const char *, const char *>>{
           {"It costs 5\\$ or 6\\$.", "Paragraph(It costs 5$ or 6$.)"},
           {"Write `$x$` here.", "Paragraph(Write |`$x$`| here.)"},
           {"Write ``$x$ ` $y$`` here.", "Paragraph(Write |`$x$ ` $y$`| here.)"},
           {"It costs 5$ only.", "Paragraph(It costs 5$ only.)"},
           {"5$ one\n\nand two 6$", "Paragraph(5$ one) Paragraph(and two 6$)"},
           {"a $$ b", "Paragraph(a $$ b)"},
           {"```\n$x$\n```", "Code($x$)"}}) {
    EXPECT_EQ(formulasIn(text), Formulas()) << text;
    EXPECT_EQ(blocksIn(text), blocks);
  }
  EXPECT_EQ(formulasIn("` $x$ is behind a stray sign"), Formulas{"x"});
}

TEST(Markdown, WithASpaceBeforeTheClosingDollar_TakesItForNone) {
  EXPECT_EQ(formulasIn("$a $ b"), Formulas());
  EXPECT_EQ(formulasIn("$a\u00A0$ b"), Formulas());
  EXPECT_EQ(formulasIn("$ a$ b"), Formulas{"a"});
}

TEST(Markdown, WithFormulas_KeepsThemAndTheirPlacesAsTheyWereWritten) {
  const auto formulas = read("nöw $ t$ = $\\frac{1}$, $$b$$").formulas;
  ASSERT_EQ(formulas.size(), 2U);
  ASSERT_EQ(formulas[0].sides.size(), 2U);
  EXPECT_EQ(formulas[0].sides[0].place, 7U);
  EXPECT_EQ(formulas[0].sides[0].text, "t");
  EXPECT_EQ(formulas[0].sides[1].place, 13U);
  EXPECT_EQ(formulas[0].sides[1].text, "\\frac{1}");
  EXPECT_EQ(formulas[1].sides.at(0).text, "b");
}

TEST(Markdown, WithAFormulaThatIsNotShown_StillTellsIt) {
  EXPECT_EQ(formulasIn("[a $x$]: b\n\nwords $y$"), (Formulas{"x", "y"}));
  EXPECT_EQ(blocksIn("[a $x$]: b\n\nwords $y$"), "Paragraph(words |$1$)");
}

TEST(Markdown, WithPrivateCharacters_DoesNotTakeThemForFormulas) {
  EXPECT_EQ(blocksIn("a \U000F0000 b $x$"), "Paragraph(a \U00100000 b |$0$)");
  EXPECT_EQ(blocksIn("a &#xF0000; b $x$"), "Paragraph(a \U000F0000 b |$0$)");
}

TEST(Markdown, WithFacesInEachOther_TellsThemOfEachPiece) {
  EXPECT_EQ(blocksIn("a *b **c `d`*** ~~e~~ **$x$**"),
            "Paragraph(a |*b *|***c ***|***`d`***| |~e~| |**$0$**)");
}

TEST(Markdown, WithLists_NestsItemsWithTheirNumbers) {
  EXPECT_EQ(blocksIn("- a\n  - b\n- c"),
            "List-(Item(Paragraph(a) List-(Item(Paragraph(b)))) Item(Paragraph(c)))");
  EXPECT_EQ(blocksIn("3) a\n4) b"), "List)(Item3(Paragraph(a)) Item4(Paragraph(b)))");
  EXPECT_EQ(blocksIn("- a\n\n  b\n\n- c"), "List-(Item(Paragraph(a) Paragraph(b)) Item(Paragraph(c)))");
  EXPECT_EQ(blocksIn("* [ ] a\n* [x] b\n*"), "List*(Item[ ](Paragraph(a)) Item[x](Paragraph(b)) Item)");
  EXPECT_EQ(blocksIn("- a\n  > b"), "List-(Item(Paragraph(a) Quote(Paragraph(b))))");
}

TEST(Markdown, WithHeadingsCodeQuotesAndRules_MakesABlockOfEach) {
  EXPECT_EQ(blocksIn("# a\n\nb\n===\n\n### c"), "Heading1(a) Heading1(b) Heading3(c)");
  EXPECT_EQ(blocksIn("```cpp\na *b*\n\n  c\n```\n    d\n"), "Code(a *b*|/|/|  c) Code(d)");
  EXPECT_EQ(blocksIn("```\n```"), "Code");
  EXPECT_EQ(blocksIn("> a\n>\n> > b"), "Quote(Paragraph(a) Quote(Paragraph(b)))");
  EXPECT_EQ(blocksIn("a\n\n---\nb"), "Paragraph(a) Rule Paragraph(b)");
}

TEST(Markdown, WithLines_JoinsThemUnlessABreakIsAskedFor) {
  EXPECT_EQ(blocksIn("a\nb  \nc\\\nd"), "Paragraph(a b|/|c|/|d)");
}

TEST(Markdown, WithLinksToTheWeb_TellsWhereTheyLead) {
  EXPECT_EQ(blocksIn("[a *b*](https://x.y \"z\") <https://c.d> e@f.g"),
            "Paragraph([a ](https://x.y)|*[b](https://x.y)*| |[https://c.d](https://c.d)| "
            "|[e@f.g](mailto:e@f.g))");
  EXPECT_EQ(blocksIn("[a](https://x.y/?b&amp;c)"), "Paragraph([a](https://x.y/?b&c))");
}

TEST(Markdown, WithLinksToAnythingElse_HasTheirTextAlone) {
  for (const char *address : {"javascript:alert(1)", "file:///etc/passwd", "data:text/html,b", "/etc/passwd",
                              "b.md", "ftp://b", "vbscript:b", "#b", "\\\\b\\c", "https:b", "https://b/$c$"})
    EXPECT_EQ(blocksIn("[a](" + std::string(address) + ")"), "Paragraph(a)") << address;
}

TEST(Markdown, WithPictures_TellsWhatTheyAreCalledAndTheirDescriptions) {
  EXPECT_EQ(blocksIn("a ![b **c**\nd](e/f.png \"g\")"), "Paragraph(a |!b c d<e/f.png>)");
  EXPECT_EQ(blocksIn("[![a](b.png)](https://c.d)"), "Paragraph([!a<b.png>](https://c.d))");
}

TEST(Markdown, WithTables_HasTheirRowsAndCells) {
  EXPECT_EQ(blocksIn("| a | b |\n|:-:|--:|\n| $c \\lvert d$ | **e** f |\n| g |"),
            "Table(Row^(Cell=(a) Cell>(b)) Row(Cell=($0$) Cell>(**e**| f)) Row(Cell=(g) Cell>))");
  EXPECT_EQ(blocksIn("- | a |\n  |---|\n"), "List-(Item(Table(Row^(Cell(a)))))");
}

TEST(Markdown, WithHtml_ShowsItAsText) {
  EXPECT_EQ(blocksIn("<b>a</b>\n\n<div>\nb"), "Paragraph(<b>a</b>) Paragraph(<div> b)");
  EXPECT_EQ(blocksIn("<script>a</script>"), "Paragraph(<script>a</script>)");
}

TEST(Markdown, WithEntities_HasTheirCharacters) {
  EXPECT_EQ(blocksIn("a &lt; b &#8722; &#x2212; **&amp;** &what;"), "Paragraph(a < b − − |**&**| &what;)");
  EXPECT_EQ(blocksIn("&#0;&#10;&#xD800;&#x110000;&#9999999;"), "Paragraph(\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD)");
}

TEST(Markdown, OfNothing_HasNoBlocks) {
  EXPECT_EQ(blocksIn(""), "");
  EXPECT_EQ(blocksIn("\n \n"), "");
}

TEST(Markdown, TooLongOrNestedTooDeeply_IsRefused) {
  EXPECT_TRUE(readMarkdown(std::string(maxMarkdownBytes, 'a')));
  const auto tooLong = readMarkdown(std::string(maxMarkdownBytes + 1, 'a'));
  ASSERT_FALSE(tooLong);
  EXPECT_NE(tooLong.problem().sentence.find("too long"), std::string::npos);
  EXPECT_TRUE(readMarkdown(std::string(maxMarkdownDepth, '>') + "a"));
  EXPECT_FALSE(readMarkdown(std::string(maxMarkdownDepth + 1, '>') + "a"));
  for (const char *nested : {">", "- ", "1. "}) {
    std::string text;
    while (text.size() < maxMarkdownBytes - 3)
      text += nested;
    const auto tooDeep = readMarkdown(text + "a");
    ASSERT_FALSE(tooDeep) << nested;
    EXPECT_NE(tooDeep.problem().sentence.find("too deeply"), std::string::npos);
  }
}

TEST(Markdown, WithTooManyCells_IsRefused) {
  const auto table = [](std::size_t columns, std::size_t rows) {
    std::string text = "|";
    for (std::size_t i = 0; i < columns; ++i)
      text += "a|";
    text += "\n|";
    for (std::size_t i = 0; i < columns; ++i)
      text += "---|";
    for (std::size_t i = 0; i < rows; ++i)
      text += "\n|b|";
    return text;
  };
  EXPECT_TRUE(readMarkdown(table(10, maxMarkdownCells / 10 - 1)));
  // Newer versions of the parser know no table with more than 128 columns.
  for (const auto &tooLarge : {table(10, maxMarkdownCells / 10), table(100, 9000)}) {
    const auto refused = readMarkdown(tooLarge);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.problem().sentence.find("tables"), std::string::npos);
  }
}

TEST(Markdown, WithTooManyPictures_IsRefused) {
  std::string pictures;
  for (std::size_t i = 0; i < maxMarkdownPictures; ++i)
    pictures += "![a](b.png) ";
  EXPECT_TRUE(readMarkdown(pictures));
  const auto refused = readMarkdown(pictures + "![a](b.png)");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.problem().sentence.find("pictures"), std::string::npos);
}

TEST(Markdown, DollarsInFencesOfTildes_AreNoFormulas) {
  EXPECT_TRUE(formulasIn("~~~\n$x$\n~~~").empty());
  EXPECT_TRUE(formulasIn("words\n\n~~~~\n$x$\n~~~~\n").empty());
  EXPECT_EQ(formulasIn("~~a~~ $x$"), std::vector<std::string>{"x"}) << "struck words are no fence";
}

} // namespace
} // namespace halfspace
