#include "widgets/handout/set_paragraph.h"

#include "lessons/figure/mark.h"
#include "lessons/text.h"
#include "widgets/formula/break_lines.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

/// How much of the leading is above the baseline.
constexpr double ascentPart = 0.72;
/// Between a high formula and the lines above and below it, in ems.
constexpr double formulaGap = 0.12;
/// Spaces of justified lines become at most so many times as wide: a line that needs more stays short.
constexpr double widestSpace = 2.4;
/// Where the stroke through struck words is, and how thick it is, in ems.
constexpr double strikeHeight = 0.25;
constexpr double strikeWidth = 0.05;

constexpr std::string_view noBreakSpace = "\xC2\xA0";

/// An item of a paragraph with what is seen of it.
struct Box {
  BreakItem item{};
  SetWord word{};
  std::optional<FormulaPart> formula{};
  TextLook look{};
  bool isRelation = false; ///< as = among words
};

bool isRelation(std::string_view word) {
  constexpr std::array<std::string_view, 7> relations{"=", "≈", "<", ">", "≤", "≥", "≠"};
  return std::find(relations.begin(), relations.end(), word) != relations.end();
}

/// Where the first piece of a word ends that a line may end behind: behind a hyphen or a dash between
/// letters.
std::size_t firstPiece(std::string_view word) {
  for (const std::string_view dash : {"-", "–", "—"}) {
    const auto place = word.find(dash, 1);
    if (place != std::string_view::npos && place + dash.size() < word.size())
      return place + dash.size();
  }
  return word.size();
}

/// Makes boxes of a paragraph's pieces.
class Boxes {
public:
  Boxes(const ParagraphPlan &plan, const HandoutFonts &fonts) : m_plan(plan), m_fonts(fonts) {}

  std::vector<Box> make(const InlineText &text) {
    for (const InlinePiece &piece : text)
      std::visit([this](const auto &each) { add(each); }, piece);
    keepRelations();
    return std::move(m_boxes);
  }

private:
  void add(const LineEnd &) {
    m_mustBegin = true;
    m_space = 0;
  }

  void add(const InlineFormula &formula) {
    Box box;
    box.formula = fittedFormula(formula, m_plan.size, m_plan.width);
    box.item.width = box.formula->formula->width * box.formula->size;
    const bool isBroken = box.formula->formula->lines.size() > 1;
    m_mustBegin = m_mustBegin || isBroken; // beside several lines nothing could be read in its order
    push(std::move(box));
    m_mustBegin = isBroken;
  }

  void add(const StyledWords &words) {
    std::string_view rest = words.text;
    while (!rest.empty()) {
      if (rest.starts_with(' ') || rest.starts_with(noBreakSpace)) {
        m_mayBegin = rest.starts_with(' ');
        m_space = spaceWidth(words.look, m_plan.size, m_fonts);
        rest.remove_prefix(rest.starts_with(' ') ? 1 : noBreakSpace.size());
        continue;
      }
      const std::string_view word = rest.substr(0, std::min(rest.find(' '), rest.find(noBreakSpace)));
      addWord(word, words);
      rest.remove_prefix(word.size());
    }
  }

  void addWord(std::string_view word, const StyledWords &words) {
    const TextLook look = words.look;
    while (!word.empty()) {
      const std::string_view piece = word.substr(0, firstPiece(word));
      word.remove_prefix(piece.size());
      Box box;
      box.look = look;
      box.isRelation = isRelation(piece);
      box.word = setWord(piece, look, m_plan.size, m_fonts, words.copied);
      box.item.width = box.word.width;
      if (box.item.width > m_plan.width)
        addLetters(piece, look);
      else
        push(std::move(box));
      m_mayBegin = true; // behind a hyphen, unless the word ends here
    }
    m_mayBegin = false;
  }

  /// A word wider than the column, as an address may be, letter by letter.
  void addLetters(std::string_view word, TextLook look) {
    while (!word.empty()) {
      const std::size_t length = lengthOfFirst(word);
      Box box;
      box.look = look;
      box.word = setWord(word.substr(0, length), look, m_plan.size, m_fonts);
      box.item.width = box.word.width;
      push(std::move(box));
      m_mayBegin = true;
      word.remove_prefix(length);
    }
  }

  void push(Box box) {
    box.item.space = m_space;
    box.item.mayBegin = m_mayBegin;
    box.item.mustBegin = std::exchange(m_mustBegin, false);
    m_boxes.push_back(std::move(box));
    m_space = 0;
    m_mayBegin = false;
  }

  /// No line begins or ends with a relation among words.
  void keepRelations() {
    for (std::size_t i = 1; i + 1 < m_boxes.size(); ++i)
      if (m_boxes[i].isRelation)
        m_boxes[i].item.mayBegin = m_boxes[i + 1].item.mayBegin = false;
  }

  const ParagraphPlan &m_plan;
  const HandoutFonts &m_fonts;
  std::vector<Box> m_boxes;
  double m_space = 0; ///< before the next box
  bool m_mayBegin = true;
  bool m_mustBegin = false;
};

/// Puts the boxes of one line in their places.
class LineMaker {
public:
  LineMaker(const ParagraphPlan &plan, const HandoutFonts &fonts, ReadingOrder &order)
      : m_plan(plan), m_fonts(fonts), m_order(order) {
    m_line.ascent = ascentPart * plan.leading;
    m_line.depth = plan.leading - m_line.ascent;
  }

