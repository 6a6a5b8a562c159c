#include "widgets/handout/set_blocks.h"

#include "lessons/text.h"
#include "widgets/handout/set_figure.h"
#include "widgets/handout/set_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

// Sizes of type, as parts of that of running text.
constexpr double smallType = 0.88;
constexpr double codeType = 0.9;
constexpr std::array headingTypes{1.75, 1.22, 1.0}; // by level; further levels are as the last

// Space above and below, in parts of the leading.
constexpr double paragraphGap = 0.5;
constexpr double itemGap = 0.22;
constexpr std::array headingGapsAbove{0.0, 1.5, 0.9};
constexpr double headingGapBelow = 0.45;
constexpr double formulaGap = 0.45;
constexpr double figureGap = 0.9;
constexpr double ruleGap = 0.8;
constexpr double writtenLine = 1.7; ///< of handwriting

// Indents, in ems.
constexpr double listIndent = 1.5;
constexpr double quoteIndent = 1.5;
constexpr double noteIndent = 1.5;
constexpr double formulaIndent = 1.8;
/// Nothing is set in from the sides that would be narrower, in ems.
constexpr double narrowest = 12;

/// A formula or a figure is at most this part of a column high.
constexpr double mostHeight = 0.9;
/// How far the line for what is to be filled in is below its room, and how thick such lines are, in ems.
constexpr double fillInDrop = 0.12;
constexpr double thinRule = 0.04;
constexpr Color ruleColor{130, 130, 130};

/// What is written behind each other and stands in one column.
class BlockSetter {
public:
  BlockSetter(double width, const HandoutLook &look, const HandoutFonts &fonts, ReadingOrder &order,
              std::size_t document)
      : m_look(look), m_fonts(fonts), m_order(order), m_frame{0, width, look.typeSize, document} {}

  std::vector<Chunk> set(const HandoutBlocks &blocks) {
    setAll(blocks);
    return std::move(m_chunks);
  }

private:
  /// Where blocks are set.
  struct Frame {
    double left;
    double width;
    double size; ///< of the type
    std::size_t element;
  };
  /// The mark of a list's item, while nothing of the item is set.
  struct Mark {
    std::string text;
    double left;
    std::size_t element;
    std::size_t order;
  };

  void setAll(const HandoutBlocks &blocks) {
    for (const HandoutBlock &block : blocks) {
      std::visit([this](const auto &each) { set(each); }, block.content);
      if (block.keepsWithNext && !m_chunks.empty())
        m_chunks.back().keepsWithNext = true;
    }
  }

  /// What is inside of something else, set in from both sides.
  void setWithin(const HandoutBlocks &blocks, const char *role, glm::dvec2 indents, double size) {
    const Frame around = m_frame;
    glm::dvec2 ems = indents * around.size;
    if (around.width - ems.x - ems.y < narrowest * around.size)
      ems = {}; // what is nested so deep that no words would find room stands below the other
    m_frame = {around.left + ems.x, around.width - ems.x - ems.y, size, m_order.add(role, around.element)};
    setAll(blocks);
    m_frame = around;
  }

  [[nodiscard]] double leading() const { return m_frame.size * HandoutLook::leadingEms; }

  [[nodiscard]] ParagraphPlan plan(std::size_t element, double size) const {
    return {m_frame.width, size, size * HandoutLook::leadingEms,
            m_look.isJustified ? LineEnds::Justified : LineEnds::Ragged, element};
  }

  /// Space between what stands above and what comes next, of which the larger counts.
  void askGap(double gap) { m_gap = std::max(m_gap, gap); }

  void push(Chunk chunk) {
    chunk.gapAbove = m_chunks.empty() ? 0 : m_gap;
    m_gap = 0;
    m_chunks.push_back(std::move(chunk));
  }

  Chunk chunkOf(SetLine line) {
    Chunk chunk;
    chunk.height = line.ascent + line.depth;
    addMarks(line.ascent, chunk);
    for (SetThing &thing : line.things)
      chunk.things.push_back(moved(std::move(thing), {m_frame.left, line.ascent}));
    return chunk;
  }

  /// Neither the first nor the last line of a paragraph stands alone in a column.
  void pushLines(std::vector<SetLine> lines) {
    const std::size_t count = lines.size();
    for (std::size_t i = 0; i < count; ++i) {
      Chunk chunk = chunkOf(std::move(lines[i]));
      chunk.keepsWithNext = i + 1 < count && (i == 0 || i + 2 == count);
      push(std::move(chunk));
    }
  }

