// Where a ray meets a triangle, by Cramer's rule with two cross products that four determinants share (note
// CG). The ray's parameter is λ here, as in the method of perps; the corners, r, s and t in the note, keep
// their letters.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<RayObject> L;
};

struct Out : Naming, TriangleTerms, RayTerms {
  RayTriangleCramer<Rational> meet;
  Term a, b, c;       ///< the columns beside r: from P1, P2 and Q to P0
  Term p, q;          ///< b×r and a×c
  Term D, D1, D2, D3; ///< |a b r|, and with c for its first, second and third column
  Term sigma, tau, lambda, I;
};

Out compute(const In &in) {
  const auto &[p0, p1, p2] = in.T.object;
  const auto &[origin, direction] = in.L.object;
  const auto meet =
      intersectRayTriangleCramer(Ray<Rational>{origin, direction}, Triangle<Rational>{p0, p1, p2});
  const ExactVec3 a = p0 - p1;
  const ExactVec3 b = p0 - p2;
  const ExactVec3 c = p0 - origin;
  return {in,
          termsOf(in.T),
          termsOf(in.L),
          meet,
          name(in.own(vectorLetter("a")), a).marked(in.mark("a")),
          name(in.own(vectorLetter("b")), b).marked(in.mark("b")),
          name(in.own(vectorLetter("c")), c).marked(in.mark("c")),
          name(in.own(vectorLetter("p")), cross(b, direction)).marked(in.mark("p")),
          name(in.own(vectorLetter("q")), cross(a, c)).marked(in.mark("q")),
          name(in.own(letter("D")), meet.det),
          name(in.own(letter("D", "1")), meet.detSigma),
          name(in.own(letter("D", "2")), meet.detTau),
          name(in.own(letter("D", "3")), meet.detT),
          name(in.own(letter("σ")), meet.sigma),
          name(in.own(letter("τ")), meet.tau),
          name(in.own(letter("λ")), meet.t),
          madeName(in, "I", ExactVec3(origin + direction * meet.t))};
}

CaseWords tell(const In &in, const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const std::string place = placeWords(at.meet.location, at);
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName,
            words("The ray hits {place}, at {lambda}.", {{"place", place}, {"lambda", equation(at.lambda)}})};
  case RayTriangleCase::Behind:
    return {caseName, words("{lambda} is negative: the triangle is behind the ray's start. Only the line "
                            "backwards meets it, {place}.",
                            {{"place", place}, {"lambda", equation(at.lambda)}})};
  case RayTriangleCase::Miss:
    return {caseName,
            words("The line meets the triangle's plane outside the triangle: {sigma}, {tau}, {sum}.",
                  {{"sigma", equation(at.sigma)},
                   {"tau", equation(at.tau)},
                   {"sum", equation(at.sigma + at.tau)}})};
  case RayTriangleCase::Parallel:
    return {caseName, words("D = 0, but not D₃: the ray runs parallel to the triangle's plane and never "
                            "meets it.")};
  case RayTriangleCase::InPlane:
    return {caseName, words("D = 0 and D₃ = 0: the ray lies in the triangle's plane, and no single point is "
                            "the hit.")};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {caseName,
            words("{same}: this is no triangle, and D is 0.", {{"same", coincidentWords(in.T.object, at)}}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: two columns are multiples of each other, and D is 0.",
                at.letters),
          true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values;
  if (at.meet.crosses()) {
    values.push_back({"location", words("place"), std::string(nameOf(at.meet.location.part))});
    if (at.meet.location.feature >= 0)
      values.push_back({"feature", {}, at.meet.location.feature});
    values.push_back(listed("t", at.lambda));
    values.push_back(listed("point", at.I));
    values.push_back(listed("barycentric", list({1 - at.sigma - at.tau, at.sigma, at.tau})));
  }
  values.push_back({"cramer",
                    {},
                    std::vector<NamedValue>{listed("det", at.D), listed("det_sigma", at.D1),
                                            listed("det_tau", at.D2), listed("det_t", at.D3)}});
  return values;
}

std::vector<MadeObject> make(const In &in, const Out &at) {
  if (!at.meet.crosses())
    return {};
  const auto &[origin, direction] = in.L.object;
  return {{"I", PointObject{origin + direction * at.meet.t}}};
}

void addColumnLines(const Out &at, Explanation &lines) {
  lines.add("a", [&at] {
    return asked(withNumbers(at.a == at.P0 - at.P1), words("From {P1} to {P0}.", at.letters));
  });
  lines.add("b", [&at] {
    return asked(withNumbers(at.b == at.P0 - at.P2), words("From {P2} to {P0}.", at.letters));
  });
  lines.add("c", [&at] {
    return asked(withNumbers(at.c == at.P0 - at.Q), words("From {Q} to {P0}.", at.letters));
  });
}

/// D by the cofactors of its first column.
WorkingLine expansionLine(const Out &at) {
  const Term whole = determinant(3, {at.a, at.b, at.r});
  return asked(
      (at.D == whole).then(columnsPutIn(whole)).then(expandedAlong(whole, 0)).then(calculated(whole)),
      words("By its first column: each number of a times what is left without its row and column. Signs: "
            "plus, minus, plus."));
}

/// A cross product that two determinants share.
WorkingLine sharedLine(const Term &shared, const Term &first, const Term &second, std::string sentence) {
  return asked(withProducts(shared == cross(first, second)), std::move(sentence),
               {{cross(second, first), words("{answer} is the cross product the other way round.")}});
}

