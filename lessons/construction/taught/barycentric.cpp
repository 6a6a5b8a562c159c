// A point of a triangle's plane by its weights at the corners, as shares of the area (note CG).
#include "geometry/barycentric.h"
#include "geometry/case_names.h"
#include "geometry/point_line.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<PointObject> Q;
};

struct Out : Computed<In>, TriangleTerms {
  explicit Out(const In &objects) : Computed(objects), TriangleTerms(termsOf(objects.T)) {}

  Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
  Barycentric<Rational> weighed = barycentricOf(in.Q.object.at, triangle);
  const std::array<Rational, 3> &weights = weighed.weights;
  bool hasWeights = weighed.which == BarycentricCase::InPlane;

  Term Q = termOf(in.Q);
  Term n = drawnName(vectorLetter("n"), weighed.normal);
  /// Of the whole triangle, whose mark it is.
  Term A = ownName(letter("A"), weighed.area).standingFor(norm(n) / 2).marked(in.T.id);
  // Of the small triangles opposite to the corners: normals, and signed areas.
  Term n0 = drawnName(vectorLetter("n", "0"), weighed.normals[0]);
  Term n1 = drawnName(vectorLetter("n", "1"), weighed.normals[1]);
  Term n2 = drawnName(vectorLetter("n", "2"), weighed.normals[2]);
  std::array<Term, 3> parts{drawnName(letter("A", "0"), weighed.areas[0]),
                            drawnName(letter("A", "1"), weighed.areas[1]),
                            drawnName(letter("A", "2"), weighed.areas[2])};
  Term rho = ownName(letter("ρ"), weights[0]).marked(mark("A0"));
  Term sigma = ownName(letter("σ"), weights[1]).marked(mark("A1"));
  Term tau = ownName(letter("τ"), weights[2]).marked(mark("A2"));
  /// Where the parallel to the edge P1P2 meets the edge P0P1.
  Term B =
      drawnName(letter("B"), ExactVec3(triangle.p0 *weights[0] + triangle.p1 * Rational(1 - weights[0])));
};

/// ρ = 1/3, σ = 1/6, τ = 1/2, and the letter of the point.
WordValues weightWords(const Out &at) {
  return {{"Q", plainText(at.in.Q.symbol)},
          {"rho", equation(at.rho)},
          {"sigma", equation(at.sigma)},
          {"tau", equation(at.tau)}};
}

std::string locationSentence(const Out &at) {
  const auto &all = at.weights;
  const bool isBeyondOneEdge =
      std::count_if(all.begin(), all.end(), [](const Rational &weight) { return weight < 0; }) == 1;
  return placeWords(
      at.weighed.location, at,
      {says("All three weights are positive: {Q} is inside the triangle. {rho}, {sigma}, {tau}."),
       says("One weight is 0 and the others are positive: {Q} is on the edge {edge}. {rho}, {sigma}, {tau}."),
       says("One weight is 1 and the others are 0: {Q} is at the corner {corner}. {rho}, {sigma}, {tau}."),
       isBeyondOneEdge
           ? says("One weight is negative: {Q} is outside the triangle. {rho}, {sigma}, {tau}.")
           : says("Two weights are negative: {Q} is outside the triangle. {rho}, {sigma}, {tau}.")},
      weightWords(at));
}

CaseWords tell(const Out &at) {
  switch (at.weighed.which) {
  case BarycentricCase::InPlane:
    return {std::string(nameOf(at.weighed.location.part)), locationSentence(at)};
  case BarycentricCase::OffPlane:
    return {"off-plane",
            words("{Q} does not lie in the triangle's plane, so no weights of the three corners lead to it.",
                  at.letters)};
  case BarycentricCase::Coincident:
    return {"coincident",
            coincidentWords(at.in.T.object, at,
                            {says("{first} and {second} are the same point: this is no triangle, and there "
                                  "is no area to share."),
                             says("{first}, {second} and {third} are the same point: this is no triangle, "
                                  "and there is no area to share.")}),
            true};
  case BarycentricCase::Collinear:
    break;
  }
  return {"collinear",
          words("{P0}, {P1} and {P2} lie on one line: the triangle has no area to share.", at.letters), true};
}

