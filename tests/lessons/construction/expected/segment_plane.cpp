#include "lessons/object/kinds/segment.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const SegmentObject &s, const PlaneObject &E, const Rational &a, const Rational &b) {
  if (vanishes(E.normal))
    return "zero-normal";
  if (vanishes(ExactVec3(s.to - s.from)))
    return "zero-length";
  if (product(E.normal, ExactVec3(s.to - s.from)) == 0)
    return a == 0 ? "in-plane" : "parallel";
  if (a * b == 0)
    return "touches";
  return a * b < 0 ? "crosses" : "beside";
}

Recomputed recompute(Objects objects) {
  const auto s = objectAs<SegmentObject>(*objects[0]).value();
  const auto E = objectAs<PlaneObject>(*objects[1]).value();
  const Rational a = product(E.normal, ExactVec3(s.from - E.point));
  const Rational b = product(E.normal, ExactVec3(s.to - E.point));
  Recomputed expected;
  expected.caseName = caseOf(s, E, a, b);
  expected.degenerate = expected.caseName == "zero-normal" || expected.caseName == "zero-length";
  expected.names = {{"A", quantity(s.from)},    {"B", quantity(s.to)}, {"\\vec n", quantity(E.normal)},
                    {"P_0", quantity(E.point)}, {"f(A)", quantity(a)}, {"f(B)", quantity(b)}};
  if (vanishes(E.normal)) {
    expected.vanished.insert("E.n");
    return expected;
  }
  expected.values["f_A"] = number(a);
  expected.values["f_B"] = number(b);
  const bool isInside = expected.caseName == "crosses" || expected.caseName == "touches";
  if (!isInside && expected.caseName != "beside")
    return expected;
  // Of the line's points A + t(B − A) that one for which n·(A + t(B − A) − P0) is 0.
  const Rational t = -a / product(E.normal, ExactVec3(s.to - s.from));
  expected.values["t"] = number(t);
  expected.names["t"] = quantity(t);
  if (!isInside)
    return expected;
  const ExactVec3 point = s.from * Rational(1 - t) + s.to * t;
  expected.values["point"] = numbers(point);
  expected.names["S"] = quantity(point);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto s = objectAs<SegmentObject>(*objects[0]).value();
  const auto E = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(E.normal))
    return all;
  const Rational a = times(E.normal, ExactVec3(s.from - E.point));
  const Rational b = times(E.normal, ExactVec3(s.to - E.point));
  Line atStart("f-A", a, all);
  addSlips(atStart, differenceSlips(E.normal, s.from, E.point));
  Line atEnd("f-B", b, all);
  addSlips(atEnd, differenceSlips(E.normal, s.to, E.point));
  if (a == b)
    return all;
  Line t("t", Rational(a / (a - b)), all);
  addFraction(t, a, Rational(a - b));
  t.addRatio("from the other end", b, Rational(b - a));
  t.addRatio("a sum below", a, Rational(a + b));
  t.addRatio("the other f above", b, Rational(a - b));
  return all;
}

} // namespace

namespace expected {

Expected segment_plane() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
