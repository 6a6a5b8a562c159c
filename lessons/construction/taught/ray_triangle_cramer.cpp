// Where a ray meets a triangle, by Cramer's rule with two cross products that four determinants share (note
// CG). The ray's parameter is λ here, as in the method of perps; the corners, r, s and t in the note, keep
// their letters.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "lessons/construction/parts/expansion.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/spanned_box.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

/// How far a vector reaches along another one; 0 where that is zero.
Surd reachAlong(const Term &other, const Term &vector) {
  const ExactVec3 way = vectorOf(other);
  return isZero(way) ? Surd() : overRoot(dot(vectorOf(vector), way), dot(way, way));
}

struct Out : RayAtTriangle {
  using RayAtTriangle::RayAtTriangle;

  RayTriangleCramer<Rational> meet = intersectRayTriangleCramer(ray, triangle);
  bool crosses = meet.crosses();

  // The columns beside r: from P1, P2 and Q to P0.
  Term a = drawnName(vectorLetter("a"), ExactVec3(triangle.p0 - triangle.p1));
  Term b = drawnName(vectorLetter("b"), ExactVec3(triangle.p0 - triangle.p2));
  Term c = drawnName(vectorLetter("c"), ExactVec3(triangle.p0 - ray.origin));
  Term p = drawnName(vectorLetter("p"), ExactVec3(cross(vectorOf(b), ray.direction)));
  Term q = drawnName(vectorLetter("q"), ExactVec3(cross(vectorOf(a), vectorOf(c))));
  // |a b r|, and with c for its first, second and third column.
  Term D = ownName(letter("D"), meet.det);
  Term D1 = ownName(letter("D", "1"), meet.detSigma);
  Term D2 = ownName(letter("D", "2"), meet.detTau);
  Term D3 = ownName(letter("D", "3"), meet.detT);
  Term sigma = ownName(letter("σ"), meet.sigma);
  Term tau = ownName(letter("τ"), meet.tau);
  Term lambda = ownName(letter("λ"), meet.t);
  /// How far a and c reach along p: how high the boxes are on the face of b and r.
  Term ha = drawnName(letter("h", "a"), reachAlong(p, a));
  Term hc = drawnName(letter("h", "c"), reachAlong(p, c));
  Term I = madeName("I", ExactVec3(ray.origin + ray.direction * meet.t));
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const WordValues lambda{{"lambda", equation(at.lambda)}};
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName, placeWords(at.meet.location, at, hitSentences, lambda)};
  case RayTriangleCase::Behind:
    return {caseName, placeWords(at.meet.location, at,
                                 {says("{lambda} is negative: the triangle is behind the ray's start. Only "
                                       "the line backwards meets it, inside the triangle."),
                                  says("{lambda} is negative: the triangle is behind the ray's start. Only "
                                       "the line backwards meets it, on the edge {edge}."),
                                  says("{lambda} is negative: the triangle is behind the ray's start. Only "
                                       "the line backwards meets it, at the corner {corner}.")},
                                 lambda)};
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
            coincidentWords(
                at.in.T.object, at,
                {says("{first} and {second} are the same point: this is no triangle, and D is 0."),
                 says("{first}, {second} and {third} are the same point: this is no triangle, and D is 0.")}),
            true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: two columns are multiples of each other, and D is 0.",
                at.letters),
          true};
}