/// The corner of the largest weight, or several.
Word heaviest(const Out &at) {
  const auto largest = std::max_element(at.weights.begin(), at.weights.end());
  if (std::count(at.weights.begin(), at.weights.end(), *largest) > 1)
    return severalOfThem();
  const auto corner = static_cast<std::size_t>(largest - at.weights.begin());
  return {"P" + std::to_string(corner), plainText(at.in.T.letters[corner])};
}

WorkingLine normalLine(const Out &at) {
  return asked(
      withNumbers(at.n == cross(at.P1 - at.P0, at.P2 - at.P0)),
      words("It is as long as twice the triangle's area."),
      {{cross(at.P2 - at.P0, at.P1 - at.P0), words("{answer} is the cross product the other way round.")}});
}

WorkingLine wholeLine(const Out &at) {
  return asked(withNumbers(at.A == norm(at.n) / 2), words("A triangle is half of a parallelogram."),
               {{norm(at.n), words("{answer} is |n|, the area of a parallelogram: the triangle is half.")}});
}

/// The normal of a small triangle, of {Q} and the edge between two corners.
WorkingLine smallNormalLine(const Out &at, const Term &normal, const Term &from, const Term &to) {
  return asked(
      withNumbers(normal == cross(from - at.Q, to - at.Q)),
      words("The same for the small triangle of {Q} and the edge {edge}.", at.letters,
            {{"edge", edgeName(from->symbol, to->symbol)}}),
      {{cross(to - at.Q, from - at.Q), words("{answer} is the cross product the other way round.")}});
}

/// The signed area of a small triangle by its normal.
WorkingLine smallAreaLine(const Out &at, std::size_t corner, const Term &normal) {
  const Term &area = at.parts.at(corner);
  const Rational &weight = at.weights.at(corner);
  const Term size = norm(normal) / 2;
  if (weight < 0)
    return asked(
        withNumbers(area == -size),
        words("{normal} points against n: {Q} is beyond this edge, and the area counts as negative.",
              at.letters, {{"normal", plainText(normal)}}),
        {{size, words("{answer} has lost its sign: the two normals point in opposite directions.")}});
  return asked(withNumbers(area == size),
               weight == 0 ? words("No area is left: {Q} is on the line of this edge.", at.letters)
                           : words("{normal} points the same way as n, so the area counts as positive.",
                                   {{"normal", plainText(normal)}}));
}

/// The weight of the corner that an area is opposite to.
WorkingLine weightLine(const Out &at, const Term &weight, const Term &area, const Term &corner) {
  return asked(withNumbers(weight == area / at.A),
               words("The weight of {corner}: the share of the small triangle opposite to it.",
                     {{"corner", plainText(corner)}}));
}

WorkingLine lastWeightLine(const Out &at) {
  return asked(withNumbers(at.tau == 1 - at.rho - at.sigma),
               words("The three weights add up to 1, so the last one is what is left."),
               {{at.rho + at.sigma, words("{answer} is the sum of the other two: take it from 1.")}});
}

WorkingLine placeLine(const Out &at) {
  return resultsLine(
      {at.rho, at.sigma, at.tau},
      placeWords(at.weighed.location, at,
                 {says("{Q} is inside the triangle."), says("{Q} is on the edge {edge}."),
                  says("{Q} is at the corner {corner}."), says("{Q} is outside the triangle.")},
                 at.letters));
}

WorkingLine cutLine(const Out &at) {
  return asked(withNumbers(at.B == at.rho * at.P0 + (1 - at.rho) * at.P1),
               words("Here the line through {Q}, parallel to the edge {edge}, meets the line {other}.",
                     at.letters,
                     {{"edge", edgeName(at.P1->symbol, at.P2->symbol)},
                      {"other", edgeName(at.P0->symbol, at.P1->symbol)}}));
}

