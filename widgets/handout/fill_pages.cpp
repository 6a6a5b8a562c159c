#include "widgets/handout/fill_pages.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Sums of lengths are rounded: what is higher by no more than this still fits.
constexpr double rounding = 1e-6;
/// Between what is in front and the columns, in parts of the leading.
constexpr double frontGap = 1.2;

class PageFiller {
public:
  explicit PageFiller(const HandoutLook &look) : m_look(look), m_top(look.top), m_y(look.top) {}

  std::vector<FilledPage> fill(std::vector<Chunk> front, std::vector<Chunk> body) {
    for (Chunk &chunk : front)
      place(std::move(chunk), m_look.side);
    if (!front.empty())
      m_top = m_y = m_y + frontGap * m_look.leading();
    m_isEmpty = true;
    for (std::size_t begin = 0; begin < body.size();) {
      const std::size_t end = endOfGroup(body, begin);
      fillIn(body, begin, end);
      begin = end;
    }
    while (!m_floats.empty())
      beginColumn();
    return std::move(m_pages);
  }

private:
  /// Behind the pieces that keep with each other from here on.
  static std::size_t endOfGroup(const std::vector<Chunk> &chunks, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < chunks.size() && chunks[end - 1].keepsWithNext)
      ++end;
    return end;
  }

  void fillIn(std::vector<Chunk> &chunks, std::size_t begin, std::size_t end) {
    double height = 0;
    for (std::size_t i = begin; i < end; ++i)
      height += chunks[i].height + (i > begin ? chunks[i].gapAbove : 0);
    const auto fits = [&, gap = chunks[begin].gapAbove] {
      return m_y + (m_isEmpty ? 0 : gap) + height <= bottom() + rounding;
    };
    if (chunks[begin].floats && (!fits() || !m_floats.empty())) { // figures keep their order
      m_floats.push_back(std::move(chunks[begin]));
      return;
    }
    if (height <= m_look.textHeight())
      while (!fits()) // a figure that has waited may take the next column
        beginColumn();
    for (std::size_t i = begin; i < end; ++i) {
      while (!m_isEmpty && m_y + chunks[i].gapAbove + chunks[i].height > bottom() + rounding)
        beginColumn();
      place(std::move(chunks[i]), m_look.columnLeft(m_column));
    }
  }

  void place(Chunk chunk, double left) {
    m_y += m_isEmpty ? 0 : chunk.gapAbove;
    m_isEmpty = false;
    const double height = chunk.height;
    m_pages.back().push_back({std::move(chunk), {left, m_y}});
    m_y += height;
  }

  /// What floats comes first, as much of it as there is room for.
  void beginColumn() {
    if (++m_column == m_look.columns) {
      m_column = 0;
      m_pages.emplace_back();
      m_top = m_look.top;
    }
    m_y = m_top;
    m_isEmpty = true;
    std::vector<Chunk> waiting = std::exchange(m_floats, {});
    for (Chunk &chunk : waiting)
      if (m_floats.empty() && (m_isEmpty || m_y + chunk.gapAbove + chunk.height <= bottom() + rounding))
        place(std::move(chunk), m_look.columnLeft(m_column));
      else
        m_floats.push_back(std::move(chunk));
  }

  [[nodiscard]] double bottom() const { return m_look.page.y - m_look.bottom; }

  const HandoutLook &m_look;
  std::vector<FilledPage> m_pages{1};
  std::vector<Chunk> m_floats; ///< that wait for room
  double m_top;                ///< of the columns of this page
  double m_y;
  int m_column = 0;
  bool m_isEmpty = true; ///< nothing stands in the column yet
};

} // namespace

std::vector<FilledPage> fillPages(std::vector<Chunk> front, std::vector<Chunk> body,
                                  const HandoutLook &look) {
  return PageFiller(look).fill(std::move(front), std::move(body));
}

} // namespace halfspace
