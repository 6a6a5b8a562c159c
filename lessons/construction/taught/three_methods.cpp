// One ray and one triangle by three methods beside each other: u⊥ and v⊥ (note PG 6.2), Cramer's rule (CG)
// and Plücker products (PL). What the methods have in common has one letter and one mark, so it has one
// colour; what each of them costs is counted in the very formulas of its lines.
//
// Long because these are three calculations in full, step by step, and what each of them costs.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "geometry/intersect_ray_triangle_plucker.h"
#include "lessons/construction/parts/calculation.h"
#include "lessons/construction/parts/product_signs.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/taught.h"

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

struct Out : RayByPerps {
  using RayByPerps::RayByPerps;

  RayTriangleCramer<Rational> cramer = intersectRayTriangleCramer(ray, triangle);
  RayTrianglePlucker<Rational> pluecker = intersectRayTrianglePlucker(ray, triangle);
  bool isRay = !isZero(ray.direction);

  Term c = drawnName(vectorLetter("c"), ExactVec3(triangle.p0 - ray.origin));

  // Of the method of perps; G is its denominator u·v⊥, which belongs to the triangle alone.
  Term vPerp = ownName(perpLetter("v"), perps.vPerp).marked(mark("vperp"));
  Term G = ownName(letter("G"), perps.denominator);
  Term w = drawnName(vectorLetter("w"), meet.w);
  // The numbers r·n and c·n, in the colours of the letters that are the same in other ways.
  Term along = dot(r, n).marked(n->mark);
  Term toPlane = dot(c, n).marked(c->mark);

  // Of Cramer's rule: two shared cross products, v×r and c×u, and the determinants that they lead to. D has
  // the colour of the normal, because it is r·n, and D3 that of c, because it is c·n.
  Term p = ownName(vectorLetter("p"), ExactVec3(cross(perps.v, ray.direction)));
  Term q = ownName(vectorLetter("q"), ExactVec3(cross(vectorOf(c), perps.u)));
  Term D = ownName(letter("D"), cramer.det).marked(n->mark);
  Term D1 = ownName(letter("D", "1"), cramer.detSigma);
  Term D2 = ownName(letter("D", "2"), cramer.detTau);
  Term D3 = ownName(letter("D", "3"), cramer.detT).marked(c->mark);

  // Of Plücker: the moments of the ray's line and of the edges, the products with the edges, their sum. All
  // of edge i are those of the edge opposite to the corner i, as in the eval format. Edge 0 is e, from P1 to
  // P2; the two others are u and −v.
  Term m = ownName(vectorLetter("m"), ExactVec3(cross(ray.origin, ray.direction)));
  Term e = ownName(vectorLetter("e"), ExactVec3(triangle.p2 - triangle.p1));
  std::array<Term, 3> moments{ownName(vectorLetter("m", "0"), ExactVec3(cross(triangle.p1, triangle.p2))),
                              ownName(vectorLetter("m", "1"), ExactVec3(cross(triangle.p2, triangle.p0))),
                              ownName(vectorLetter("m", "2"), ExactVec3(cross(triangle.p0, triangle.p1)))};
  std::array<Term, 3> products{drawnName(letter("p", "0"), pluecker.products.at(0)),
                               drawnName(letter("p", "1"), pluecker.products.at(1)),
                               drawnName(letter("p", "2"), pluecker.products.at(2))};
  Term S = ownName(letter("S"), pluecker.sum).marked(n->mark);

  /// Steps, made when the first of their lines is looked at.
  [[nodiscard]] const Steps &kept(Steps (*steps)(const Out &)) const {
    auto found = m_kept.find(steps);
    if (found == m_kept.end())
      found = m_kept.emplace(steps, steps(*this)).first;
    return found->second;
  }
  mutable std::map<Steps (*)(const Out &), Steps> m_kept{};
};