  /// Beside the first line of an item. It is that of several lists where an item begins with another list.
  void addMarks(double ascent, Chunk &chunk) {
    for (const Mark &mark : std::exchange(m_marks, {}))
      for (const SetWord::Part &part : setWord(mark.text, {}, m_frame.size, m_fonts).parts)
        chunk.things.push_back(moved({part.text, mark.element, mark.order}, {mark.left, ascent}));
  }

  void set(const HeadingBlock &heading) {
    const auto level = static_cast<std::size_t>(std::max(heading.level, 1)) - 1;
    const double size = m_look.typeSize * headingTypes.at(std::min(level, headingTypes.size() - 1));
    askGap(headingGapsAbove.at(std::min(level, headingGapsAbove.size() - 1)) * leading());
    ParagraphPlan lines = plan(m_order.add("H" + std::to_string(level + 1), m_frame.element), size);
    lines.ends = LineEnds::Ragged;
    InlineText text = heading.title;
    if (!heading.number.empty())
      text.insert(text.begin(), StyledWords{heading.number + "\xE2\x80\x82", {true}}); // an en space
    std::vector<SetLine> set = setParagraph(text, lines, m_fonts, m_order);
    const std::size_t first = m_chunks.size();
    pushLines(std::move(set));
    for (std::size_t i = first; i < m_chunks.size(); ++i)
      m_chunks[i].keepsWithNext = true;
    if (level == 1 && first < m_chunks.size())
      m_chunks[first].bookmark = (heading.number.empty() ? "" : heading.number + " ") + heading.plain;
    askGap(headingGapBelow * leading());
  }

  void set(const ParagraphBlock &paragraph) {
    const double size = paragraph.size == TextSize::Small ? smallType * m_frame.size : m_frame.size;
    askGap(m_isTight ? itemGap * leading() : paragraphGap * leading());
    pushLines(setParagraph(paragraph.text, plan(m_order.add("P", m_frame.element), size), m_fonts, m_order));
    askGap(m_isTight ? itemGap * leading() : paragraphGap * leading());
  }

  void set(const FormulaBlock &block) {
    const double indent = formulaIndent * m_frame.size;
    FormulaPart part = fittedFormula(block.formula, m_frame.size, m_frame.width - indent);
    const math::Layout &formula = *part.formula;
    part.size = std::min(part.size, mostHeight * m_look.textHeight() / (formula.ascent + formula.depth));
    Chunk chunk;
    chunk.height = (formula.ascent + formula.depth) * part.size;
    part.start = {m_frame.left + indent, formula.ascent * part.size};
    addMarks(part.start.y, chunk);
    addFillIns(part, chunk);
    const std::size_t element = m_order.add("Formula", m_frame.element, formulaEntries(part.plain));
    std::string plain = part.plain;
    chunk.things.push_back({std::move(part), element, m_order.next(), std::move(plain)});
    askGap(formulaGap * leading());
    push(std::move(chunk));
    askGap(formulaGap * leading());
  }

  /// Lines to write on, where something is left out.
  static void addFillIns(const FormulaPart &part, Chunk &chunk) {
    for (const math::TagBox &box : part.formula->tagBoxes) {
      if (!std::holds_alternative<math::LeftOut>(part.formula->tags[static_cast<std::size_t>(box.tag)].id))
        continue;
      const glm::dvec2 corner = part.start + glm::dvec2(box.box.x, box.box.bottom()) * part.size;
      chunk.things.push_back({RulePart{{corner.x, corner.y - fillInDrop * part.size,
                                        box.box.width * part.size, thinRule * part.size},
                                       ruleColor},
                              {},
                              0});
    }
  }

  void set(const CodeBlock &code) {
    const double size = codeType * m_frame.size;
    const std::size_t element = m_order.add("Code", m_frame.element);
    const double letter = spaceWidth({.code = true}, size, m_fonts);
    const auto most = static_cast<std::size_t>(std::max(m_frame.width / letter, 1.0));
    askGap(paragraphGap * leading());
    for (const std::string &line : code.lines) {
      std::string_view rest = line;
      do
        pushCode(takeLetters(rest, most), size, element);
      while (!rest.empty());
    }
    askGap(paragraphGap * leading());
  }

