// One ray and one triangle by three methods beside each other: u⊥ and v⊥ (note PG 6.2), Cramer's rule (CG)
// and Plücker products (PL). What the methods have in common has one letter and one mark, so it has one
// colour; what each of them costs is counted in the very formulas of its lines.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "geometry/intersect_ray_triangle_plucker.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/product_signs.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/operations.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<RayObject> L;
};

/// Of the method of perps; G is its denominator u·v⊥, which belongs to the triangle alone.
struct PerpTerms {
  Term n, uPerp, vPerp, G, w;
};

/// Of Cramer's rule: two shared cross products, v×r and c×u, and the determinants that they lead to.
struct CramerTerms {
  Term p, q, D, D1, D2, D3;
};

/// Of Plücker: the moments of the ray's line and of the edges, the products with the edges, their sum. All of
/// edge i are those of the edge opposite to the corner i, as in the eval format.
struct PlueckerTerms {
  Term m;
  Term e; ///< from P1 to P2; the two other edges are u and −v
  std::array<Term, 3> moments;
  std::array<Term, 3> products;
  Term S;
};

struct Out : Naming, TriangleTerms, RayTerms {
  RayTriangle<Rational> perps;
  RayTriangleCramer<Rational> cramer;
  RayTrianglePlucker<Rational> pluecker;
  Term u, v, c;
  Term s, t, lambda, I; ///< found by each of the methods
  PerpTerms first;
  CramerTerms second;
  PlueckerTerms third;

  [[nodiscard]] bool crosses() const { return perps.crosses(); }
  [[nodiscard]] bool isRay() const { return !isZero(vectorOf(r)); }
  [[nodiscard]] bool isTriangle() const { return perps.perps.denominator != 0; }
};

PerpTerms perpTermsOf(const In &in, const RayTriangle<Rational> &meet) {
  const auto &perps = meet.perps;
  return {name(in.own(vectorLetter("n")), perps.normal).marked(in.mark("n")),
          name(in.own(perpLetter("u")), perps.uPerp).marked(in.mark("uperp")),
          name(in.own(perpLetter("v")), perps.vPerp).marked(in.mark("vperp")),
          name(in.own(letter("G")), perps.denominator),
          name(in.own(vectorLetter("w")), meet.w).marked(in.mark("w"))};
}

/// D has the colour of the normal, because it is r·n, and D3 that of c, because it is c·n.
CramerTerms cramerTermsOf(const In &in, const RayTriangleCramer<Rational> &meet, const ExactVec3 &u,
                          const ExactVec3 &v, const ExactVec3 &c) {
  return {name(in.own(vectorLetter("p")), cross(v, in.L.object.direction)),
          name(in.own(vectorLetter("q")), cross(c, u)),
          name(in.own(letter("D")), meet.det).marked(in.mark("n")),
          name(in.own(letter("D", "1")), meet.detSigma),
          name(in.own(letter("D", "2")), meet.detTau),
          name(in.own(letter("D", "3")), meet.detT).marked(in.mark("c"))};
}

PlueckerTerms plueckerTermsOf(const In &in, const RayTrianglePlucker<Rational> &meet) {
  const auto &[p0, p1, p2] = in.T.object;
  const auto moment = [&](const char *index, const ExactVec3 &from, const ExactVec3 &to) {
    return name(in.own(vectorLetter("m", index)), ExactVec3(cross(from, to)));
  };
  const auto product = [&](const char *index, std::size_t i) {
    return name(in.own(letter("p", index)), meet.products.at(i)).marked(in.mark("p" + std::string(index)));
  };
  return {name(in.own(vectorLetter("m")), ExactVec3(cross(in.L.object.origin, in.L.object.direction))),
          name(in.own(vectorLetter("e")), ExactVec3(p2 - p1)),
          {moment("0", p1, p2), moment("1", p2, p0), moment("2", p0, p1)},
          {product("0", 0), product("1", 1), product("2", 2)},
          name(in.own(letter("S")), meet.sum).marked(in.mark("n"))};
}