/// D by the cofactors of its first column.
WorkingLine firstColumnLine(const Out &at) {
  return expansionLine(at.D, {at.a, at.b, at.r}, 0,
                       words("By its first column: each number of a times what is left without its row and "
                             "column. Signs: plus, minus, plus."));
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

WorkingLine sigmaLine(const Out &at) {
  return asked(withProducts((at.D1 == determinant(3, {at.c, at.b, at.r})) == dot(at.c, at.p)),
               words("c in the place of a: p is there already."),
               {{-at.D1, words("{answer} has the wrong sign.")}});
}

WorkingLine tauLine(const Out &at) {
  return asked(withProducts((at.D2 == determinant(3, {at.a, at.c, at.r})) == dot(at.r, at.q)),
               words("c in the place of b. Here the last column is split off: {r}.", at.letters),
               {{-at.D2, words("{answer} has the wrong sign.")}});
}

WorkingLine numeratorLine(const Out &at) {
  return asked(
      withProducts((at.D3 == determinant(3, {at.a, at.b, at.c})) == -dot(at.b, at.q)),
      words("c in the place of {r}. The middle column is split off, and that one comes with a minus.",
            at.letters),
      {{-at.D3, words("{answer} is b·q: a middle column comes with a minus.")}});
}

/// `wrong` is the share with another numerator.
WorkingLine shareLine(const Out &at, const Term &share, const Term &numerator, const Term &other,
                      std::string sentence) {
  return asked(withNumbers(share == numerator / at.D), std::move(sentence),
               {{other / at.D, words("{answer} has the wrong determinant above.")}});
}

WorkingLine placeLine(const Out &at) {
  return resultsLine({1 - at.sigma - at.tau, at.sigma, at.tau},
                     placeWords(at.meet.location, at,
                                {says("These are the weights of {P0}, {P1} and {P2}. The line of the ray "
                                      "meets the plane inside the triangle."),
                                 says("These are the weights of {P0}, {P1} and {P2}. The line of the ray "
                                      "meets the plane on the edge {edge}."),
                                 says("These are the weights of {P0}, {P1} and {P2}. The line of the ray "
                                      "meets the plane at the corner {corner}."),
                                 says("These are the weights of {P0}, {P1} and {P2}. The line of the ray "
                                      "meets the plane outside the triangle.")},
                                at.letters));
}

std::string heightWords(const Out &at, const Term &vector) {
  const std::string name = plainText(vector);
  const Rational along = dot(vectorOf(vector), vectorOf(at.p));
  if (along > 0)
    return words("How far {vector} reaches along p: the height of its box on the face of b and {r}.",
                 at.letters, {{"vector", name}});
  if (along < 0)
    return words(
        "How far {vector} reaches along p. Negative: it points to one side of the face of b and {r}, "
        "and p to the other.",
        at.letters, {{"vector", name}});
  return words("0: {vector} lies in the plane of b and {r}, and its box is flat.", at.letters,
               {{"vector", name}});
}

WorkingLine heightLine(const Out &at, const Term &height, const Term &vector) {
  const Term product = dot(vector, at.p);
  return asked(withNumbers(height == product / norm(at.p)), heightWords(at, vector),
               {{product, words("{answer} is not divided by |p| yet.")},
                {product / dot(at.p, at.p), words("{answer} is divided by p·p: divide by its root, |p|.")}});
}

WorkingLine boxesLine(const Out &at) {
  return asked(
      withNumbers(at.sigma == at.hc / at.ha),
      words("Both boxes stand on the face of b and {r}. So their volumes compare as their heights do.",
            at.letters),
      {{at.hc, words("{answer} is the height of {Q}: divide it by that of {P1}.", at.letters)}});
}

std::string parameterWords(const Out &at) {
  return at.meet.t < 0
             ? words("Negative: the line gets there before the ray's start {Q}, so the ray does not hit.",
                     at.letters)
             : words("Not negative: the ray itself gets there.");
}

LineTable<Out> lines() {
  return {{"a", always, [](const Out &at) { return withNumbers(at.a == at.P0 - at.P1); },
           says("From {P1} to {P0}.")},
          {"b", always, [](const Out &at) { return withNumbers(at.b == at.P0 - at.P2); },
           says("From {P2} to {P0}.")},
          {"c", always, [](const Out &at) { return withNumbers(at.c == at.P0 - at.Q); },
           says("From {Q} to {P0}.")},
          {"expansion", always, firstColumnLine},
          {"p", always,
           [](const Out &at) {
             return sharedLine(at.p, at.b, at.r, words("The first cross product that is used twice."));
           }},
          {"det", always, determinantLine},
          {"det-sigma", always, sigmaLine},
          {"q", always,
           [](const Out &at) {
             return sharedLine(at.q, at.a, at.c, words("The second cross product that is used twice."));
           }},
          {"det-tau", always, tauLine},
          {"det-t", always, numeratorLine},
          {"sigma", &Out::crosses,
           [](const Out &at) {
             return shareLine(at, at.sigma, at.D1, at.D2, words("The weight of {P1}.", at.letters));
           }},
          {"height-a", &Out::crosses, [](const Out &at) { return heightLine(at, at.ha, at.a); }},
          {"height-c", &Out::crosses, [](const Out &at) { return heightLine(at, at.hc, at.c); }},
          {"boxes", &Out::crosses, boxesLine},
          {"tau", &Out::crosses,
           [](const Out &at) {
             return shareLine(at, at.tau, at.D2, at.D1, words("The weight of {P2}.", at.letters));
           }},
          {"place", &Out::crosses, placeLine},
          {"t", &Out::crosses,
           [](const Out &at) { return shareLine(at, at.lambda, at.D3, at.D1, parameterWords(at)); }},
          {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.I == at.Q + at.lambda * at.r); },
           says("Where the line of the ray meets the triangle's plane.")}};
}

