#include "widgets/handout/set_thing.h"

#include "lessons/figure/mark.h"

#include <utility>

namespace halfspace {

SetThing moved(SetThing thing, glm::dvec2 by) {
  std::visit(Overloaded{[&](TextPart &text) { text.start += by; },
                        [&](FormulaPart &formula) { formula.start += by; },
                        [&](RulePart &rule) {
                          rule.box.x += by.x;
                          rule.box.y += by.y;
                        },
                        [&](FigurePart &figure) { figure.at += by; }},
             thing.content);
  return thing;
}

std::size_t ReadingOrder::add(std::string role, std::optional<std::size_t> parent, std::string entries) {
  m_elements.push_back({std::move(role), parent, std::move(entries), m_next++});
  return m_elements.size() - 1;
}

} // namespace halfspace
