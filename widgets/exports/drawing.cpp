#include "widgets/exports/drawing.h"

#include "lessons/figure/mark.h"

namespace halfspace {
namespace {

void move(PagePath &path, glm::dvec2 by) {
  for (PageStep &step : path.steps) {
    step.to += by;
    step.first += by;
    step.second += by;
  }
}

} // namespace

Drawing partOf(Drawing drawing, glm::dvec2 corner, glm::dvec2 size) {
  for (DrawingPart &part : drawing.parts)
    std::visit(Overloaded{[&](PathPart &path) { move(path.path, -corner); },
                          [&](FormulaPart &formula) { formula.start -= corner; }},
               part);
  drawing.size = size;
  return drawing;
}

} // namespace halfspace