CaseWords tellCrossing(const Out &at) {
  const WordValues lambda{{"lambda", equation(at.lambda)}};
  const std::string caseName(nameOf(at.meet.which));
  if (at.meet.which == RayTriangleCase::Hit)
    return {caseName,
            placeWords(at.meet.location, at,
                       {says("All three ways lead to the same hit: inside the triangle, at {lambda}."),
                        says("All three ways lead to the same hit: on the edge {edge}, at {lambda}."),
                        says("All three ways lead to the same hit: at the corner {corner}, at {lambda}.")},
                       lambda)};
  if (at.meet.which == RayTriangleCase::Behind)
    return {
        caseName,
        placeWords(at.meet.location, at,
                   {says("The line of the ray goes through the inside of the triangle. But {lambda} is "
                         "negative: that is behind the ray's start. The Plücker products cannot see it."),
                    says("The line of the ray goes through the edge {edge} of the triangle. But {lambda} is "
                         "negative: that is behind the ray's start. The Plücker products cannot see it."),
                    says("The line of the ray goes through the corner {corner} of the triangle. But {lambda} "
                         "is negative: that is behind the ray's start. The Plücker products cannot see it.")},
                   lambda)};
  return {caseName,
          words("All three ways find the same point, and it is outside the triangle: {s}, {t}, {sum}.",
                {{"s", equation(at.s)}, {"t", equation(at.t)}, {"sum", equation(at.s + at.t)}})};
}

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
  case RayTriangleCase::Behind:
  case RayTriangleCase::Miss:
    return tellCrossing(at);
  case RayTriangleCase::Parallel:
    return {caseName,
            words("{r}·n, D and S are 0: the ray runs parallel to the triangle's plane. Two ways "
                  "have nothing to divide by; the signs of the products say that it passes outside.",
                  at.letters)};
  case RayTriangleCase::InPlane:
    return {caseName,
            words("{r}·n, D and all three products are 0: the ray lies in the triangle's plane, and "
                  "none of the three ways has a single point to give.",
                  at.letters)};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {caseName,
            coincidentWords(at.in.T.object, at,
                            {says("{first} and {second} are the same point: this is no triangle. G, D and S "
                                  "are 0, whatever the ray does."),
                             says("{first}, {second} and {third} are the same point: this is no triangle. G, "
                                  "D and S are 0, whatever the ray does.")}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: G, D and S are 0, whatever the ray does.", at.letters),
          true};
}

// The three ways, each as the steps that a program would go. The worked lines show them, and the counts are
// theirs.

Steps sideSteps(const Out &at) {
  return {{at.u == at.P1 - at.P0},
          {at.v == at.P2 - at.P0, words("Two sides of the triangle, both from {P0}.", at.letters)}};
}

Step startStep(const Out &at) { return {at.c == at.P0 - at.Q, words("From {Q} to {P0}.", at.letters)}; }

Step crossStep(const Term &product, const Term &a, const Term &b, std::string sentence = {}) {
  return {product == cross(a, b),
          std::move(sentence),
          {{cross(b, a), words("{answer} is the cross product the other way round.")}},
          Needs::Nothing,
          withProducts};
}

// The two shares by the perps: s and t.
Term shareS(const Out &at) { return dot(at.w, at.vPerp) / dot(at.u, at.vPerp); }
Term shareT(const Out &at) { return dot(at.w, at.uPerp) / dot(at.v, at.uPerp); }

