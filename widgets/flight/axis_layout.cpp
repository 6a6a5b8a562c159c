#include "widgets/flight/axis_layout.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// In units, as the lengths of the header.
constexpr double edgeTop = 2;
constexpr double levelGap = 13; ///< between the marks of usual stacks
constexpr int usualLevels = 3;
constexpr int mostLevels = 8;
constexpr double closest = 10;    ///< marks nearer to each other than this are stacked
constexpr double markHeight = 17; ///< of the lowest mark above the line: the torpedo passes below
constexpr double torpedoReach = 8;
constexpr double touchRadius = 8;

double lengthOf(QPointF way) { return std::hypot(way.x(), way.y()); }

} // namespace

bool AxisPin::isInTriangle() const { return standing != Standing::Outside && standing != Standing::NotAsked; }

void AxisLayout::setCrossings(const Crossings &crossings) {
  m_chosen = crossings.chosen;
  m_pins.clear();
  for (const Crossing &crossing : crossings.all)
    if (const Standing standing = standingOf(crossing, crossings);
        crossing.at && standing != Standing::NotAsked)
      m_pins.push_back({crossing, standing, toDouble(crossing.at->t)});
  // Of those at the same place a hit stands lowest.
  std::stable_sort(m_pins.begin(), m_pins.end(), [](const AxisPin &a, const AxisPin &b) {
    return a.t != b.t ? a.t < b.t : a.isInTriangle() && !b.isInTriangle();
  });
}

void AxisLayout::setTime(double t, double elapsed) {
  m_t = std::isfinite(t) ? t : 0;
  m_elapsed = std::isfinite(elapsed) ? elapsed : 0;
}

const std::vector<AxisPin> &AxisLayout::pins() const {
  static const std::vector<AxisPin> none;
  return m_hidden ? none : m_pins;
}

std::optional<std::size_t> AxisLayout::chosenPin() const {
  for (std::size_t i = 0; i < pins().size(); ++i)
    if (pins()[i].crossing.number == m_chosen)
      return i;
  return {};
}

void AxisLayout::settle(bool mayChangeRange) {
  if (mayChangeRange) {
    std::vector<double> hits;
    for (const AxisPin &pin : pins())
      if (pin.isInTriangle() && std::isfinite(pin.t))
        hits.push_back(pin.t);
    m_range = rangeFor(hits, time());
  }
  stack();
}

void AxisLayout::stack() {
  const AxisScale at = scale();
  std::vector<double> ends; // of each level, the last mark's place
  for (AxisPin &pin : m_pins) {
    if (!m_range.contains(pin.t))
      continue;
    const double x = at.xOf(pin.t);
    const auto isFree = [&](double end) { return x - end >= closest * unit(); };
    auto level = std::find_if(ends.begin(), ends.end(), isFree);
    if (level == ends.end() && ends.size() < mostLevels)
      level = ends.insert(level, x);
    else if (level == ends.end())
      --level;
    *level = x;
    pin.level = static_cast<int>(level - ends.begin());
  }
  m_levels = static_cast<int>(ends.size());
}

double AxisLayout::unit() const { return QFontMetricsF(m_axis.font()).height() / 16; }

AxisScale AxisLayout::scale() const {
  return {m_range, axisLeftRoom * unit(),
          std::max(m_axis.width() - axisRightRoom * unit(), (axisLeftRoom + 1) * unit())};
}

double AxisLayout::lineY() const {
  const double top = edgeTop + ringRadius * axisMarkRadius + (usualLevels - 1) * levelGap + markHeight;
  return std::floor(top * unit());
}

double AxisLayout::height() const {
  const double words = QFontMetricsF(m_axis.font()).height();
  return lineY() + axisNumbersBelow * unit() + std::max(words, torpedoReach * unit());
}

QPointF AxisLayout::handle() const {
  return {scale().xOf(std::clamp(time(), m_range.low, m_range.high)), lineY()};
}

QPointF AxisLayout::placeOf(const AxisPin &pin) const {
  const double gap = m_levels <= usualLevels ? levelGap : (usualLevels - 1) * levelGap / (m_levels - 1);
  return {scale().xOf(pin.t), lineY() - (markHeight + pin.level * gap) * unit()};
}

QPointF AxisLayout::placeOf(End end) const {
  const AxisScale at = scale();
  const double x =
      end == End::Low ? at.left - axisLeftRoom * unit() / 2 : at.right + axisRightRoom * unit() / 2;
  return {x, lineY() - markHeight * unit()};
}

std::optional<QPointF> AxisLayout::placeOf(std::size_t number) const {
  for (const AxisPin &pin : pins())
    if (pin.crossing.number == number)
      return m_range.contains(pin.t) ? placeOf(pin) : placeOf(pin.t < m_range.low ? End::Low : End::High);
  return {};
}

std::vector<const AxisPin *> AxisLayout::clippedAt(End end) const {
  std::vector<const AxisPin *> clipped;
  for (const AxisPin &pin : pins())
    if (end == End::Low ? pin.t < m_range.low : pin.t > m_range.high)
      clipped.push_back(&pin);
  if (end == End::Low)
    std::reverse(clipped.begin(), clipped.end());
  return clipped;
}

std::vector<const AxisPin *> AxisLayout::pinsAt(QPointF place) const {
  const auto distance = [&](QPointF mark) { return lengthOf(mark - place); };
  const double reach = touchRadius * unit();
  for (const End end : {End::Low, End::High})
    if (distance(placeOf(end)) <= reach)
      if (std::vector<const AxisPin *> clipped = clippedAt(end); !clipped.empty())
        return clipped;
  std::vector<const AxisPin *> found;
  for (const AxisPin &pin : pins())
    if (m_range.contains(pin.t) && distance(placeOf(pin)) <= reach)
      found.push_back(&pin);
  std::stable_sort(found.begin(), found.end(), [&](const AxisPin *a, const AxisPin *b) {
    return a->isInTriangle() != b->isInTriangle() && placeOf(*a) == placeOf(*b)
               ? a->isInTriangle()
               : distance(placeOf(*a)) < distance(placeOf(*b));
  });
  return found;
}

} // namespace halfspace
