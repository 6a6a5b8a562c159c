#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Three {
  explicit Three(Objects objects)
      : u(objectAs<VectorObject>(*objects[0])->vector), v(objectAs<VectorObject>(*objects[1])->vector),
        w(objectAs<VectorObject>(*objects[2])->vector) {}

  ExactVec3 u, v, w;
  Rational D = determinant(u, v, w);
  ExactVec3 n = perpendicular(u, v);
  ExactVec3 p = perpendicular(v, w);
  /// By the dot products, not crosswise.
  ExactVec3 q = v * product(u, w) - w * product(u, v);
};

std::string caseOf(const Three &at) {
  if (at.D != 0)
    return at.D > 0 ? "right-handed" : "left-handed";
  if (vanishes(at.u) || vanishes(at.v) || vanishes(at.w))
    return "zero-vector";
  return vanishes(at.n) || vanishes(at.p) || vanishes(perpendicular(at.w, at.u)) ? "parallel" : "flat";
}

void addVanished(const Three &at, std::set<std::string> &vanished) {
  for (const auto &[vector, mark] :
       {std::pair(at.u, "u.v"), {at.v, "v.v"}, {at.w, "w.v"}, {at.n, "it.n"}, {at.p, "it.p"}, {at.q, "it.q"}})
    if (vanishes(vector))
      vanished.insert(mark);
  if (at.D == 0)
    vanished.insert({"it.h", "it.tetrahedron"});
  if (vanishes(at.n) && vanishes(at.p) && vanishes(perpendicular(at.w, at.u)))
    vanished.insert("it.box");
}

Recomputed recompute(Objects objects) {
  const Three at(objects);
  const Rational nn = product(at.n, at.n);
  const Rational volume = abs(at.D);
  Recomputed expected;
  expected.caseName = caseOf(at);
  expected.degenerate = expected.caseName == "zero-vector" || expected.caseName == "parallel";
  // With w upright the volume is |n||w|.
  const bool isLess = volume * volume < nn * product(at.w, at.w);
  expected.values = {{"det", number(at.D)},
                     {"volume", number(volume)},
                     {"tetrahedron", number(volume / 6)},
                     {"normal", numbers(at.n)},
                     {"base_area", SignedSquares{nn}},
                     {"orientation", at.D == 0 ? "none" : expected.caseName},
                     {"straightened", isLess ? "larger" : "same"},
                     {"double_cross", numbers(at.q)}};
  expected.names = {{"\\vec u", quantity(at.u)}, {"\\vec v", quantity(at.v)}, {"\\vec w", quantity(at.w)},
                    {"\\vec n", quantity(at.n)}, {"\\vec p", quantity(at.p)}, {"\\vec q", quantity(at.q)},
                    {"D", quantity(at.D)},       {"V", quantity(volume)},     {"T", quantity(volume / 6)}};
  if (nn != 0) {
    expected.values["height"] = SignedSquares{signedSquare(volume, nn)};
    expected.names["h"] = quantityOverRoot(at.D, nn);
  }
  addVanished(at, expected.vanished);
  return expected;
}

/// A line whose result is a vector.
class VectorLine {
public:
  VectorLine(const char *id, const ExactVec3 &right, std::vector<WrongAnswer> &all)
      : m_id(id), m_right(right), m_all(all) {}

  void add(const char *how, const ExactVec3 &wrong) {
    if (wrong != m_right)
      m_all.push_back(
          {m_id, how, "(" + toText(wrong.x) + ", " + toText(wrong.y) + ", " + toText(wrong.z) + ")"});
  }

private:
  const char *m_id;
  ExactVec3 m_right;
  std::vector<WrongAnswer> &m_all;
};

void addHeight(std::vector<WrongAnswer> &all, const Three &at) {
  const Rational nn = times(at.n, at.n);
  Line line("height", Surd::root(nn, Rational(at.D / nn)), all);
  line.add("not divided", at.D);
  line.addRatio("divided by n·n", at.D, nn);
  line.addOverRoot("divided by |w|", at.D, times(at.w, at.w));
  line.addOverRoot("the sign lost", Rational(-at.D), nn);
  line.add("the length of w", Surd::root(times(at.w, at.w)));
}

/// The coordinate of the vector times its small determinant, with the signs of the last column.
void addExpansion(std::vector<WrongAnswer> &all, const Three &at) {
  const auto products = productsOf(at.w, at.n);
  Line line("expansion", at.D, all);
  line.add("the middle sign forgotten", Rational(at.D - 2 * products[1]));
  line.add("the last part subtracted", Rational(at.D - 2 * products[2]));
  line.add("all signs turned", Rational(-at.D));
  for (const Rational &product : products)
    line.add("one part dropped", Rational(at.D - product));
}

void addSix(std::vector<WrongAnswer> &all, const Three &at) {
  Line line("six", at.D, all);
  Rational sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational falls = at.u[i] * at.v[(i + 1) % 3] * at.w[(i + 2) % 3];
    const Rational rises = at.u[i] * at.v[(i + 2) % 3] * at.w[(i + 1) % 3];
    sum += falls + rises;
    line.add("a product with plus dropped", Rational(at.D - falls));
    line.add("a product with minus dropped", Rational(at.D + rises));
    line.add("a product added that is to be subtracted", Rational(at.D + 2 * rises));
  }
  line.add("all added", sum);
}

void addRule(std::vector<WrongAnswer> &all, const Three &at) {
  const Rational uv = times(at.u, at.v);
  const Rational uw = times(at.u, at.w);
  VectorLine line("rule", at.q, all);
  line.add("the dot products exchanged", at.v * uv - at.w * uw);
  line.add("the sign lost", -at.q);
  line.add("added", at.v * uw + at.w * uv);
  line.add("one part alone", at.v * uw);
  line.add("the other parentheses", perpendicular(at.n, at.w));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Three at(objects);
  std::vector<WrongAnswer> all;
  if (at.D == 0)
    return all;
  addCross(all, "n", at.u, at.v);
  addCross(all, "p", at.v, at.w);
  addCross(all, "q", at.u, at.p);
  VectorLine("q", at.q, all).add("the other parentheses", perpendicular(at.n, at.w));
  addLength(all, "area", at.n);
  addHeight(all, at);
  addProduct(all, "det", at.n, at.w);
  Line("volume", abs(at.D), all).add("the sign kept", at.D);
  addProduct(all, "swapped", ExactVec3(-at.n), at.w);
  addProduct(all, "moved-on", at.p, at.u);
  addExpansion(all, at);
  addSix(all, at);
  Line tetrahedron("tetrahedron", Rational(abs(at.D) / 6), all);
  addFraction(tetrahedron, abs(at.D), 6);
  tetrahedron.add("a third", Rational(abs(at.D) / 3));
  tetrahedron.add("a half", Rational(abs(at.D) / 2));
  addRule(all, at);
  return all;
}

} // namespace

namespace expected {

Expected determinant() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
