// Worked lines in a block, and a pointer over them.
#pragma once

#include "lessons/object/object.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "tests/lessons/called_line.h"
#include "tests/widgets/pointer.h"
#include "widgets/working/working_block.h"

namespace halfspace::test {

/// The result of one line left out.
inline Fade blankIn(const Working &working, const std::string &line) {
  return {{{line, resultGap(*findLine(working, line))}}, {}};
}

inline void show(WorkingBlock &block, int width, const Working &working) {
  block.resize(width, 500);
  block.show();
  block.setWorking(working);
}

/// The first of the line's shown numbers that reads so.
inline NumberPlace numberIn(const WorkingBlock &block, std::size_t line, const std::string &text) {
  for (const NumberPlace &place : block.shownNumbers().inLine(line))
    if (plainText(place.number) == text)
      return place;
  QTest::qFail(("there is no " + text).c_str(), __FILE__, __LINE__);
  return {"", LinePiece::Symbols, 0, 0};
}

/// Where the number stands in its block.
inline QPoint middleOf(const WorkingBlock &block, const NumberPlace &number) {
  const auto boxes = block.shownNumbers().boxesOf(number);
  return boxes.empty() ? QPoint(-1, -1) : boxes.front().center().toPoint();
}

inline void click(WorkingBlock &block, const NumberPlace &number) {
  QTest::mouseClick(&block, Qt::LeftButton, {}, middleOf(block, number));
}

/// u·u = 1·1 + 2·2 = 5, a = 2(u·u) = 2·5 = 10, and b = 3 without any number of u.
inline Working tracedWorking(int x = 1, const Rational &b = 3) {
  const Term u = given(vectorLetter("u"), ExactVec3(x, 2, 0), "L", 1).marked("u");
  const Term w = given(vectorLetter("w"), ExactVec3(b, 0, 0), "L", 0).marked("w");
  const Term a = name(letter("a"), Rational(2 * (4 + x * x)));
  return {{called("uu", line({withProducts(dot(u, u))})),
           called("a", line({withNumbers(a == 2 * dot(u, u))})),
           called("b", line({withNumbers(name(letter("b"), abs(b)) == norm(w))}))}};
}

} // namespace halfspace::test
