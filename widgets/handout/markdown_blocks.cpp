#include "widgets/handout/markdown_blocks.h"

#include "widgets/formula/formula_among_words.h"
#include "widgets/formula/set_formula.h"

#include <utility>

namespace halfspace {
namespace {

using Kind = MarkdownBlock::Kind;

/// Headings among the words of a step are below that of the step.
constexpr int levelOfStep = 2;

constexpr const char *bullet = "•";
constexpr const char *openBox = "□";
constexpr const char *tickedBox = "✓";

/// A formula in whose marked parts the colours of their marks are: the innermost of each.
InlineFormula inked(math::Layout layout, std::string plain, const FormulaSetting &setting) {
  std::vector<std::optional<math::Color>> inks;
  for (const math::Tag &tag : layout.tags) {
    const auto *mark = std::get_if<std::string>(&tag.id);
    const auto ink = mark ? setting.inkOf(*mark) : std::nullopt;
    if (ink)
      inks.emplace_back(math::Color{ink->red, ink->green, ink->blue});
    else
      inks.push_back(tag.parent == math::noTag ? std::nullopt : inks[static_cast<std::size_t>(tag.parent)]);
  }
  const auto give = [&](math::Ink &ink) {
    if (!ink.color && ink.tag != math::noTag)
      ink.color = inks[static_cast<std::size_t>(ink.tag)];
  };
  for (math::PlacedGlyph &glyph : layout.glyphs)
    give(glyph.ink);
  for (math::Rule &rule : layout.rules)
    give(rule.ink);
  return {std::make_shared<const math::Layout>(std::move(layout)), std::move(plain)};
}

class BlockMaker {
public:
  BlockMaker(const FilledMarkdown &markdown, const FormulaSetting &setting)
      : m_markdown(markdown), m_setting(setting) {}

  HandoutBlocks make(const std::vector<MarkdownBlock> &blocks) {
    HandoutBlocks made;
    for (const MarkdownBlock &block : blocks)
      add(block, made);
    return made;
  }

  InlineText text(const std::vector<MarkdownSpan> &spans, TextLook look = {}) {
    InlineText made;
    for (const MarkdownSpan &span : spans)
      add(span, look, made);
    return made;
  }

private:
  void add(const MarkdownBlock &block, HandoutBlocks &made) {
    switch (block.kind) {
    case Kind::Paragraph:
      return addParagraph(block, made);
    case Kind::Heading:
      made.push_back({HeadingBlock{block.level + levelOfStep, "", text(block.spans, {.strong = true}), ""}});
      return;
    case Kind::Code:
      made.push_back({CodeBlock{linesOf(block)}});
      return;
    case Kind::Rule:
      made.push_back({RuleBlock{}});
      return;
    case Kind::Quote:
      made.push_back({QuoteBlock{make(block.children)}});
      return;
    case Kind::List:
      return addList(block, made);
    case Kind::Table:
      return addTable(block, made);
    case Kind::Item: // lists and tables add them
    case Kind::Row:
    case Kind::Cell:
      return;
    }
  }

  /// A large formula alone in its paragraph has a row of its own.
  void addParagraph(const MarkdownBlock &block, HandoutBlocks &made) {
    const bool isFormula = block.spans.size() == 1 &&
                           block.spans.front().kind == MarkdownSpan::Kind::Formula &&
                           m_markdown.formulas[block.spans.front().formula].large;
    if (isFormula) {
      if (!made.empty())
        made.back().keepsWithNext = true; // what says that it comes
      made.push_back({FormulaBlock{formula(block.spans.front().formula)}});
    } else {
      made.push_back({ParagraphBlock{text(block.spans)}});
    }
  }

  void addList(const MarkdownBlock &list, HandoutBlocks &made) {
    ListBlock items;
    for (const MarkdownBlock &item : list.children)
      items.items.push_back({markOf(list, item), make(item.children)});
    if (!made.empty())
      made.back().keepsWithNext = true;
    made.push_back({std::move(items)});
  }

  static std::string markOf(const MarkdownBlock &list, const MarkdownBlock &item) {
    if (item.ticked)
      return *item.ticked ? tickedBox : openBox;
    return item.number ? std::to_string(*item.number) + list.mark : bullet;
  }

  void addTable(const MarkdownBlock &table, HandoutBlocks &made) {
    TableBlock block;
    for (const MarkdownBlock &row : table.children) {
      TableRow cells{row.heading, {}};
      for (const MarkdownBlock &cell : row.children)
        cells.cells.push_back({text(cell.spans, {.strong = row.heading}), sideOf(cell)});
      block.rows.push_back(std::move(cells));
    }
    made.push_back({std::move(block)});
  }

  static TableCell::Side sideOf(const MarkdownBlock &cell) {
    return cell.side == MarkdownBlock::Side::Right    ? TableCell::Side::Right
           : cell.side == MarkdownBlock::Side::Middle ? TableCell::Side::Middle
                                                      : TableCell::Side::Left;
  }

  static std::vector<std::string> linesOf(const MarkdownBlock &code) {
    std::vector<std::string> lines(1);
    for (const MarkdownSpan &span : code.spans)
      if (span.kind == MarkdownSpan::Kind::LineBreak)
        lines.emplace_back();
      else
        lines.back() += span.text;
    return lines;
  }

  void add(const MarkdownSpan &span, TextLook look, InlineText &made) {
    look.strong = look.strong || span.face.strong;
    look.emphasized = look.emphasized || span.face.emphasized;
    look.struck = look.struck || span.face.struck;
    look.code = look.code || span.face.code;
    switch (span.kind) {
    case MarkdownSpan::Kind::Text:
      made.emplace_back(StyledWords{span.text, look});
      return;
    case MarkdownSpan::Kind::Formula:
      made.emplace_back(formula(span.formula));
      return;
    case MarkdownSpan::Kind::LineBreak:
      made.emplace_back(LineEnd{});
      return;
    case MarkdownSpan::Kind::Picture:
      look.emphasized = true;
      made.emplace_back(StyledWords{"[" + span.text + "]", look});
      return;
    }
  }

  InlineFormula formula(std::size_t index) {
    const FilledFormula &filled = m_markdown.formulas[index];
    std::string plain = plainText(filled, m_setting.macros);
    if (const auto row = rowAmongWords(filled, m_setting.macros)) {
      auto set = math::setFormula(*row, m_setting.fonts);
      if (set.error.empty())
        return inked(std::move(set.layout), std::move(plain), m_setting);
    }
    auto source = math::setLatex(latexOf(filled) + filled.punctuation, m_setting.fonts, m_setting.macros);
    return inked(std::move(source.layout), std::move(plain), m_setting);
  }

  const FilledMarkdown &m_markdown;
  const FormulaSetting &m_setting;
};

} // namespace

InlineFormula inlineFormula(const math::Row &row, std::string plain, const FormulaSetting &setting) {
  return inked(math::setFormula(row, setting.fonts).layout, std::move(plain), setting);
}

HandoutBlocks handoutBlocks(const FilledMarkdown &markdown, const FormulaSetting &setting) {
  return BlockMaker(markdown, setting).make(markdown.blocks);
}

InlineText oneParagraph(const FilledMarkdown &markdown, const FormulaSetting &setting) {
  BlockMaker maker(markdown, setting);
  InlineText all;
  for (const MarkdownBlock &block : markdown.blocks) {
    if (!all.empty())
      all.emplace_back(StyledWords{" ", {}});
    InlineText text = maker.text(block.spans);
    all.insert(all.end(), std::make_move_iterator(text.begin()), std::make_move_iterator(text.end()));
  }
  return all;
}

} // namespace halfspace
