// What a reader of nested things enters and leaves again.
#pragma once

#include "lessons/words.h"
#include "widgets/formula/token_stream.h"

#include <utility>

namespace halfspace::math {

/// One level for as long as it lives.
class Nesting {
public:
  /// Throws ReadError where this is too deep.
  Nesting(int &depth, TokenStream &tokens) : m_depth(depth) {
    if (m_depth >= deepestNesting)
      throw ReadError{tokens.peek().column, halfspace::words("This is nested too deeply.")};
    ++m_depth;
  }
  ~Nesting() { --m_depth; }
  Nesting(const Nesting &) = delete;
  Nesting &operator=(const Nesting &) = delete;
  Nesting(Nesting &&) = delete;
  Nesting &operator=(Nesting &&) = delete;

private:
  int &m_depth;
};

/// A variable has another value for as long as it lives, and then the one before.
template <class Value> class Within {
public:
  Within(Value &variable, Value inside)
      : m_variable(variable), m_outside(std::exchange(variable, std::move(inside))) {}
  ~Within() { m_variable = std::move(m_outside); }
  Within(const Within &) = delete;
  Within &operator=(const Within &) = delete;
  Within(Within &&) = delete;
  Within &operator=(Within &&) = delete;

private:
  Value &m_variable;
  Value m_outside;
};

} // namespace halfspace::math