Steps perpSteps(const Out &at) {
  const auto &[u, v, w, G] = std::tie(at.u, at.v, at.w, at.G);
  return {
      startStep(at),
      crossStep(at.n, u, v, crossProductWords(at.n)),
      {at.lambda == at.toPlane / at.along,
       words("First the plane: so many steps {r} lead from {Q} to it.", at.letters),
       {{-(at.toPlane / at.along),
         words("{answer} has the wrong sign: c leads from {Q} to the plane.", at.letters)}},
       Needs::Denominator},
      {at.I == at.Q + at.lambda * at.r,
       words("The point of the plane. Is it in the triangle?"),
       {},
       Needs::Point},
      {w == at.I - at.P0, words("From {P0} to {I}.", at.letters), {}, Needs::Point},
      {(G == dot(u, at.vPerp)) == power(dot(u, v), 2) - dot(u, u) * dot(v, v),
       at.isTriangle
           ? words("It belongs to the triangle alone, and is 0 only when that has no area.")
           : words("Zero: u and v lie on one line. There is nothing to divide by, whatever the ray does."),
       {{-G, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}}},
      {(at.s == shareS(at)) == (dot(u, v) * dot(w, v) - dot(v, v) * dot(w, u)) / G,
       words("v⊥ cannot see v: only s is left."),
       {{at.t, words("{answer} is t: for s, take the dot product with v⊥.")}},
       Needs::Point},
      {(at.t == shareT(at)) == (dot(u, v) * dot(w, u) - dot(u, u) * dot(w, v)) / G,
       words("u⊥ cannot see u: only t is left."),
       {{at.s, words("{answer} is s: for t, take the dot product with u⊥.")}},
       Needs::Point}};
}

/// What the way calculates without, by dot products alone.
Steps perpVectors(const Out &at) {
  const auto &[u, v, n] = std::tie(at.u, at.v, at.n);
  return {{(at.uPerp == cross(n, u)) == dot(u, u) * v - dot(u, v) * u,
           perpWords(at.uPerp, words("In the triangle's plane, perpendicular to u."))},
          {(at.vPerp == cross(n, v)) == dot(u, v) * v - dot(v, v) * u,
           perpWords(at.vPerp, words("Likewise, perpendicular to v."))}};
}

std::string determinantWords(const Out &at) {
  if (!at.isRay)
    return zeroWithoutRay(at);
  return at.cramer.det == 0
             ? words("Zero: nothing to divide by. Either the line of the ray does not cross the plane, or "
                     "there is no triangle.")
             : words("Not zero: there is exactly one answer.");
}

/// A determinant, and what a shared cross product makes of it.
Step determinantStep(const Term &letter, const Term &whole, const Term &shared, std::string sentence) {
  return {(letter == whole) == shared,
          std::move(sentence),
          {{-letter, words("{answer} has the wrong sign.")}},
          Needs::Nothing,
          withProducts};
}

/// `numerator` over D; the slip takes the other one.
Step shareStep(const Out &at, const Term &share, const Term &numerator, const Term &other) {
  return {share == numerator / at.D,
          {},
          {{other / at.D, words("{answer} has the wrong determinant above.")}},
          Needs::Denominator};
}

Steps cramerSteps(const Out &at) {
  const auto &[u, v, c, r] = std::tie(at.u, at.v, at.c, at.r);
  return {crossStep(at.p, v, r, words("Used in two determinants.")),
          crossStep(at.q, c, u, words("Used in the two others.")),
          determinantStep(at.D, determinant(3, {u, v, r}), dot(u, at.p), determinantWords(at)),
          determinantStep(at.D1, -determinant(3, {c, v, r}), -dot(c, at.p), words("c in the place of u.")),
          determinantStep(at.D2, -determinant(3, {u, c, r}), dot(r, at.q), words("c in the place of v.")),
          determinantStep(at.D3, determinant(3, {u, v, c}), dot(v, at.q),
                          words("c in the place of {r}.", at.letters)),
          shareStep(at, at.s, at.D1, at.D2),
          shareStep(at, at.t, at.D2, at.D1),
          shareStep(at, at.lambda, at.D3, at.D1)};
}

/// The ends of the edge opposite to a corner, P₁P₂.
std::pair<Term, Term> oppositeEdge(const Out &at, std::size_t corner) {
  const std::array corners{at.P0, at.P1, at.P2};
  return {corners.at((corner + 1) % 3), corners.at((corner + 2) % 3)};
}

