#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Clipped {
  explicit Clipped(Objects objects) : E(objectAs<PlaneObject>(*objects[0]).value()) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      at.at(i) = objectAs<PointObject>(*objects[i + 1])->at;
      f.at(i) = product(E.normal, at.at(i)) - product(E.normal, E.point);
    }
  }

  bool isPlane() const { return !vanishes(E.normal); }
  bool isTriangle() const {
    return !vanishes(perpendicular(ExactVec3(at[1] - at[0]), ExactVec3(at[2] - at[0])));
  }
  template <class Condition> int count(Condition condition) const {
    return static_cast<int>(std::count_if(f.begin(), f.end(), condition));
  }
  int above() const {
    return count([](const Rational &each) { return each > 0; });
  }
  int below() const {
    return count([](const Rational &each) { return each < 0; });
  }
  /// Between corners of both signs.
  bool isCut(std::size_t edge) const { return f.at(edge) * f.at((edge + 1) % 3) < 0; }

  PlaneObject E;
  std::array<ExactVec3, 3> at;
  std::array<Rational, 3> f;
};

std::string caseOf(const Clipped &clipped) {
  if (!clipped.isPlane())
    return "zero-normal";
  if (!clipped.isTriangle())
    return "no-triangle";
  const int above = clipped.above();
  const int below = clipped.below();
  if (below == 3)
    return "nothing";
  if (below == 0)
    return "whole";
  return above == 0 ? "touch" : "cut";
}

std::string wayOf(bool isStartKept, bool isEndKept) {
  return isStartKept ? (isEndKept ? "kept" : "leaves") : isEndKept ? "enters" : "outside";
}

void addEdge(const Clipped &clipped, std::size_t edge, Recomputed &expected) {
  const std::string number = std::to_string(edge + 1);
  const std::size_t next = (edge + 1) % 3;
  const Rational &from = clipped.f.at(edge);
  const Rational &to = clipped.f.at(next);
  if (!expected.degenerate)
    expected.values["edge" + number] = wayOf(from >= 0, to >= 0);
  if (!clipped.isCut(edge))
    return;
  // weighted by how far the other end is from the plane
  const Rational whole = abs(from) + abs(to);
  const ExactVec3 cut =
      clipped.at.at(edge) * Rational(abs(to) / whole) + clipped.at.at(next) * Rational(abs(from) / whole);
  expected.values["t" + number] = test::number(Rational(abs(from) / whole));
  expected.values["cut" + number] = numbers(cut);
  expected.names["t_" + number] = quantity(Rational(abs(from) / whole));
  expected.names["H_" + number] = quantity(cut);
}

Recomputed recompute(Objects objects) {
  const Clipped clipped(objects);
  Recomputed expected;
  expected.names = {{"\\vec n", quantity(clipped.E.normal)}, {"P_0", quantity(clipped.E.point)}};
  expected.caseName = caseOf(clipped);
  expected.degenerate = !clipped.isPlane() || !clipped.isTriangle();
  expected.values["nn"] = number(product(clipped.E.normal, clipped.E.normal));
  if (!clipped.isPlane())
    expected.vanished.insert({"E.n", "it.side-A", "it.side-B", "it.side-C"});
  int cuts = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string corner(1, "ABC"[i]);
    expected.names[corner] = quantity(clipped.at.at(i));
    expected.names["f(" + corner + ")"] = quantity(clipped.f.at(i));
    expected.values["f_" + corner] = number(clipped.f.at(i));
    addEdge(clipped, i, expected);
    cuts += clipped.isCut(i) ? 1 : 0;
  }
  if (!expected.degenerate)
    expected.values["corners"] = number(3 - clipped.below() + cuts);
  return expected;
}

void addCut(std::vector<WrongAnswer> &all, const Clipped &clipped, std::size_t edge) {
  const std::string number = std::to_string(edge + 1);
  const std::size_t next = (edge + 1) % 3;
  const Rational &from = clipped.f.at(edge);
  const Rational &to = clipped.f.at(next);
  const Rational t = from / (from - to);
  Line part("t" + number, t, all);
  addFraction(part, from, Rational(from - to));
  part.add("from the other end", Rational(1 - t));
  part.addRatio("added below", from, Rational(from + to));
  part.addRatio("one by the other", from, to);
  part.addRatio("by the other one", from, Rational(-to));
  const ExactVec3 &start = clipped.at.at(edge);
  const ExactVec3 way = clipped.at.at(next) - start;
  const std::string line = "cut" + number;
  const ExactVec3 right = start + way * t;
  addVector(all, line.c_str(), "from the other end", ExactVec3(clipped.at.at(next) + way * t), right);
  addPointOnRay(all, line.c_str(), start, t, way);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Clipped clipped(objects);
  std::vector<WrongAnswer> all;
  if (!clipped.isPlane())
    return all;
  for (std::size_t i = 0; i < 3; ++i) {
    Line line(std::string("f-") + "ABC"[i],
              times(clipped.E.normal, ExactVec3(clipped.at.at(i) - clipped.E.point)), all);
    addSlips(line, differenceSlips(clipped.E.normal, clipped.at.at(i), clipped.E.point));
    if (clipped.isCut(i))
      addCut(all, clipped, i);
  }
  return all;
}

} // namespace

namespace expected {

Expected clipping() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.38};
}

} // namespace expected
} // namespace halfspace::test
