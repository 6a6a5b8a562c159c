#include "widgets/typeset/sharp_bars.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace halfspace {
namespace {

// In em.
/// Shorter edges are serifs.
constexpr double shortestBar = 0.3;
constexpr double thickestBar = 0.12;
/// How far the ends of an edge may be out of level.
constexpr double unevenness = 0.002;

/// A height, and where it goes.
struct Move {
  double from = 0;
  double to = 0;
};

/// The heights of the long horizontal edges, from top to bottom.
std::vector<double> edgesOf(const QPainterPath &outline, double em) {
  std::vector<double> edges;
  for (int i = 1; i < outline.elementCount(); ++i) {
    const QPainterPath::Element from = outline.elementAt(i - 1);
    const QPainterPath::Element to = outline.elementAt(i);
    if (to.isLineTo() && std::abs(to.x - from.x) >= shortestBar * em &&
        std::abs(to.y - from.y) <= unevenness * em)
      edges.push_back(to.y);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Where the upper and the lower edges of bars go; further down the list further down.
std::vector<Move> movesOf(const std::vector<double> &edges, double em, double pen) {
  std::vector<Move> moves;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double thickness = edges[i + 1] - edges[i];
    if (thickness <= unevenness * em || thickness > thickestBar * em)
      continue;
    const double rows = std::max(1.0, std::round(thickness + pen));
    const double top = std::round((edges[i] + edges[i + 1] - rows) / 2);
    moves.push_back({edges[i], top + pen / 2});
    moves.push_back({edges[i + 1], top + rows - pen / 2});
    ++i;
  }
  return moves;
}

double moved(double y, const std::vector<Move> &moves) {
  const auto below =
      std::find_if(moves.begin(), moves.end(), [y](const Move &move) { return y <= move.from; });
  if (below == moves.begin() || below == moves.end()) {
    const Move &nearest = below == moves.begin() ? moves.front() : moves.back();
    return y + nearest.to - nearest.from;
  }
  const Move &above = *std::prev(below);
  return above.to + (y - above.from) / (below->from - above.from) * (below->to - above.to);
}

} // namespace

QPainterPath withSharpBars(QPainterPath outline, double em, double pen) {
  const std::vector<Move> moves = movesOf(edgesOf(outline, em), em, pen);
  if (moves.empty())
    return outline;
  for (int i = 0; i < outline.elementCount(); ++i) {
    const QPainterPath::Element element = outline.elementAt(i);
    outline.setElementPositionAt(i, element.x, moved(element.y, moves));
  }
  return outline;
}

} // namespace halfspace
