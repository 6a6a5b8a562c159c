#include "widgets/handout/set_figure.h"

#include <algorithm>
#include <span>
#include <utility>

namespace halfspace {
namespace {

/// Between rows of drawings, and between these and the caption, in parts of its leading.
constexpr double captionGap = 0.4;

/// Behind as many drawings as stand beside each other.
std::size_t endOfRow(const std::vector<Drawing> &drawings, std::size_t begin, double room) {
  std::size_t end = begin + 1;
  double width = drawings[begin].size.x;
  while (end < drawings.size() && width + drawings[end].size.x <= room)
    width += drawings[end++].size.x;
  return end;
}

class FigureSetter {
public:
  FigureSetter(const FigureBlock &figure, const ParagraphPlan &plan, const HandoutFonts &fonts,
               ReadingOrder &order)
      : m_figure(figure), m_plan(plan), m_fonts(fonts), m_order(order) {}

  Chunk set() {
    m_chunk.floats = true;
    const std::size_t element = m_order.add("Figure", m_plan.element);
    const std::vector<Drawing> &drawings = m_figure.drawings;
    for (std::size_t begin = 0; begin < drawings.size();) {
      m_chunk.height += begin > 0 ? captionGap * m_plan.leading : 0;
      const std::size_t end = endOfRow(drawings, begin, m_plan.width);
      addRow(std::span(drawings).subspan(begin, end - begin), element);
      begin = end;
    }
    if (!m_figure.caption.empty())
      addCaption();
    return std::move(m_chunk);
  }

private:
  /// They stand on one line, with equal gaps.
  void addRow(std::span<const Drawing> drawings, std::size_t element) {
    double free = m_plan.width;
    double height = 0;
    for (const Drawing &drawing : drawings) {
      free -= drawing.size.x;
      height = std::max(height, drawing.size.y);
    }
    const double gap = free / static_cast<double>(drawings.size() + 1);
    double left = gap;
    for (const Drawing &drawing : drawings) {
      auto described = std::make_shared<Drawing>(drawing);
      described->description = m_figure.description;
      const glm::dvec2 at(left, m_chunk.height + height - drawing.size.y);
      m_chunk.things.push_back({FigurePart{std::move(described), at}, element, m_order.next()});
      left += drawing.size.x + gap;
    }
    m_chunk.height += height;
  }

  /// One of a single line stands in the middle.
  void addCaption() {
    ParagraphPlan plan = m_plan;
    plan.element = m_order.add("Caption", m_plan.element);
    std::vector<SetLine> lines = setParagraph(m_figure.caption, plan, m_fonts, m_order);
    m_chunk.height += captionGap * m_plan.leading;
    const double inset = lines.size() == 1 ? (m_plan.width - lines.front().width) / 2 : 0;
    for (SetLine &line : lines) {
      for (SetThing &thing : line.things)
        m_chunk.things.push_back(moved(std::move(thing), {inset, m_chunk.height + line.ascent}));
      m_chunk.height += line.ascent + line.depth;
    }
  }

  const FigureBlock &m_figure;
  const ParagraphPlan &m_plan;
  const HandoutFonts &m_fonts;
  ReadingOrder &m_order;
  Chunk m_chunk;
};

} // namespace

Chunk setFigure(const FigureBlock &figure, const ParagraphPlan &plan, const HandoutFonts &fonts,
                ReadingOrder &order) {
  return FigureSetter(figure, plan, fonts, order).set();
}

} // namespace halfspace
