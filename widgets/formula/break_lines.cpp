#include "widgets/formula/break_lines.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace halfspace::math {
namespace {

/// What it costs to break where one should rather not, counted in widths of a line: a line may be left this
/// much emptier to be broken at a better place.
constexpr std::array<double, 7> costs{0, 0.4, 0.9, 1.5, 1.6, 2.6, 3.2};

/// A relation that stands further right than this part of the line has no others below it.
constexpr double furthestRelation = 0.25;
/// How much further right than a relation above it a line begins with a sign, in em.
constexpr double signIndent = 1;

/// The pieces [begin, end) on one line, which begins at `left`.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
  double left = 0;
};

class LineBreaker {
public:
  LineBreaker(Layout &layout, const LineRules &rules) : m_layout(layout), m_rules(rules) {}

  void run() {
    findSpans();
    setLines();
    moveShapes();
    moveTags();
    finish();
  }

private:
  [[nodiscard]] const Piece &piece(std::size_t i) const { return m_layout.pieces[i]; }
  void findSpans();
  [[nodiscard]] std::size_t bestEnd(std::size_t begin, double left) const;
  [[nodiscard]] double leftOf(std::size_t begin) const;
  /// Whether a line that begins with this piece goes on with what stands on the line before, within one side.
  [[nodiscard]] bool continuesSide(std::size_t begin) const;
  void setLines();
  void moveShapes();
  void movePieceTags(std::size_t piece, double right, double down);
  void moveTags();
  [[nodiscard]] std::vector<TagBox> boxesOf(const TaggedPieces &tagged) const;
  void finish();

  Layout &m_layout;
  LineRules m_rules;
  std::vector<Span> m_spans;
  std::vector<Line> m_lines;
};

void LineBreaker::findSpans() {
  for (std::size_t begin = 0; begin < m_layout.pieces.size();) {
    const double left = begin == 0 ? piece(0).x : leftOf(begin);
    const std::size_t end = bestEnd(begin, left);
    m_spans.push_back({begin, end, left});
    begin = end;
  }
}

/// Where a line begins that is not the first.
double LineBreaker::leftOf(std::size_t begin) const {
  const auto &pieces = m_layout.pieces;
  if (pieces[begin].before == Break::Statement)
    return pieces.front().x;
  const auto relation = std::find_if(pieces.begin(), pieces.end(),
                                     [](const Piece &each) { return each.before == Break::Relation; });
  const bool isBelow =
      m_rules.belowRelation && relation != pieces.end() && relation->x <= furthestRelation * m_rules.width;
  if (!isBelow)
    return m_rules.indent;
  return piece(begin).before == Break::Relation ? relation->x : relation->x + signIndent;
}

bool LineBreaker::continuesSide(std::size_t begin) const {
  return begin > 0 && piece(begin).before != Break::Statement && piece(begin).before != Break::Relation;
}

/// The piece that the line after this one best begins with.
std::size_t LineBreaker::bestEnd(std::size_t begin, double left) const {
  const std::size_t count = m_layout.pieces.size();
  const auto rightOf = [&](std::size_t last) { return piece(last).right - piece(begin).x + left; };
  std::size_t best = count;
  double leastCost = std::numeric_limits<double>::infinity();
  for (std::size_t i = begin; i < count; ++i) {
    const bool fits = rightOf(i) <= m_rules.width;
    if (!fits && best < count)
      return best;
    // Behind the rest of a side another would be hard to find.
    if (continuesSide(begin) && i + 1 < count && piece(i + 1).before == Break::Relation)
      return i + 1;
    // Where nothing fits, the first place to break is the best.
    if (i + 1 < count && piece(i + 1).before != Break::Never) {
      const double empty = 1 - rightOf(i) / m_rules.width;
      const double cost = costs[static_cast<std::size_t>(piece(i + 1).before)] + empty;
      if (!fits)
        return i + 1;
      if (cost <= leastCost) {
        leastCost = cost;
        best = i + 1;
      }
    }
  }
  return rightOf(count - 1) <= m_rules.width ? count : best;
}

void LineBreaker::setLines() {
  for (const Span &span : m_spans) {
    Line line;
    line.left = span.left;
    line.right = span.left + piece(span.end - 1).right - piece(span.begin).x;
    line.ascent = line.depth = -std::numeric_limits<double>::infinity();
    for (std::size_t i = span.begin; i < span.end; ++i) {
      line.ascent = std::max(line.ascent, piece(i).ascent);
      line.depth = std::max(line.depth, piece(i).depth);
    }
    if (!m_lines.empty())
      line.baseline = m_lines.back().baseline + m_lines.back().depth + m_rules.gap + line.ascent;
    m_lines.push_back(line);
  }
}

