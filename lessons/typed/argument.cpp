#include "lessons/typed/argument.h"

#include "lessons/formula/plane_through.h"

#include <utility>

namespace halfspace {

std::vector<Argument> asTriple(const std::vector<Argument> &numbers) {
  Formula triple{FormulaKind::Triple, {}, {}, {}, numbers.front().at};
  for (const Argument &number : numbers)
    triple.parts.push_back(number.formula);
  return {{std::move(triple), numbers.front().at,
           numbers.back().at + numbers.back().length - numbers.front().at}};
}

std::vector<Argument> throughPoints(const std::vector<Argument> &points) {
  std::vector<Formula> plane = planeThrough(points[0].formula, points[1].formula, points[2].formula);
  return {{std::move(plane[0]), points[0].at, points[0].length},
          {std::move(plane[1]), points[1].at, points[1].length}};
}

} // namespace halfspace