Out compute(const In &in) {
  const auto &[p0, p1, p2] = in.T.object;
  const Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  const Triangle<Rational> triangle{p0, p1, p2};
  const auto perps = intersectRayTriangle(ray, triangle);
  const auto cramer = intersectRayTriangleCramer(ray, triangle);
  const auto pluecker = intersectRayTrianglePlucker(ray, triangle);
  const auto &[u, v] = std::pair(perps.perps.u, perps.perps.v);
  const ExactVec3 c = p0 - ray.origin;
  return {in,
          termsOf(in.T),
          termsOf(in.L),
          perps,
          cramer,
          pluecker,
          name(in.own(vectorLetter("u")), u).marked(in.mark("u")),
          name(in.own(vectorLetter("v")), v).marked(in.mark("v")),
          name(in.own(vectorLetter("c")), c).marked(in.mark("c")),
          name(in.own(letter("s")), perps.s),
          name(in.own(letter("t")), perps.tTriangle),
          name(in.own(letter("λ")), perps.plane.t),
          madeName(in, "I", perps.plane.point),
          perpTermsOf(in, perps),
          cramerTermsOf(in, cramer, u, v, c),
          plueckerTermsOf(in, pluecker)};
}

CaseWords tellCrossing(const Out &at) {
  const WordValues found{{"place", placeWords(at.perps.location, at)}, {"lambda", equation(at.lambda)}};
  const std::string caseName(nameOf(at.perps.which));
  if (at.perps.which == RayTriangleCase::Hit)
    return {caseName, words("All three ways lead to the same hit: {place}, at {lambda}.", found)};
  if (at.perps.which == RayTriangleCase::Behind)
    return {caseName, words("The line of the ray goes through the triangle, {place}. But {lambda} is "
                            "negative: that is behind the ray's start. The Plücker products cannot see it.",
                            found)};
  return {caseName,
          words("All three ways find the same point, and it is outside the triangle: {s}, {t}, {sum}.",
                {{"s", equation(at.s)}, {"t", equation(at.t)}, {"sum", equation(at.s + at.t)}})};
}