  /// `stretch`: how many times as wide spaces are. `isLast`: nothing follows in the paragraph.
  SetLine make(const Box *begin, const Box *end, double stretch, bool isLast) {
    for (const Box *box = begin; box != end; ++box) {
      if (box != begin && box->item.space > 0)
        addSpace(box->item.space * stretch);
      box->formula ? addFormula(*box->formula) : addWord(*box);
    }
    m_line.width = m_x;
    if (!isLast) // words of two lines are not one
      addSpace(0);
    return std::move(m_line);
  }

private:
  /// A space is there for those who copy and read the text; it takes its room whatever its glyph's is.
  void addSpace(double width) {
    const auto *last = m_line.things.empty() ? nullptr : std::get_if<TextPart>(&m_line.things.back().content);
    const bool goesOn = last && m_line.things.back().element == m_plan.element &&
                        m_line.things.back().copied.empty() && last->face->glyph(U' ') != 0 &&
                        last->start.y == 0;
    const math::FontFace &face = goesOn ? *last->face : faceOf({}, m_fonts);
    addText({&face, goesOn ? last->size : m_plan.size, {{face.glyph(U' '), 0}}, {m_x, 0}});
    m_x += width;
  }

  void addWord(const Box &box) {
    for (SetWord::Part part : box.word.parts) {
      part.text.start.x += m_x;
      addText(std::move(part.text), std::move(part.copied));
    }
    if (box.look.struck) {
      const double em = m_plan.size;
      m_line.things.push_back(
          {RulePart{{m_x, -strikeHeight * em, box.word.width, strikeWidth * em}, {}}, {}, 0});
    }
    m_x += box.word.width;
  }

  /// Goes on with the last part where that looks alike.
  void addText(TextPart part, std::string copied = {}) {
    auto *last = m_line.things.empty() ? nullptr : std::get_if<TextPart>(&m_line.things.back().content);
    if (last && m_line.things.back().element == m_plan.element && last->face == part.face &&
        last->size == part.size && last->start.y == part.start.y && m_line.things.back().copied.empty() &&
        copied.empty()) {
      for (const TextPart::Glyph &glyph : part.glyphs)
        last->glyphs.push_back({glyph.glyph, glyph.x + part.start.x - last->start.x});
      return;
    }
    m_line.things.push_back({std::move(part), m_plan.element, m_order.next(), std::move(copied)});
  }

  void addFormula(FormulaPart part) {
    part.start.x = m_x;
    const double gap = formulaGap * m_plan.size;
    m_line.ascent = std::max(m_line.ascent, part.formula->ascent * part.size + gap);
    m_line.depth = std::max(m_line.depth, part.formula->depth * part.size + gap);
    m_x += part.formula->width * part.size;
    const std::size_t element = m_order.add("Formula", m_plan.element, formulaEntries(part.plain));
    std::string plain = part.plain;
    m_line.things.push_back({std::move(part), element, m_order.next(), std::move(plain)});
  }

  const ParagraphPlan &m_plan;
  const HandoutFonts &m_fonts;
  ReadingOrder &m_order;
  SetLine m_line;
  double m_x = 0;
};

/// How many times as wide the spaces of a line would be that fills the width.
double stretchOf(const Box *begin, const Box *end, const ParagraphPlan &plan) {
  double width = 0;
  double spaces = 0;
  for (const Box *box = begin; box != end; ++box) {
    width += box->item.width;
    spaces += box != begin ? box->item.space : 0;
  }
  return spaces > 0 ? std::max((plan.width - width) / spaces, 1 - mostShrinking) : 1;
}

} // namespace

std::string formulaEntries(const std::string &plain) {
  return "/ActualText" + pdfText(plain) + "/Alt" + pdfText(plain);
}

FormulaPart fittedFormula(const InlineFormula &formula, double size, double width) {
  FormulaPart part;
  part.plain = formula.plain;
  part.formula = formula.layout;
  part.size = size;
  if (formula.layout->width * size <= width)
    return part;
  math::LineRules rules;
  rules.width = width / size;
  part.formula = std::make_shared<const math::Layout>(math::breakLines(*formula.layout, rules));
  part.size = std::min(size, width / part.formula->width);
  return part;
}

std::vector<SetLine> setParagraph(const InlineText &text, const ParagraphPlan &plan,
                                  const HandoutFonts &fonts, ReadingOrder &order) {
  const std::vector<Box> boxes = Boxes(plan, fonts).make(text);
  std::vector<BreakItem> items;
  items.reserve(boxes.size());
  for (const Box &box : boxes)
    items.push_back(box.item);
  std::vector<std::size_t> starts = lineStarts(items, plan.width, plan.ends);
  starts.push_back(boxes.size());
  std::vector<SetLine> lines;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    const Box *begin = boxes.data() + starts[i];
    const Box *end = boxes.data() + starts[i + 1];
    const bool isLast = starts[i + 1] == boxes.size();
    const bool endsShort = isLast || boxes[starts[i + 1]].item.mustBegin;
    const double mostStretch = plan.ends == LineEnds::Ragged || endsShort ? 1 : widestSpace;
    const double stretch = std::min(stretchOf(begin, end, plan), mostStretch);
    lines.push_back(LineMaker(plan, fonts, order).make(begin, end, stretch, isLast));
  }
  return lines;
}

} // namespace halfspace
