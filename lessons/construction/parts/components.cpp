#include "lessons/construction/parts/components.h"

#include "lessons/object/letters.h"

#include <utility>

namespace halfspace {

Term componentOf(const Term &whole, Symbol symbol, int axis) {
  const auto node = std::make_shared<TermNode>(*name(std::move(symbol), vectorOf(whole)[axis]));
  node->mark = whole->mark;
  node->source = whole->source;
  if (node->source)
    node->source->component = axis;
  return Term(node);
}

Symbol indexed(Symbol symbol, const std::string &index) {
  symbol.subscript = index;
  symbol.isVector = false;
  return symbol;
}

Rational rationalOf(const Term &number) { return numberOf(number)->exact()->rationalPart(); }

} // namespace halfspace