CaseWords tell(const In &in, const Out &at) {
  const std::string caseName(nameOf(at.perps.which));
  switch (at.perps.which) {
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
            words("{same}: this is no triangle. G, D and S are 0, whatever the ray does.",
                  {{"same", coincidentWords(in.T.object, at)}}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: G, D and S are 0, whatever the ray does.", at.letters),
          true};
}

// The three ways, each as the formulas that a program would calculate one after the other. The worked lines
// show these formulas, and the counts are theirs.

/// How a formula goes on behind its symbols.
enum class Numbers : std::uint8_t { PutIn, MultipliedOut };

/// What a step has only where the ray crosses the triangle's plane.
enum class Needs : std::uint8_t {
  Nothing,
  Denominator, ///< to divide by: else the line goes up to the division
  Point        ///< else there is no line
};

struct Step {
  std::string line; ///< the id
  Chain chain;      ///< its first side is the letter that it gives a value
  std::string sentence{};
  Numbers numbers = Numbers::PutIn;
  std::vector<WrongTerm> mistakes{};
  Needs needs = Needs::Nothing;
};

// The numbers r·n and c·n, in the colours of the letters that are the same in other ways.
Term alongNormal(const Out &at) { return dot(at.r, at.first.n).marked(at.first.n->mark); }
Term startToPlane(const Out &at) { return dot(at.c, at.first.n).marked(at.c->mark); }

std::vector<Step> sides(const Out &at) {
  return {{"u", at.u == at.P1 - at.P0},
          {"v", at.v == at.P2 - at.P0, words("Two sides of the triangle, both from {P0}.", at.letters)}};
}

Step fromStart(const Out &at) { return {"c", at.c == at.P0 - at.Q, words("From {Q} to {P0}.", at.letters)}; }

std::string denominatorWords(const Out &at) {
  return at.isTriangle()
             ? words("It belongs to the triangle alone, and is 0 only when that has no area.")
             : words("Zero: u and v lie on one line. There is nothing to divide by, whatever the ray does.");
}

Step crossStep(const char *line, const Term &product, const Term &a, const Term &b,
               std::string sentence = {}) {
  return {line,
          product == cross(a, b),
          std::move(sentence),
          Numbers::MultipliedOut,
          {{cross(b, a), words("{answer} is the cross product the other way round.")}}};
}

void addPerpSteps(const Out &at, std::vector<Step> &steps) {
  const auto &[n, uPerp, vPerp, G, w] = at.first;
  const auto &[u, v] = std::pair(at.u, at.v);
  steps.push_back(crossStep("normal", n, u, v, crossProductWords(n)));
  steps.push_back({"perp-lambda",
                   at.lambda == startToPlane(at) / alongNormal(at),
                   words("First the plane: so many steps {r} lead from {Q} to it.", at.letters),
                   Numbers::PutIn,
                   {{-(startToPlane(at) / alongNormal(at)),
                     words("{answer} has the wrong sign: c leads from {Q} to the plane.", at.letters)}},
                   Needs::Denominator});
  steps.push_back({"hit",
                   at.I == at.Q + at.lambda * at.r,
                   words("The point of the plane. Is it in the triangle?"),
                   Numbers::PutIn,
                   {},
                   Needs::Point});
  steps.push_back(
      {"w", w == at.I - at.P0, words("From {P0} to {I}.", at.letters), Numbers::PutIn, {}, Needs::Point});
  steps.push_back({"G",
                   (G == dot(u, vPerp)) == power(dot(u, v), 2) - dot(u, u) * dot(v, v),
                   denominatorWords(at),
                   Numbers::PutIn,
                   {{-G, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}}});
  steps.push_back(
      {"perp-s",
       (at.s == dot(w, vPerp) / dot(u, vPerp)) == (dot(u, v) * dot(w, v) - dot(v, v) * dot(w, u)) / G,
       words("v⊥ cannot see v: only s is left."),
       Numbers::PutIn,
       {{at.t, words("{answer} is t: for s, w is dotted with v⊥.")}},
       Needs::Point});
  steps.push_back(
      {"perp-t",
       (at.t == dot(w, uPerp) / dot(v, uPerp)) == (dot(u, v) * dot(w, u) - dot(u, u) * dot(w, v)) / G,
       words("u⊥ cannot see u: only t is left."),
       Numbers::PutIn,
       {{at.s, words("{answer} is s: for t, w is dotted with u⊥.")}},
       Needs::Point});
}

std::string determinantWords(const Out &at) {
  if (!at.isRay())
    return words("Zero, because {r} is the zero vector: there is no ray.", at.letters);
  return at.cramer.det == 0
             ? words("Zero: nothing to divide by. Either the ray is parallel, or there is no triangle.")
             : words("Not zero: there is exactly one answer.");
}

/// `numerator` over D; the slip takes the other one.
Step shareStep(const Out &at, const char *line, const Term &share, const Term &numerator, const Term &other) {
  return {line,
          share == numerator / at.second.D,
          {},
          Numbers::PutIn,
          {{other / at.second.D, words("{answer} has the wrong determinant above.")}},
          Needs::Denominator};
}

void addCramerSteps(const Out &at, std::vector<Step> &steps) {
  const auto &[p, q, D, D1, D2, D3] = at.second;
  const auto &[u, v] = std::pair(at.u, at.v);
  const auto add = [&](const char *line, const Term &letter, const Term &whole, const Term &shared,
                       std::string sentence) {
    steps.push_back({line,
                     (letter == whole) == shared,
                     std::move(sentence),
                     Numbers::MultipliedOut,
                     {{-letter, words("{answer} has the wrong sign.")}}});
  };
  steps.push_back(crossStep("p", p, v, at.r, words("Used in two determinants.")));
  steps.push_back(crossStep("q", q, at.c, u, words("Used in the two others.")));
  add("D", D, determinant(3, {u, v, at.r}), dot(u, p), determinantWords(at));
  add("D1", D1, -determinant(3, {at.c, v, at.r}), -dot(at.c, p), words("c in the place of u."));
  add("D2", D2, -determinant(3, {u, at.c, at.r}), dot(at.r, q), words("c in the place of v."));
  add("D3", D3, determinant(3, {u, v, at.c}), dot(v, q), words("c in the place of {r}.", at.letters));
  steps.push_back(shareStep(at, "cramer-s", at.s, D1, D2));
  steps.push_back(shareStep(at, "cramer-t", at.t, D2, D1));
  steps.push_back(shareStep(at, "cramer-lambda", at.lambda, D3, D1));
}

/// The edge opposite to a corner, P₁P₂, for people.
std::string oppositeEdge(const Out &at, std::size_t corner) {
  const std::array corners{&at.P0, &at.P1, &at.P2};
  return edgeName((*corners.at((corner + 1) % 3))->symbol, (*corners.at((corner + 2) % 3))->symbol);
}

/// d₁·m₂ + d₂·m₁ of the ray and an edge, with the edge's part as a summand, which may have a minus.
Step productStep(const Out &at, std::size_t i, const Term &edgePart, std::string sentence) {
  const auto &[m, e, moments, products, S] = at.third;
  const Term &product = products.at(i);
  return {"p" + std::to_string(i),
          product == dot(at.r, moments.at(i)) + edgePart,
          std::move(sentence),
          Numbers::PutIn,
          {{dot(at.r, moments.at(i)) - edgePart, words("{answer} has the wrong sign in the second product.")},
           {-product, words("{answer} has the wrong sign.")}}};
}

std::string sumWords(const Out &at) {
  return at.pluecker.sum == 0 ? words("Zero, as {r}·n is: no single point can be mixed.", at.letters)
                              : words("All products together.");
}

void addPlueckerSteps(const Out &at, std::vector<Step> &steps) {
  const auto &[m, e, moments, products, S] = at.third;
  const auto edge = [&](std::size_t i) {
    return words("With the edge {edge}, opposite to its corner.", {{"edge", oppositeEdge(at, i)}});
  };
  steps.push_back({"e", e == at.P2 - at.P1, words("The third side.")});
  steps.push_back(crossStep("m", m, at.Q, at.r, words("The moment of the ray's line.")));
  steps.push_back(crossStep("m0", moments[0], at.P1, at.P2));
  steps.push_back(crossStep("m1", moments[1], at.P2, at.P0));
  steps.push_back(crossStep("m2", moments[2], at.P0, at.P1, words("The moments of the three edges.")));
  steps.push_back(productStep(at, 0, dot(e, m), edge(0)));
  steps.push_back(productStep(at, 1, -dot(at.v, m), edge(1)));
  steps.push_back(productStep(at, 2, dot(at.u, m), edge(2)));
  steps.push_back({"S", S == products[0] + products[1] + products[2], sumWords(at)});
  steps.push_back({"pluecker-s", at.s == products[1] / S, {}, Numbers::PutIn, {}, Needs::Denominator});
  steps.push_back({"pluecker-t", at.t == products[2] / S, {}, Numbers::PutIn, {}, Needs::Denominator});
  steps.push_back({"mix",
                   at.I == (1 - at.s - at.t) * at.P0 + at.s * at.P1 + at.t * at.P2,
                   words("The corners, mixed. No normal was needed."),
                   Numbers::PutIn,
                   {},
                   Needs::Point});
  steps.push_back({"pluecker-lambda",
                   at.lambda == dot(at.I - at.Q, at.r) / dot(at.r, at.r),
                   words("Only now the ray's own parameter, which the products do not have."),
                   Numbers::PutIn,
                   {},
                   Needs::Point});
}

std::vector<Step> perpSteps(const Out &at) {
  std::vector<Step> steps = sides(at);
  steps.push_back(fromStart(at));
  addPerpSteps(at, steps);
  return steps;
}

std::vector<Step> cramerSteps(const Out &at) {
  std::vector<Step> steps = sides(at);
  steps.push_back(fromStart(at));
  addCramerSteps(at, steps);
  return steps;
}

std::vector<Step> plueckerSteps(const Out &at) {
  std::vector<Step> steps = sides(at);
  addPlueckerSteps(at, steps);
  return steps;
}

/// What a way costs: once for a triangle, and again for each new ray.
struct Cost {
  Operations once;
  Operations eachRay;

  [[nodiscard]] Operations all() const { return once + eachRay; }
};

Cost costOf(const std::vector<Step> &steps, const Out &at) {
  OperationCounter counter;
  Cost cost;
  std::vector<Term> ofRay{at.Q, at.r}; // and what is calculated from these
  const auto isOfRay = [&](const Term &name) {
    return std::any_of(ofRay.begin(), ofRay.end(), [&](const Term &each) { return readAlike(each, name); });
  };
  for (const Step &step : steps) {
    const Term &formula = step.chain.formula();
    const std::vector<Term> names = namesIn(formula);
    const bool changes = std::any_of(names.begin(), names.end(), isOfRay);
    if (changes)
      ofRay.push_back(step.chain.sides().front());
    (changes ? cost.eachRay : cost.once) += counter.add(formula);
  }
  return cost;
}

/// Multiplications for the triangle and for each ray, additions and divisions.
NamedValue costValue(std::string name, const Cost &cost) {
  const Operations all = cost.all();
  return {std::move(name),
          {},
          std::vector<Surd>{cost.once.multiplications, cost.eachRay.multiplications, all.additions,
                            all.divisions}};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<NamedValue> values;
  if (at.crosses()) {
    values.push_back({"location", words("place"), std::string(nameOf(at.perps.location.part))});
    if (at.perps.location.feature >= 0)
      values.push_back({"feature", {}, at.perps.location.feature});
    values.push_back(listed("t", at.lambda));
    values.push_back(listed("point", at.I));
    values.push_back(listed("s", at.s));
    values.push_back(listed("t_triangle", at.t));
    values.push_back(listed("barycentric", list({1 - at.s - at.t, at.s, at.t})));
  }
  values.push_back(
      {"perp",
       {},
       std::vector<NamedValue>{listed("denominator", at.first.G), listed("along", alongNormal(at))}});
  values.push_back({"cramer",
                    {},
                    std::vector<NamedValue>{listed("det", at.second.D), listed("det_sigma", at.second.D1),
                                            listed("det_tau", at.second.D2), listed("det_t", at.second.D3)}});
  const auto &products = at.third.products;
  values.push_back(
      {"plucker",
       {},
       std::vector<NamedValue>{listed("products", list({products.begin(), products.end()})),
                               listed("sum", at.third.S),
                               {"signs", words("signs"), nameOf(signsOf(at.pluecker.products))}}});
  values.push_back({"cost",
                    {},
                    std::vector<NamedValue>{costValue("perp", costOf(perpSteps(at), at)),
                                            costValue("cramer", costOf(cramerSteps(at), at)),
                                            costValue("plucker", costOf(plueckerSteps(at), at))}});
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.crosses())
    return {};
  return {{"I", PointObject{at.perps.plane.point}}};
}