/// d₁·m₂ + d₂·m₁ of the ray and an edge, with the edge's part as a summand, which may have a minus.
Step productStep(const Out &at, std::size_t i, const Term &edgePart) {
  const Term &product = at.products.at(i);
  const Term rayPart = dot(at.r, at.moments.at(i));
  const auto [from, to] = oppositeEdge(at, i);
  return {
      product == rayPart + edgePart,
      words("With the edge {edge}, opposite to its corner.", {{"edge", edgeName(from->symbol, to->symbol)}}),
      {{rayPart - edgePart, words("{answer} has the wrong sign in the second product.")},
       {-product, words("{answer} has the wrong sign.")}}};
}

std::string sumWords(const Out &at) {
  return at.pluecker.sum == 0 ? words("Zero, as {r}·n is: no single point can be mixed.", at.letters)
                              : words("All products together.");
}

/// λ of the point that the corners are mixed to.
Term lambdaOfPoint(const Out &at) { return dot(at.I - at.Q, at.r) / dot(at.r, at.r); }

Steps plueckerSteps(const Out &at) {
  const auto &[P0, P1, P2, m, S] = std::tie(at.P0, at.P1, at.P2, at.m, at.S);
  const auto &[p0, p1, p2] = at.products;
  return {{at.e == P2 - P1, words("The third side.")},
          crossStep(m, at.Q, at.r, words("The moment of the ray's line.")),
          crossStep(at.moments[0], P1, P2),
          crossStep(at.moments[1], P2, P0),
          crossStep(at.moments[2], P0, P1, words("The moments of the three edges.")),
          productStep(at, 0, dot(at.e, m)),
          productStep(at, 1, -dot(at.v, m)),
          productStep(at, 2, dot(at.u, m)),
          {S == p0 + p1 + p2, sumWords(at)},
          {at.s == p1 / S, {}, {}, Needs::Denominator},
          {at.t == p2 / S, {}, {}, Needs::Denominator},
          {at.I == (1 - at.s - at.t) * P0 + at.s * P1 + at.t * P2,
           words("The corners, mixed. No normal was needed."),
           {},
           Needs::Point},
          {at.lambda == lambdaOfPoint(at),
           words("Only now the ray's own parameter, which the products do not have."),
           {},
           Needs::Point}};
}

/// A way as a program goes it, which begins with the sides, and with c where that is not there already.
Steps perpWay(const Out &at) { return joined<Step>({sideSteps(at), perpSteps(at)}); }
Steps cramerWay(const Out &at) { return joined<Step>({sideSteps(at), {startStep(at)}, cramerSteps(at)}); }
Steps plueckerWay(const Out &at) { return joined<Step>({sideSteps(at), plueckerSteps(at)}); }

/// What a way costs: once for a triangle, and again for each new ray.
Cost costOfWay(const Out &at, Steps (*way)(const Out &)) { return costOf(way(at), {at.Q, at.r}); }

/// Multiplications for the triangle and for each ray, additions and divisions.
ValueRow<Out> costRow(const char *name, Steps (*way)(const Out &)) {
  return {named::list(name, 4), always, [way](const Out &at) {
            const Cost cost = costOfWay(at, way);
            return Value(std::vector<Surd>{cost.once.multiplications, cost.eachTime.multiplications,
                                           cost.all().additions, cost.all().divisions});
          }};
}

/// Which way the corners go around, for somebody whom r points at.
Word windingOf(const Out &at) {
  const Rational &along = at.cramer.det;
  return along > 0   ? Word{"counterclockwise", words("counterclockwise")}
         : along < 0 ? Word{"clockwise", words("clockwise")}
                     : Word{"none", words("none")};
}