/// The cross products are drawn this long in every picture: only their directions matter.
constexpr double drawnProductLength = 2.5;

/// The box of an arrow that leads to P0, of b and of r, on the face that b and r have at P0; and its height
/// there, from where the arrow starts.
void drawBox(Figure &figure, const Out &at, const Term &height, const Term &vector, Subject subject) {
  const ExactVec3 corner = vectorOf(at.P0);
  const ExactVec3 arrow = vectorOf(vector);
  const ExactVec3 p = vectorOf(at.p);
  addSpannedBox(figure, {height->mark + "/box", Role::Helper, subject}, corner,
                {ExactVec3(-arrow), ExactVec3(-vectorOf(at.b)), at.ray.direction});
  const ExactVec3 up = p * Rational(dot(arrow, p) / dot(p, p));
  if (isZero(up))
    return;
  const ExactVec3 start = corner - arrow;
  const ExactVec3 foot = start + up;
  figure.add(SegmentMark{drawn(height, Role::Result, subject), place(start), place(foot)});
}

Figure draw(const Out &at) {
  Figure figure;
  figure.add(arrowOf(at.a, place(at.P1), Role::Given, Subject::EdgeU));
  figure.add(arrowOf(at.b, place(at.P2), Role::Given, Subject::EdgeV));
  figure.add(arrowOf(at.c, place(at.Q), Role::Derived, Subject::Point));
  addDirection(figure, at.p, place(at.P2), drawnProductLength, Role::Derived, Subject::Measure);
  addDirection(figure, at.q, place(at.P1), drawnProductLength, Role::Derived, Subject::Plane);
  if (!at.crosses)
    return figure;
  drawBox(figure, at, at.ha, at.a, Subject::EdgeU);
  drawBox(figure, at, at.hc, at.c, Subject::Point);
  addMeeting(figure, at.in.L, at.I, at.meet.t >= 0, at.meet.which == RayTriangleCase::Hit);
  return figure;
}

} // namespace

Construction ray_triangle_cramer() {
  return taught<Out, TriangleObject, RayObject>(
      {.id = "ray-triangle-cramer",
       .title = [] { return words("ray and triangle by Cramer's rule"); },
       .roles = {"T", "L"},
       .makes = {{"I", &Out::crosses, &Out::I}},
       .letters = {"a", "b", "c", "p", "q", "D", "D1", "D2", "D3", "ha", "hc", "σ", "τ", "λ"},
       .cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = joined<ValueRow<Out>>(
           {crossingRows<Out>([](const Out &at) { return at.meet.location; }),
            {barycentricRow<Out>(&Out::crosses, &Out::sigma, &Out::tau), cramerRow<Out>()}}),
       .lines = lines(),
       .marks = {"a", "b", "c", "p", "q", "ha", "hc", "I"},
       .tell = tell,
       .draw = draw,
       .nearby = rayTriangleNearby});
}

} // namespace halfspace