void LineBreaker::moveShapes() {
  for (std::size_t i = 0; i < m_spans.size(); ++i) {
    const Span &span = m_spans[i];
    const double right = span.left - piece(span.begin).x;
    const double down = m_lines[i].baseline;
    const bool isLast = span.end == m_layout.pieces.size();
    const std::size_t glyphEnd = isLast ? m_layout.glyphs.size() : piece(span.end).glyphs;
    const std::size_t ruleEnd = isLast ? m_layout.rules.size() : piece(span.end).rules;
    for (std::size_t k = piece(span.begin).glyphs; k < glyphEnd; ++k) {
      m_layout.glyphs[k].x += right;
      m_layout.glyphs[k].y += down;
    }
    for (std::size_t k = piece(span.begin).rules; k < ruleEnd; ++k) {
      m_layout.rules[k].box.x += right;
      m_layout.rules[k].box.y += down;
    }
    for (std::size_t k = span.begin; k < span.end; ++k)
      movePieceTags(k, right, down);
  }
}

/// Tags inside a piece move with it.
void LineBreaker::movePieceTags(std::size_t index, double right, double down) {
  const bool isLast = index + 1 == m_layout.pieces.size();
  const std::size_t end = isLast ? m_layout.tagBoxes.size() : piece(index + 1).tagBoxes;
  for (std::size_t k = piece(index).tagBoxes; k < end; ++k) {
    m_layout.tagBoxes[k].box.x += right;
    m_layout.tagBoxes[k].box.y += down;
  }
}

/// Tags around whole pieces get a box on each line that they reach into, in place of the one they had.
void LineBreaker::moveTags() {
  std::vector<const TaggedPieces *> whole(m_layout.tagBoxes.size());
  for (const TaggedPieces &tagged : m_layout.taggedPieces)
    whole[tagged.tagBox] = &tagged;
  std::vector<TagBox> boxes;
  for (std::size_t i = 0; i < m_layout.tagBoxes.size(); ++i) {
    if (!whole[i]) {
      boxes.push_back(m_layout.tagBoxes[i]);
      continue;
    }
    const std::vector<TagBox> parts = boxesOf(*whole[i]);
    boxes.insert(boxes.end(), parts.begin(), parts.end());
  }
  m_layout.tagBoxes = std::move(boxes);
}

std::vector<TagBox> LineBreaker::boxesOf(const TaggedPieces &tagged) const {
  std::vector<TagBox> boxes;
  const int tag = m_layout.tagBoxes[tagged.tagBox].tag;
  for (std::size_t i = 0; i < m_spans.size(); ++i) {
    const std::size_t begin = std::max(tagged.begin, m_spans[i].begin);
    const std::size_t end = std::min(tagged.end, m_spans[i].end);
    if (begin >= end)
      continue;
    const double right = m_spans[i].left - piece(m_spans[i].begin).x;
    double ascent = piece(begin).ascent;
    double depth = piece(begin).depth;
    for (std::size_t k = begin; k < end; ++k) {
      ascent = std::max(ascent, piece(k).ascent);
      depth = std::max(depth, piece(k).depth);
    }
    boxes.push_back({tag,
                     {piece(begin).x + right, m_lines[i].baseline - ascent,
                      piece(end - 1).right - piece(begin).x, ascent + depth}});
  }
  return boxes;
}

void LineBreaker::finish() {
  m_layout.width = 0;
  for (const Line &line : m_lines)
    m_layout.width = std::max(m_layout.width, line.right);
  m_layout.ascent = m_lines.front().ascent;
  m_layout.depth = m_lines.back().baseline + m_lines.back().depth;
  m_layout.lines = std::move(m_lines);
  m_layout.pieces.clear();
  m_layout.taggedPieces.clear();
}

} // namespace

Layout breakLines(Layout layout, const LineRules &rules) {
  if (layout.width > rules.width && rules.width > 0 && !layout.pieces.empty())
    LineBreaker(layout, rules).run();
  layout.pieces.clear();
  layout.taggedPieces.clear();
  return layout;
}

} // namespace halfspace::math