LineTable<Out> lines() {
  return {
      {"n", always, normalLine},
      {"area", always, wholeLine},
      {"n0", &Out::hasWeights, [](const Out &at) { return smallNormalLine(at, at.n0, at.P1, at.P2); }},
      {"area0", &Out::hasWeights, [](const Out &at) { return smallAreaLine(at, 0, at.n0); }},
      {"n1", &Out::hasWeights, [](const Out &at) { return smallNormalLine(at, at.n1, at.P2, at.P0); }},
      {"area1", &Out::hasWeights, [](const Out &at) { return smallAreaLine(at, 1, at.n1); }},
      {"n2", &Out::hasWeights, [](const Out &at) { return smallNormalLine(at, at.n2, at.P0, at.P1); }},
      {"sum", &Out::hasWeights, [](const Out &at) { return withNumbers(at.n0 + at.n1 + at.n2); },
       says("The three together are n, wherever {Q} is.")},
      {"area2", &Out::hasWeights,
       [](const Out &at) { return withNumbers(at.parts[2] == at.A - at.parts[0] - at.parts[1]); },
       says("The three small areas together are the whole: so the third is what is left.")},
      {"rho", &Out::hasWeights, [](const Out &at) { return weightLine(at, at.rho, at.parts[0], at.P0); }},
      {"sigma", &Out::hasWeights, [](const Out &at) { return weightLine(at, at.sigma, at.parts[1], at.P1); }},
      {"tau", &Out::hasWeights, lastWeightLine},
      {"mix", &Out::hasWeights,
       [](const Out &at) { return withNumbers(at.Q == at.rho * at.P0 + at.sigma * at.P1 + at.tau * at.P2); },
       says("The corners mixed with these weights give the point {Q} again.")},
      {"cut", &Out::hasWeights, cutLine},
      {"place", &Out::hasWeights, placeLine}};
}

/// The normals are drawn this long in every picture: only their directions matter here.
constexpr double drawnNormalLength = 2.5;
constexpr std::array smallSubjects{Subject::Ray, Subject::Plane, Subject::Measure};

/// The line through Q on which the weight of a corner stays the same: parallel to the edge opposite, from the
/// line of one of the other edges to that of the other, and to Q.
void drawParallel(Figure &figure, const Out &at, std::size_t corner) {
  const std::array corners{at.in.T.object.p0, at.in.T.object.p1, at.in.T.object.p2};
  const std::size_t next = (corner + 1) % 3;
  const std::size_t last = (corner + 2) % 3;
  const auto &weights = at.weights;
  const Rational rest = 1 - weights.at(corner);
  const Rational low = std::min({Rational(0), rest, weights.at(last)});
  const Rational high = std::max({Rational(0), rest, weights.at(last)});
  if (low == high)
    return;
  const ExactVec3 start = corners.at(corner) * weights.at(corner) + corners.at(next) * rest;
  const ExactVec3 edge = corners.at(last) - corners.at(next);
  figure.add(
      SegmentMark{{at.mark("parallel" + std::to_string(corner)), Role::Helper, smallSubjects.at(corner)},
                  place(ExactVec3(start + edge * low)),
                  place(ExactVec3(start + edge * high))});
}

void drawSmall(Figure &figure, const Out &at, std::size_t corner) {
  if (at.weights.at(corner) == 0)
    return;
  const std::array corners{place(at.P0), place(at.P1), place(at.P2)};
  const Role role = at.weights.at(corner) < 0 ? Role::Ghost : Role::Derived;
  figure.add(PolygonMark{drawn(at.parts.at(corner), role, smallSubjects.at(corner)),
                         {place(at.Q), corners.at((corner + 1) % 3), corners.at((corner + 2) % 3)}});
}

