#include "widgets/working/working_numbers.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Whether two numbers are the same coordinate, or calculated by the same formula.
bool comeFromTheSame(const Term &a, const Term &b) {
  if (a->source != b->source || a->origin.has_value() != b->origin.has_value())
    return false;
  return !a->origin || readAlike(*a->origin, *b->origin);
}

/// How far a place is from a box; 0 inside.
double distance(QPointF from, const QRectF &box) {
  const double right = std::max({box.left() - from.x(), 0.0, from.x() - box.right()});
  const double down = std::max({box.top() - from.y(), 0.0, from.y() - box.bottom()});
  return std::hypot(right, down);
}

} // namespace

bool NumberPlace::operator==(const NumberPlace &other) const {
  return line == other.line && piece == other.piece && nth == other.nth &&
         comeFromTheSame(number, other.number);
}

const CoordinateSource *NumberPlace::coordinate() const {
  return number->source ? &*number->source : nullptr;
}

NumberPlace ShownNumbers::placeOf(std::size_t line, LinePiece piece, std::size_t index) const {
  const std::vector<Term> &numbers = m_lines[line].numbers[static_cast<std::size_t>(piece)];
  const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(index);
  const auto before = std::count_if(numbers.begin(), end,
                                    [&](const Term &each) { return comeFromTheSame(each, numbers[index]); });
  return {m_lines[line].source.id, piece, numbers[index], static_cast<std::size_t>(before)};
}

std::optional<ShownNumbers::Found> ShownNumbers::find(const NumberPlace &place) const {
  const auto line = std::find_if(m_lines.begin(), m_lines.end(),
                                 [&](const TypesetLine &each) { return each.source.id == place.line; });
  if (line == m_lines.end())
    return {};
  const std::vector<Term> &numbers = line->numbers[static_cast<std::size_t>(place.piece)];
  std::size_t before = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (comeFromTheSame(numbers[i], place.number) && before++ == place.nth)
      return Found{static_cast<std::size_t>(line - m_lines.begin()), i};
  return {};
}

std::optional<NumberPlace> ShownNumbers::at(QPointF position) const {
  std::optional<NumberPlace> nearest;
  double least = touchMargin;
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i) {
    const PlacedLine &line = m_placed.lines[i];
    if (position.y() < line.box.top() || position.y() >= line.box.bottom())
      continue;
    for (const PlacedFormula &formula : line.formulas)
      for (const auto &[index, box] : formula.picture->indexBoxes()) {
        const double away = distance(position, formula.toWorking(box));
        if (!formula.piece || away > least || (nearest && away == least))
          continue;
        least = away;
        nearest = placeOf(i, *formula.piece, index);
      }
  }
  return nearest;
}

std::vector<NumberPlace> ShownNumbers::inLine(std::size_t line) const {
  std::vector<NumberPlace> places;
  if (line >= m_placed.lines.size())
    return places;
  for (const PlacedFormula &formula : m_placed.lines[line].formulas)
    for (const auto &[index, box] : formula.picture->indexBoxes()) {
      if (!formula.piece)
        continue;
      const NumberPlace place = placeOf(line, *formula.piece, index);
      if (places.empty() || !(places.back() == place)) // a broken one has several boxes
        places.push_back(place);
    }
  return places;
}

std::vector<QRectF> ShownNumbers::boxesOf(const NumberPlace &place) const {
  std::vector<QRectF> boxes;
  const auto found = find(place);
  if (!found || found->line >= m_placed.lines.size())
    return boxes;
  for (const PlacedFormula &formula : m_placed.lines[found->line].formulas)
    if (formula.piece == place.piece)
      for (const auto &[index, box] : formula.picture->indexBoxes())
        if (index == found->index)
          boxes.push_back(formula.toWorking(box));
  return boxes;
}

std::optional<std::size_t> ShownNumbers::lineOf(const NumberPlace &place) const {
  const auto found = find(place);
  return found && !boxesOf(place).empty() ? std::optional(found->line) : std::nullopt;
}

const Term *ShownNumbers::numberAt(const NumberPlace &place) const {
  const auto found = find(place);
  return found && !boxesOf(place).empty()
             ? &m_lines[found->line].numbers[static_cast<std::size_t>(place.piece)][found->index]
             : nullptr;
}

} // namespace halfspace