  /// Takes so many characters from the beginning of a text.
  static std::string_view takeLetters(std::string_view &text, std::size_t count) {
    std::size_t length = 0;
    while (count-- > 0 && length < text.size())
      length += lengthOfFirst(text.substr(length));
    const std::string_view taken = text.substr(0, length);
    text.remove_prefix(taken.size());
    return taken;
  }

  void pushCode(std::string_view text, double size, std::size_t element) {
    SetLine line;
    line.ascent = size;
    line.depth = (HandoutLook::leadingEms - 1) * size;
    for (SetWord::Part &part : setWord(text, {.code = true}, size, m_fonts).parts)
      line.things.push_back({std::move(part.text), element, m_order.next(), std::move(part.copied)});
    push(chunkOf(std::move(line)));
  }

  void set(const RuleBlock &) {
    askGap(ruleGap * leading());
    Chunk chunk;
    chunk.height = thinRule * m_frame.size;
    chunk.things.push_back({RulePart{{m_frame.left, 0, m_frame.width, chunk.height}, ruleColor}, {}, 0});
    push(std::move(chunk));
    askGap(ruleGap * leading());
  }

  void set(const QuoteBlock &quote) {
    setWithin(quote.blocks, "BlockQuote", {quoteIndent, quoteIndent}, m_frame.size);
  }

  void set(const ListBlock &list) {
    const Frame around = m_frame;
    askGap(paragraphGap * leading());
    m_frame.element = m_order.add("L", m_frame.element);
    for (const ListItem &item : list.items) {
      const std::size_t element = m_order.add("LI", m_frame.element);
      const std::size_t label = m_order.add("Lbl", element);
      m_marks.push_back({item.mark, m_frame.left, label, m_order.next()});
      const bool isTight = std::exchange(m_isTight, true);
      const Frame items = m_frame;
      m_frame.element = element;
      setWithin(item.blocks, "LBody", {listIndent, 0}, m_frame.size);
      m_frame = items;
      m_isTight = isTight;
    }
    m_marks.clear();
    m_frame = around;
    askGap(m_isTight ? itemGap * leading() : paragraphGap * leading());
  }

  void set(const TableBlock &table) {
    askGap(paragraphGap * leading());
    ParagraphPlan rows = plan(m_frame.element, m_frame.size);
    for (Chunk &chunk : setTable(table, rows, m_fonts, m_order)) {
      for (SetThing &thing : chunk.things)
        thing = moved(std::move(thing), {m_frame.left, 0});
      push(std::move(chunk));
    }
    askGap(paragraphGap * leading());
  }

  void set(const FigureBlock &figure) {
    ParagraphPlan caption = plan(m_frame.element, smallType * m_frame.size);
    caption.ends = LineEnds::Ragged;
    Chunk chunk = setFigure(figure, caption, m_fonts, m_order);
    for (SetThing &thing : chunk.things)
      thing = moved(std::move(thing), {m_frame.left, 0});
    askGap(figureGap * leading());
    push(std::move(chunk));
    askGap(figureGap * leading());
  }

  void set(const NoteBlock &note) {
    HandoutBlocks blocks{{ParagraphBlock{note.title}, true}};
    blocks.insert(blocks.end(), note.blocks.begin(), note.blocks.end());
    setWithin(blocks, "Sect", {noteIndent, noteIndent}, smallType * m_look.typeSize);
  }

  void set(const RoomBlock &room) {
    Chunk chunk;
    chunk.height = room.lines * writtenLine * leading();
    for (int i = 1; i <= room.lines; ++i)
      chunk.things.push_back(
          {RulePart{{m_frame.left, i * writtenLine * leading(), m_frame.width, thinRule * m_frame.size},
                    ruleColor},
           {},
           0});
    push(std::move(chunk));
    askGap(paragraphGap * leading());
  }

  const HandoutLook &m_look;
  const HandoutFonts &m_fonts;
  ReadingOrder &m_order;
  Frame m_frame;
  std::vector<Chunk> m_chunks;
  double m_gap = 0;
  bool m_isTight = false; ///< inside of a list
  std::vector<Mark> m_marks;
};

} // namespace

std::vector<Chunk> setBlocks(const HandoutBlocks &blocks, double width, const HandoutLook &look,
                             const HandoutFonts &fonts, ReadingOrder &order, std::size_t document) {
  return BlockSetter(width, look, fonts, order, document).set(blocks);
}

} // namespace halfspace