ValueTable<Out> values() {
  const ValueTable<Out> ways{
      {named::word("winding", {"counterclockwise", "clockwise", "none"}), always,
       [](const Out &at) { return ToldValue(words("sense of the corners"), windingOf(at)); }},
      valueGroup<Out>(
          "perp", always,
          {{named::number("denominator"), always, &Out::G}, {named::number("along"), always, &Out::along}}),
      cramerRow<Out>(),
      valueGroup<Out>("plucker", always,
                      {{named::vector("products"), always,
                        [](const Out &at) {
                          return list({at.products.begin(), at.products.end()});
                        }},
                       {named::number("sum"), always, &Out::S},
                       signsRow<Out>([](const Out &at) { return signsOf(at.pluecker.products); })}),
      valueGroup<Out>(
          "cost", always,
          {costRow("perp", perpWay), costRow("cramer", cramerWay), costRow("plucker", plueckerWay)})};
  return joined<ValueRow<Out>>({crossingRows<Out>([](const Out &at) { return at.meet.location; }),
                                shareRows<Out>(),
                                {barycentricRow<Out>(&Out::crosses, &Out::s, &Out::t)},
                                ways});
}

/// The lines of steps, by their ids.
LineTable<Out> linesOf(const std::vector<std::string> &ids, Steps (*steps)(const Out &)) {
  LineTable<Out> table;
  for (std::size_t i = 0; i < ids.size(); ++i)
    table.push_back(
        {ids[i],
         [i, steps](const Out &at) { return at.crosses || at.kept(steps).at(i).needs != Needs::Point; },
         [i, steps](const Out &at) { return lineOf(at.kept(steps).at(i), at.crosses); }});
  return table;
}

/// The multiplications of a way: for the triangle, and for each ray. They come from the formulas, not from
/// coordinates, so no number of the line is a result that could be asked for or traced.
WorkingLine countLine(const Out &at, const char *index, const Cost &cost) {
  const Operations all = cost.all();
  const Term count = at.ownName(letter("N", index), Rational(all.multiplications));
  return line(
      (count == Term(cost.once.multiplications) + Term(cost.eachTime.multiplications)) == all.multiplications,
      words(
          "{once} multiplications belong to the triangle alone and can be kept, {ray} are new for each ray. "
          "Besides: {additions} additions and {divisions} divisions.",
          {{"once", std::to_string(cost.once.multiplications)},
           {"ray", std::to_string(cost.eachTime.multiplications)},
           {"additions", std::to_string(all.additions)},
           {"divisions", std::to_string(all.divisions)}}));
}

std::string signsWords(const Out &at) {
  if (!at.isRay)
    return allZeroWithoutRay(at);
  switch (signsOf(at.pluecker.products)) {
  case ProductSigns::Same:
    return at.meet.which == RayTriangleCase::Behind
               ? words("No two differ in sign: the line of the ray goes through the triangle. The products "
                       "do not know where the ray starts.")
               : words("No two differ in sign: the line of the ray goes through the triangle.");
  case ProductSigns::Mixed:
    return words("Two differ in sign: the line of the ray passes outside. Nothing was divided.");
  case ProductSigns::Zero:
    break;
  }
  return words("All are 0: the line of the ray and the corners lie in one plane.");
}

// What is the same in the methods, each time in one line.

WorkingLine numeratorsLine(const Out &at) {
  return line(
      {withResult(at.D1 == at.products[1]), withResult(at.D2 == at.products[2]),
       withResult(at.D3 == at.toPlane)},
      words("Two determinants are products with edges, the third is a dot product of the first way."));
}

WorkingLine signsLine(const Out &at) {
  const auto &[p0, p1, p2] = at.products;
  return resultsLine({p0, p1, p2}, signsWords(at));
}

Steps denominators(const Out &at) {
  return {{(at.along == at.D) == at.S,
           at.cramer.det == 0 ? words("One number in all three ways, and it is 0.")
                              : words("One number in all three ways."),
           {},
           Needs::Nothing,
           withResult}};
}

Steps agreement(const Out &at) {
  const auto &[p0, p1, p2] = at.products;
  const auto agree = [](const Chain &chain, std::string sentence) {
    return Step{chain, std::move(sentence), {}, Needs::Point, withResult};
  };
  return {
      agree(((at.s == shareS(at)) == at.D1 / at.D) == p1 / at.S, {}),
      agree(((at.t == shareT(at)) == at.D2 / at.D) == p2 / at.S, words("Three ways, the same two numbers.")),
      agree(((at.lambda == at.toPlane / at.along) == at.D3 / at.D) == lambdaOfPoint(at),
            at.meet.plane.t < 0 ? words("Negative: the ray does not get there.")
                                : words("Not negative: the ray gets there."))};
}

