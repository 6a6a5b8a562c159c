#include "widgets/handout/break_paragraph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// A line that is too wide costs more than any other way to break the paragraph, the more the wider it is.
constexpr double tooWide = 1e9;
/// How much wider spaces of a justified line become before it looks loose, as part of their width.
constexpr double easyStretching = 0.6;
/// How much of its width a ragged line leaves before it looks short.
constexpr double easyShortness = 0.12;
/// What a line costs that is loose or short to that amount.
constexpr double easyCost = 100;
/// What each line costs, so that fewer are better.
constexpr double lineCost = 10;
/// What it costs where the last line is shorter than this part of the width.
constexpr double shortEnd = 0.15;
constexpr double shortEndCost = 150;

double cubed(double x) { return x * x * x; }

class Breaker {
public:
  Breaker(const std::vector<BreakItem> &items, double width, LineEnds ends)
      : m_items(items), m_width(width), m_ends(ends), m_best(items.size() + 1) {}

  std::vector<std::size_t> starts() {
    m_best.front().cost = 0;
    for (std::size_t end = 1; end <= m_items.size(); ++end)
      if (mayEnd(end))
        findBestStart(end);
    std::vector<std::size_t> starts;
    for (std::size_t end = m_items.size(); end > 0; end = m_best[end].start)
      starts.push_back(m_best[end].start);
    std::reverse(starts.begin(), starts.end());
    return starts;
  }

private:
  /// The best way to break what stands before an end.
  struct Best {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t start = 0; ///< of its last line
  };

  [[nodiscard]] bool isLast(std::size_t end) const { return end == m_items.size(); }
  [[nodiscard]] bool mayEnd(std::size_t end) const {
    return isLast(end) || m_items[end].mayBegin || m_items[end].mustBegin;
  }

  /// Goes back over the starts of a line that ends here, until it is too wide or begins where it must.
  void findBestStart(std::size_t end) {
    double width = 0;
    double spaces = 0;
    for (std::size_t start = end; start-- > 0;) {
      const BreakItem &item = m_items[start];
      width += item.width;
      const bool isPossible = start == 0 || item.mayBegin || item.mustBegin;
      if (isPossible) {
        const double cost = m_best[start].cost + costOf(width, spaces, end);
        if (cost < m_best[end].cost)
          m_best[end] = {cost, start};
        if (item.mustBegin || isTooWide(width, spaces))
          return;
      }
      spaces += item.space;
    }
  }

  [[nodiscard]] bool isTooWide(double width, double spaces) const {
    const double shrunk = m_ends == LineEnds::Justified ? spaces * (1 - mostShrinking) : spaces;
    constexpr double rounding = 1e-6;
    return width + shrunk > m_width + rounding;
  }

  /// Of a line with so much in it.
  [[nodiscard]] double costOf(double width, double spaces, std::size_t end) const {
    if (isTooWide(width, spaces))
      return tooWide * (1 + (width + spaces - m_width) / m_width);
    const double left = m_width - width - spaces;
    if (isLast(end) || m_items[end].mustBegin)
      return lineCost + (width + spaces < shortEnd * m_width && end > 1 ? shortEndCost : 0);
    if (m_ends == LineEnds::Ragged)
      return lineCost + easyCost * cubed(left / (easyShortness * m_width));
    if (left < 0)
      return lineCost + easyCost * cubed(-left / (mostShrinking * spaces));
    // Without spaces nothing can be stretched: the line is as bad as one with a single space.
    const double stretchable = std::max(spaces, easyShortness * easyShortness * m_width);
    return lineCost + easyCost * cubed(left / (easyStretching * stretchable));
  }

  const std::vector<BreakItem> &m_items;
  double m_width;
  LineEnds m_ends;
  std::vector<Best> m_best; ///< by ends
};

} // namespace

std::vector<std::size_t> lineStarts(const std::vector<BreakItem> &items, double width, LineEnds ends) {
  return items.empty() ? std::vector<std::size_t>() : Breaker(items, width, ends).starts();
}

} // namespace halfspace