/// At the middle of an edge: the half of the sum of its ends.
void drawSmallNormal(Figure &figure, const Term &normal, const Place &ends, Subject subject) {
  addDirection(figure, normal, ends / 2.0, drawnNormalLength, Role::Derived, subject);
}

Figure draw(const Out &at) {
  Figure figure;
  addDirection(figure, at.n, place(at.P0), drawnNormalLength, Role::Derived, Subject::Triangle);
  if (!at.hasWeights)
    return figure;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    drawSmall(figure, at, corner);
    drawParallel(figure, at, corner);
  }
  drawSmallNormal(figure, at.n0, place(at.P1) + place(at.P2), smallSubjects[0]);
  drawSmallNormal(figure, at.n1, place(at.P2) + place(at.P0), smallSubjects[1]);
  drawSmallNormal(figure, at.n2, place(at.P0) + place(at.P1), smallSubjects[2]);
  figure.add(pointOf(at.B, Role::Derived, smallSubjects[0]));
  return figure;
}

/// The point moved to each corner, and to the nearest place of each edge: where it is not yet.
void addMoved(const Out &at, std::vector<SpecialCase> &all) {
  const std::array corners{at.in.T.object.p0, at.in.T.object.p1, at.in.T.object.p2};
  const std::array<const Term *, 3> names{&at.P0, &at.P1, &at.P2};
  const ExactVec3 &point = at.in.Q.object.at;
  const auto add = [&](const ExactVec3 &to, const std::string &part, std::size_t feature,
                       std::string sentence) {
    if (to != point)
      all.push_back({both(is("case", part), is("feature", std::to_string(feature))), std::move(sentence), "Q",
                     PointObject{to}});
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    add(corners.at(i), "vertex", i,
        words("{Q} would be at the corner {corner}.", at.letters, {{"corner", plainText(*names.at(i))}}));
    const auto edge = measurePointLine(point, corners.at(i), ExactVec3(corners.at(next) - corners.at(i)));
    if (edge.t > 0 && edge.t < 1)
      add(edge.foot, "edge", 3 - i - next, // the corner opposite to it
          words("{Q} would lie on the edge {edge}.", at.letters,
                {{"edge", edgeName((*names.at(i))->symbol, (*names.at(next))->symbol)}}));
  }
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (isZero(at.weighed.normal))
    return all;
  if (at.hasWeights) {
    addMoved(at, all);
    return all;
  }
  const ExactVec3 &point = at.in.Q.object.at;
  const ExactVec3 height = projectVector(ExactVec3(point - at.in.T.object.p0), at.weighed.normal).projection;
  all.push_back({isNot("case", "off-plane"), words("{Q} would lie in the triangle's plane.", at.letters), "Q",
                 PointObject{ExactVec3(point - height)}});
  return all;
}

} // namespace

Construction barycentric() {
  return taught<Out, TriangleObject, PointObject>(
      {.id = "barycentric",
       .title = [] { return words("barycentric coordinates"); },
       .roles = {"T", "Q"},
       .letters = {"n", "A", "n0", "n1", "n2", "A0", "A1", "A2", "ρ", "σ", "τ", "B"},
       .cases = {"interior", "edge", "vertex", "outside", "off-plane", "coincident", "collinear"},
       .values = {{named::number("area"), always, &Out::A},
                  featureRow<Out>(&Out::hasWeights, [](const Out &at) { return at.weighed.location; }),
                  {named::list("areas", 3), &Out::hasWeights,
                   [](const Out &at) {
                     return list({at.parts[0], at.parts[1], at.parts[2]});
                   }},
                  {named::list("barycentric", 3), &Out::hasWeights,
                   [](const Out &at) {
                     return list({at.rho, at.sigma, at.tau});
                   }},
                  {named::word("heaviest", {"P0", "P1", "P2", "several"}), &Out::hasWeights,
                   [](const Out &at) { return Value(heaviest(at)); }}},
       .lines = lines(),
       .marks = {"n", "n0", "n1", "n2", "A0", "A1", "A2", "parallel0", "parallel1", "parallel2", "B"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