LineTable<Out> lines() {
  const auto count = [](const char *index, Steps (*way)(const Out &)) {
    return [index, way](const Out &at) { return countLine(at, index, costOfWay(at, way)); };
  };
  return joined<LineRow<Out>>(
      {linesOf({"u", "v"}, sideSteps),
       linesOf({"c", "normal", "perp-lambda", "hit", "w", "G", "perp-s", "perp-t"}, perpSteps),
       linesOf({"uperp", "vperp"}, perpVectors),
       linesOf({"p", "q", "D", "D1", "D2", "D3", "cramer-s", "cramer-t", "cramer-lambda"}, cramerSteps),
       linesOf({"e", "m", "m0", "m1", "m2", "p0", "p1", "p2", "S", "pluecker-s", "pluecker-t", "mix",
                "pluecker-lambda"},
               plueckerSteps),
       {{"perp-count", always, count("1", perpWay)},
        {"cramer-count", always, count("2", cramerWay)},
        {"pluecker-count", always, count("3", plueckerWay)}},
       linesOf({"denominators"}, denominators),
       {{"numerators", always, numeratorsLine}, {"signs", always, signsLine}},
       linesOf({"agree-s", "agree-t", "agree-lambda"}, agreement)});
}

/// In units of the picture: only the directions matter.
constexpr double drawnNormalLength = 2.5;
constexpr double drawnPerpLength = 3.5;

/// The edge opposite to a corner, in the colour of its product.
void drawEdge(Figure &figure, const Out &at, std::size_t corner, Subject subject) {
  const auto [from, to] = oppositeEdge(at, corner);
  figure.add(SegmentMark{drawn(at.products.at(corner), Role::Derived, subject), place(from), place(to)});
}

Figure draw(const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  const Role role = at.isTriangle ? Role::Given : Role::Warning;
  drawEdge(figure, at, 0, Subject::Measure);
  drawEdge(figure, at, 1, Subject::EdgeV);
  drawEdge(figure, at, 2, Subject::EdgeU);
  figure.add(arrowOf(at.u, p0, role, Subject::EdgeU));
  figure.add(arrowOf(at.v, p0, role, Subject::EdgeV));
  figure.add(arrowOf(at.c, place(at.Q), Role::Derived, Subject::Point));
  addDirection(figure, at.n, p0, drawnNormalLength, Role::Derived, Subject::Plane);
  addDirection(figure, at.uPerp, p0, drawnPerpLength, Role::Derived, Subject::EdgeU);
  addDirection(figure, at.vPerp, p0, drawnPerpLength, Role::Derived, Subject::EdgeV);
  if (!at.crosses)
    return figure;
  figure.add(wayToHit(at.w, p0));
  addMeeting(figure, at.in.L, at.I, at.meet.plane.t >= 0, at.meet.which == RayTriangleCase::Hit);
  return figure;
}

} // namespace

Construction three_methods() {
  return taught<Out, TriangleObject, RayObject>(
      {.id = "three-methods",
       .title = [] { return words("ray and triangle by three methods"); },
       .roles = {"T", "L"},
       .makes = {{"I", &Out::crosses, &Out::I}},
       .letters = {"u",  "v", "c",  "n",  "G",  "w", "s",  "t",  "λ",  "p", "q",  "D",  "D1", "D2",
                   "D3", "m", "m0", "m1", "m2", "e", "p0", "p1", "p2", "S", "N1", "N2", "N3"},
       .cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = values(),
       .lines = lines(),
       .marks = {"u", "v", "c", "n", "uperp", "vperp", "w", "p0", "p1", "p2", "I"},
       .tell = tell,
       .draw = draw,
       .nearby = rayTriangleNearby});
}

} // namespace halfspace