WorkingLine lineOf(const Step &step) {
  return asked(step.numbers == Numbers::PutIn ? withNumbers(step.chain) : withProducts(step.chain),
               step.sentence, step.mistakes);
}

/// A quotient with the denominator 0: what would be divided.
WorkingLine undividedLine(const Step &step) {
  const Term &quotient = step.chain.formula();
  return line({withResult(quotient->parts[0]), withResult(quotient->parts[1])},
              words("{quotient}, which would be {letter}, is not defined: nothing can be divided by 0.",
                    {{"quotient", plainText(quotient)}, {"letter", plainText(step.chain.sides().front())}}));
}

void addLines(std::vector<Step> steps, const Out &at, Explanation &lines) {
  for (Step &step : steps) {
    const std::string id = step.line;
    if (lines.has(id))
      continue;
    if (at.crosses() || step.needs == Needs::Nothing)
      lines.add(id, [step = std::move(step)] { return lineOf(step); });
    else if (step.needs == Needs::Denominator)
      lines.add(id, [step = std::move(step)] { return undividedLine(step); });
  }
}

/// The multiplications of a way: for the triangle, and for each ray. They come from the formulas, not from
/// coordinates, so no number of the line is a result that could be asked for or traced.
WorkingLine countLine(const Naming &naming, const char *index, const Cost &cost) {
  const Operations all = cost.all();
  const Term count = name(naming.own(letter("N", index)), Rational(all.multiplications));
  return line(
      (count == Term(cost.once.multiplications) + Term(cost.eachRay.multiplications)) == all.multiplications,
      words(
          "{once} multiplications belong to the triangle alone and can be kept, {ray} are new for each ray. "
          "Besides: {additions} additions and {divisions} divisions.",
          {{"once", std::to_string(cost.once.multiplications)},
           {"ray", std::to_string(cost.eachRay.multiplications)},
           {"additions", std::to_string(all.additions)},
           {"divisions", std::to_string(all.divisions)}}));
}

