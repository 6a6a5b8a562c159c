#include "lessons/formula/plane_through.h"

namespace halfspace {

Formula wayBetween(const Formula &from, const Formula &to) {
  return {FormulaKind::Difference, {}, {}, {to, from}};
}

std::vector<Formula> planeThrough(const Formula &a, const Formula &b, const Formula &c) {
  const Formula across{FormulaKind::Cross, {}, {}, {wayBetween(a, b), wayBetween(a, c)}};
  return {a, {FormulaKind::Shortest, {}, {}, {across}}};
}

std::optional<std::array<Formula, 3>> pointsOfPlane(const std::vector<Formula> &coordinates) {
  const Formula &point = coordinates.front();
  const Formula &normal = coordinates.back();
  const auto leadsFromPoint = [&](const Formula &way) {
    return way.kind == FormulaKind::Difference && way.parts[1] == point;
  };
  if (normal.kind != FormulaKind::Shortest || normal.parts[0].kind != FormulaKind::Cross)
    return {};
  const std::vector<Formula> &ways = normal.parts[0].parts;
  if (!leadsFromPoint(ways[0]) || !leadsFromPoint(ways[1]))
    return {};
  return std::array{point, ways[0].parts[0], ways[1].parts[0]};
}

} // namespace halfspace
