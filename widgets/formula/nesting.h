// How deep a reader of nested things is.
#pragma once

#include "widgets/formula/latex_reader.h"

namespace halfspace::math {

/// One level for as long as it lives.
class LatexReader::Nesting {
public:
  explicit Nesting(LatexReader &reader) : m_depth(reader.m_depth) {
    if (m_depth >= deepestNesting)
      throw ReadError{reader.m_tokens.peek().column, "This is nested too deeply."};
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

} // namespace halfspace::math