void addCountLines(const Out &at, Explanation &lines) {
  lines.add("perp-count", [&at] { return countLine(at, "1", costOf(perpSteps(at), at)); });
  lines.add("cramer-count", [&at] { return countLine(at, "2", costOf(cramerSteps(at), at)); });
  lines.add("pluecker-count", [&at] { return countLine(at, "3", costOf(plueckerSteps(at), at)); });
}

std::string signsWords(const Out &at) {
  if (!at.isRay())
    return words("All are 0, because {r} is the zero vector: there is no line.", at.letters);
  switch (signsOf(at.pluecker.products)) {
  case ProductSigns::Same:
    return at.perps.which == RayTriangleCase::Behind
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

/// What is the same in the methods, each time in one line.
void addAgreement(const Out &at, Explanation &lines) {
  const CramerTerms &cramer = at.second;
  const PlueckerTerms &pluecker = at.third;
  lines.add("denominators", [&at] {
    return asked(withResult((alongNormal(at) == at.second.D) == at.third.S),
                 at.cramer.det == 0 ? words("One number in all three ways, and it is 0.")
                                    : words("One number in all three ways."));
  });
  lines.add("numerators", [&] {
    return line(
        {withResult(cramer.D1 == pluecker.products[1]), withResult(cramer.D2 == pluecker.products[2]),
         withResult(cramer.D3 == startToPlane(at))},
        words("Two determinants are products with edges, the third is a dot product of the first way."));
  });
  lines.add("signs", [&] {
    return line({withResult(pluecker.products[0]), withResult(pluecker.products[1]),
                 withResult(pluecker.products[2])},
                signsWords(at));
  });
  if (!at.crosses())
    return;
  lines.add("agree-s", [&at] {
    return asked(withResult(((at.s == dot(at.first.w, at.first.vPerp) / dot(at.u, at.first.vPerp)) ==
                             at.second.D1 / at.second.D) == at.third.products[1] / at.third.S));
  });
  lines.add("agree-t", [&at] {
    return asked(withResult(((at.t == dot(at.first.w, at.first.uPerp) / dot(at.v, at.first.uPerp)) ==
                             at.second.D2 / at.second.D) == at.third.products[2] / at.third.S),
                 words("Three ways, the same two numbers."));
  });
  lines.add("agree-lambda", [&at] {
    return asked(withResult(((at.lambda == startToPlane(at) / alongNormal(at)) ==
                             at.second.D3 / at.second.D) == dot(at.I - at.Q, at.r) / dot(at.r, at.r)),
                 at.perps.plane.t < 0 ? words("Negative: the ray does not get there.")
                                      : words("Not negative: the ray gets there."));
  });
}

void addPerpVectors(const Out &at, Explanation &lines) {
  lines.add("uperp", [&at] {
    return asked(withNumbers((at.first.uPerp == cross(at.first.n, at.u)) ==
                             dot(at.u, at.u) * at.v - dot(at.u, at.v) * at.u),
                 perpWords(at.first.uPerp, words("In the triangle's plane, perpendicular to u.")));
  });
  lines.add("vperp", [&at] {
    return asked(withNumbers((at.first.vPerp == cross(at.first.n, at.v)) ==
                             dot(at.u, at.v) * at.v - dot(at.v, at.v) * at.u),
                 perpWords(at.first.vPerp, words("Likewise, perpendicular to v.")));
  });
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  addLines(perpSteps(at), at, lines);
  addPerpVectors(at, lines);
  addLines(cramerSteps(at), at, lines);
  addLines(plueckerSteps(at), at, lines);
  addCountLines(at, lines);
  addAgreement(at, lines);
  return lines;
}

/// In units of the picture: only the directions matter.
constexpr double drawnNormalLength = 2.5;
constexpr double drawnPerpLength = 3.5;

/// The edge opposite to a corner, in the colour of its product.
void drawEdge(Figure &figure, const Out &at, std::size_t corner, Subject subject) {
  const std::array corners{&at.P0, &at.P1, &at.P2};
  MarkBase base = drawn(at.third.products.at(corner), Role::Derived, subject);
  figure.add(SegmentMark{std::move(base), place(*corners.at((corner + 1) % 3)),
                         place(*corners.at((corner + 2) % 3))});
}

void drawSpan(Figure &figure, const Out &at) {
  const auto &perps = at.perps.perps;
  const Place p0 = place(at.P0);
  figure.add(
      arrowOfLength(drawn(at.first.n, Role::Derived, Subject::Plane), p0, perps.normal, drawnNormalLength));
  figure.add(
      arrowOfLength(drawn(at.first.uPerp, Role::Derived, Subject::EdgeU), p0, perps.uPerp, drawnPerpLength));
  figure.add(
      arrowOfLength(drawn(at.first.vPerp, Role::Derived, Subject::EdgeV), p0, perps.vPerp, drawnPerpLength));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Role role = at.isTriangle() ? Role::Given : Role::Warning;
  drawEdge(figure, at, 0, Subject::Measure);
  drawEdge(figure, at, 1, Subject::EdgeV);
  drawEdge(figure, at, 2, Subject::EdgeU);
  figure.add(arrowOf(at.u, place(at.P0), role, Subject::EdgeU));
  figure.add(arrowOf(at.v, place(at.P0), role, Subject::EdgeV));
  figure.add(arrowOf(at.c, place(at.Q), Role::Derived, Subject::Point));
  if (at.isTriangle())
    drawSpan(figure, at);
  if (!at.crosses())
    return figure;
  const Place point = place(at.I);
  figure.add(wayToHit(at.first.w, place(at.P0)));
  if (at.perps.plane.t >= 0)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{at.I->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  const bool isHit = at.perps.which == RayTriangleCase::Hit;
  figure.add(pointOf(at.I, isHit ? Role::Result : Role::Ghost, Subject::Ray));
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  return rayTriangleNearby(in.T.object, in.L.object, at, at);
}

} // namespace

Construction three_methods() {
  return makeConstruction<In, Out, TriangleObject, RayObject>(
      "three-methods", {"T", "L"}, {{"I", "point"}},
      {"u",  "v", "c",  "n",  "G",  "w", "s",  "t",  "λ",  "p", "q",  "D",  "D1", "D2",
       "D3", "m", "m0", "m1", "m2", "e", "p0", "p1", "p2", "S", "N1", "N2", "N3"},
      {.cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = {named::word("location", {"interior", "edge", "vertex", "outside"}), named::index("feature"),
                  named::number("t"), named::vector("point"), named::number("s"), named::number("t_triangle"),
                  named::list("barycentric", 3),
                  named::group("perp", {named::number("denominator"), named::number("along")}),
                  named::group("cramer", {named::number("det"), named::number("det_sigma"),
                                          named::number("det_tau"), named::number("det_t")}),
                  named::group("plucker", {named::vector("products"), named::number("sum"),
                                           named::word("signs", {"same", "mixed", "zero"})}),
                  named::group(
                      "cost", {named::list("perp", 4), named::list("cramer", 4), named::list("plucker", 4)})},
       .lines = {"u",
                 "v",
                 "c",
                 "normal",
                 "perp-lambda",
                 "hit",
                 "w",
                 "G",
                 "perp-s",
                 "perp-t",
                 "uperp",
                 "vperp",
                 "p",
                 "q",
                 "D",
                 "D1",
                 "D2",
                 "D3",
                 "cramer-s",
                 "cramer-t",
                 "cramer-lambda",
                 "e",
                 "m",
                 "m0",
                 "m1",
                 "m2",
                 "p0",
                 "p1",
                 "p2",
                 "S",
                 "pluecker-s",
                 "pluecker-t",
                 "mix",
                 "pluecker-lambda",
                 "perp-count",
                 "cramer-count",
                 "pluecker-count",
                 "denominators",
                 "numerators",
                 "signs",
                 "agree-s",
                 "agree-t",
                 "agree-lambda"},
       .marks = {"u", "v", "c", "n", "uperp", "vperp", "w", "p0", "p1", "p2", "I"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