WorkingLine determinantLine(const Out &at) {
  return asked(
      withProducts(at.D == dot(at.a, at.p)),
      at.meet.det == 0
          ? words("Zero: there is nothing to divide by, so no single point is the answer.")
          : words("The small determinants are the coordinates of p, with the signs already in them."),
      {{-at.D, words("{answer} has the wrong sign.")}});
}

void addDeterminantLines(const Out &at, Explanation &lines) {
  lines.add("expansion", [&at] { return expansionLine(at); });
  lines.add("p", [&at] {
    return sharedLine(at.p, at.b, at.r, words("The first cross product that is used twice."));
  });
  lines.add("det", [&at] { return determinantLine(at); });
  lines.add("det-sigma", [&at] {
    return asked(withProducts((at.D1 == determinant(3, {at.c, at.b, at.r})) == dot(at.c, at.p)),
                 words("c in the place of a: p is there already."),
                 {{-at.D1, words("{answer} has the wrong sign.")}});
  });
  lines.add("q", [&at] {
    return sharedLine(at.q, at.a, at.c, words("The second cross product that is used twice."));
  });
  lines.add("det-tau", [&at] {
    return asked(withProducts((at.D2 == determinant(3, {at.a, at.c, at.r})) == dot(at.r, at.q)),
                 words("c in the place of b. Here the last column is split off: {r}.", at.letters),
                 {{-at.D2, words("{answer} has the wrong sign.")}});
  });
  lines.add("det-t", [&at] {
    return asked(
        withProducts((at.D3 == determinant(3, {at.a, at.b, at.c})) == -dot(at.b, at.q)),
        words("c in the place of {r}. The middle column is split off, and that one comes with a minus.",
              at.letters),
        {{-at.D3, words("{answer} is b·q: a middle column comes with a minus.")}});
  });
}

/// `wrong` is the share with another numerator.
WorkingLine shareLine(const Out &at, const Term &share, const Term &numerator, const Term &other,
                      std::string sentence) {
  return asked(withNumbers(share == numerator / at.D), std::move(sentence),
               {{other / at.D, words("{answer} has the wrong determinant above.")}});
}

WorkingLine placeLine(const Out &at) {
  return line(
      {withResult(1 - at.sigma - at.tau), withResult(at.sigma), withResult(at.tau)},
      words("These are the weights of {P0}, {P1} and {P2}. The line of the ray meets the plane {place}.",
            at.letters, {{"place", placeWords(at.meet.location, at)}}));
}

std::string parameterWords(const Out &at) {
  return at.meet.t < 0
             ? words("Negative: the line gets there before the ray's start {Q}, so the ray does not hit.",
                     at.letters)
             : words("Not negative: the ray itself gets there.");
}

void addAnswerLines(const Out &at, Explanation &lines) {
  lines.add("sigma", [&at] {
    return shareLine(at, at.sigma, at.D1, at.D2, words("The weight of {P1}.", at.letters));
  });
  lines.add("tau",
            [&at] { return shareLine(at, at.tau, at.D2, at.D1, words("The weight of {P2}.", at.letters)); });
  lines.add("place", [&at] { return placeLine(at); });
  lines.add("t", [&at] { return shareLine(at, at.lambda, at.D3, at.D1, parameterWords(at)); });
  lines.add("hit", [&at] {
    return asked(withNumbers(at.I == at.Q + at.lambda * at.r),
                 words("Where the line of the ray meets the triangle's plane."));
  });
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  addColumnLines(at, lines);
  addDeterminantLines(at, lines);
  if (at.meet.crosses())
    addAnswerLines(at, lines);
  return lines;
}

/// The cross products are drawn this long in every picture: only their directions matter.
constexpr double drawnProductLength = 2.5;

void drawProduct(Figure &figure, const Term &product, const Place &from, Subject subject) {
  if (const ExactVec3 direction = vectorOf(product); !isZero(direction))
    figure.add(arrowOfLength(drawn(product, Role::Derived, subject), from, direction, drawnProductLength));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  figure.add(arrowOf(at.a, place(at.P1), Role::Given, Subject::EdgeU));
  figure.add(arrowOf(at.b, place(at.P2), Role::Given, Subject::EdgeV));
  figure.add(arrowOf(at.c, place(at.Q), Role::Derived, Subject::Point));
  drawProduct(figure, at.p, place(at.P2), Subject::Measure);
  drawProduct(figure, at.q, place(at.P1), Subject::Plane);
  if (!at.meet.crosses())
    return figure;
  const Place point = place(at.I);
  if (at.meet.t >= 0)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{at.I->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  const bool hit = at.meet.which == RayTriangleCase::Hit;
  figure.add(pointOf(at.I, hit ? Role::Result : Role::Ghost, Subject::Ray));
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  return rayTriangleNearby(in.T.object, in.L.object, at, at);
}

} // namespace

Construction ray_triangle_cramer() {
  return makeConstruction<In, Out, TriangleObject, RayObject>(
      "ray-triangle-cramer", {"T", "L"}, {{"I", "point"}},
      {"a", "b", "c", "p", "q", "D", "D1", "D2", "D3", "σ", "τ", "λ"},
      {.cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = {named::word("location", {"interior", "edge", "vertex", "outside"}), named::index("feature"),
                  named::number("t"), named::vector("point"), named::list("barycentric", 3),
                  named::group("cramer", {named::number("det"), named::number("det_sigma"),
                                          named::number("det_tau"), named::number("det_t")})},
       .lines = {"a", "b", "c", "expansion", "p", "det", "det-sigma", "q", "det-tau", "det-t", "sigma", "tau",
                 "place", "t", "hit"},
       .marks = {"a", "b", "c", "p", "q", "I"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
