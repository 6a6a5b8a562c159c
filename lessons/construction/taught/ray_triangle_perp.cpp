// Where a ray meets a triangle, by u⊥ and v⊥ with five dot products (note PG 6.2, figure 4). The ray's
// parameter is λ here, because s and t belong to the triangle.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_line.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/taught.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <tuple>

namespace halfspace {
namespace {

struct Out : RayByPerps {
  using RayByPerps::RayByPerps;

  ExactVec3 tipOfTv = triangle.p0 + perps.v * meet.tTriangle;

  Term vPerp = ownName(perpLetter("v"), perps.vPerp).marked(mark("vperp"));
  Term G = ownName(letter("G"), perps.denominator);
  Term w = drawnName(vectorLetter("w"), meet.w);
  Term a = ownName(letter("a"), dot(meet.w, perps.uPerp)).marked(mark("A"));
  Term b = ownName(letter("b"), dot(perps.v, perps.uPerp)).marked(mark("B"));
  // Figure 4: the feet of C and P2 on u⊥, and C at the tip of t·v. Without a triangle they are at the origin.
  Term A = drawnName(letter("A"), measurePointLine(tipOfTv, triangle.p0, perps.uPerp).foot);
  Term B = drawnName(letter("B"), measurePointLine(triangle.p2, triangle.p0, perps.uPerp).foot);
  Term C = drawnName(letter("C"), tipOfTv);
};

CaseWords tell(const Out &at) {
  const WordValues lambda{{"lambda", equation(at.lambda)}};
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayTriangleCase::Hit:
    return {caseName, placeWords(at.meet.location, at, hitSentences, lambda)};
  case RayTriangleCase::Behind:
    return {caseName, placeWords(at.meet.location, at,
                                 {says("{lambda} is negative: the triangle is behind the ray's start. The "
                                       "line backwards would meet it inside the triangle."),
                                  says("{lambda} is negative: the triangle is behind the ray's start. The "
                                       "line backwards would meet it on the edge {edge}."),
                                  says("{lambda} is negative: the triangle is behind the ray's start. The "
                                       "line backwards would meet it at the corner {corner}.")},
                                 lambda)};
  case RayTriangleCase::Miss:
    return {caseName, words("The line meets the triangle's plane outside the triangle: {s}, {t}, {sum}.",
                            {{"s", equation(at.s)}, {"t", equation(at.t)}, {"sum", equation(at.s + at.t)}})};
  case RayTriangleCase::Parallel:
    return {caseName, words("{r}·n = 0: the ray runs parallel to the triangle's plane and never meets it.",
                            at.letters)};
  case RayTriangleCase::InPlane:
    return {caseName, words("{r}·n = 0 and {Q} lies in the triangle's plane: the ray runs inside it, and no "
                            "single point is the hit.",
                            at.letters)};
  case RayTriangleCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayTriangleCase::Coincident:
    return {
        caseName,
        coincidentWords(
            at.in.T.object, at,
            {says("{first} and {second} are the same point: this is no triangle, and the denominator is 0."),
             says("{first}, {second} and {third} are the same point: this is no triangle, and the "
                  "denominator is 0.")}),
        true};
  case RayTriangleCase::Collinear:
    break;
  }
  return {caseName,
          words("{P0}, {P1} and {P2} lie on one line: (u·v)² equals (u·u)(v·v), so the denominator is 0 and "
                "there is no triangle to hit.",
                at.letters),
          true};
}

WorkingLine parameterLine(const Out &at) {
  return asked(withNumbers(at.lambda == dot(at.P0 - at.Q, at.n) / dot(at.r, at.n)),
               words("First the triangle's plane: so many steps {r} lead from {Q} to it.", at.letters),
               {wrongSignOf(at.lambda, at)});
}

WorkingLine denominatorLine(const Out &at) {
  const auto &u = at.u;
  const auto &v = at.v;
  return asked(withNumbers(at.G == power(dot(u, v), 2) - dot(u, u) * dot(v, v)),
               !at.isTriangle
                   ? words("Zero: u and v do not span a triangle, and there is nothing to divide by.")
                   : words("The denominator of s and t. It is zero only when the corners lie on one line."),
               {{-at.G, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}});
}

/// The mistake of a share: the sign of G.
WrongTerm wrongSignOfShare(const Term &share) {
  return {-share, words("{answer} has the wrong sign: the denominator G = (u·v)² − (u·u)(v·v) is negative.")};
}

WorkingLine lineOfS(const Out &at) {
  const auto &[u, v, w] = std::tie(at.u, at.v, at.w);
  return asked(
      withNumbers((at.s == dot(w, at.vPerp) / dot(u, at.vPerp)) ==
                  (dot(u, v) * dot(w, v) - dot(v, v) * dot(w, u)) / at.G),
      words("In the dot product with v⊥ the part t·v drops out, and only s is left."),
      {{at.t, words("{answer} is t: for s, take the dot product with v⊥.")}, wrongSignOfShare(at.s)});
}

WorkingLine lineOfT(const Out &at) {
  const auto &[u, v, w] = std::tie(at.u, at.v, at.w);
  return asked(
      withNumbers((at.t == dot(w, at.uPerp) / dot(v, at.uPerp)) ==
                  (dot(u, v) * dot(w, u) - dot(u, u) * dot(w, v)) / at.G),
      words(
          "In the dot product with u⊥ the part s·u drops out, and only t is left. v·u⊥ is −G, so the signs "
          "in the numerator have changed too. This t belongs to the triangle; the ray's own parameter is λ."),
      {{at.s, words("{answer} is s: for t, take the dot product with u⊥.")}, wrongSignOfShare(at.t)});
}

WorkingLine placeLine(const Out &at) {
  return resultsLine({at.s, at.t, at.s + at.t},
                     placeWords(at.meet.location, at,
                                {says("The point belongs to the triangle when none of s, t and 1 − s − t is "
                                      "negative. Here it is inside the triangle."),
                                 says("The point belongs to the triangle when none of s, t and 1 − s − t is "
                                      "negative. Here it is on the edge {edge}."),
                                 says("The point belongs to the triangle when none of s, t and 1 − s − t is "
                                      "negative. Here it is at the corner {corner}."),
                                 says("The point belongs to the triangle when none of s, t and 1 − s − t is "
                                      "negative. Here it is outside the triangle.")}));
}

/// Where one of the triangles has no corners of its own, they have no shape.
std::string similarWords(const Out &at) {
  const WordValues points{{"P0", plainText(at.P0)},
                          {"P2", plainText(at.P2)},
                          {"A", plainText(at.A)},
                          {"B", plainText(at.B)},
                          {"C", plainText(at.C)}};
  if (at.meet.tTriangle == 0)
    return words("t is 0: {A} and {C} are {P0} itself, and there is no triangle {P0}{A}{C}.", points);
  if (at.meet.perps.uv == 0)
    return words(
        "u and v are perpendicular: {B} is {P2} itself and {A} is {C}, so the triangles are flat. Along "
        "u⊥, t·v is to v as a is to b all the same.",
        points);
  return words("The right triangles {P0}{A}{C} and {P0}{B}{P2} have the same shape, so t·v is to v as a is "
               "to b. The length of u⊥ stands in both and cancels.",
               points);
}

/// Figure 4 of the note.
WorkingLine similarLine(const Out &at) {
  const Term part = at.a / at.b;
  return line(((at.t * at.v).marked(at.C->mark) == part * at.v)
                  .then(numbersPutIn(part) * at.v)
                  .then(multipleOf(part, at.v)),
              similarWords(at));
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {sideLines<Out>(),
       {{"normal", always,
         [](const Out &at) { return sidesNormalLine(at.n, at.u, at.v, crossProductWords(at.n)); }},
        {"uu", always, [](const Out &at) { return asked(withProducts(dot(at.u, at.u))); }},
        {"uv", always, [](const Out &at) { return asked(withProducts(dot(at.u, at.v))); }},
        {"vv", always, [](const Out &at) { return withProducts(dot(at.v, at.v)); },
         says("Three of the five dot products: they belong to the triangle alone.")},
        {"uperp", always,
         [](const Out &at) {
           return withNumbers((at.uPerp == cross(at.n, at.u)) ==
                              dot(at.u, at.u) * at.v - dot(at.u, at.v) * at.u);
         },
         [](const Out &at) {
           return perpWords(at.uPerp, words("u perp: in the plane of the triangle and perpendicular to u."));
         }},
        {"vperp", always,
         [](const Out &at) {
           return withNumbers((at.vPerp == cross(at.n, at.v)) ==
                              dot(at.u, at.v) * at.v - dot(at.v, at.v) * at.u);
         },
         [](const Out &at) { return perpWords(at.vPerp, words("v perp likewise: perpendicular to v.")); }},
        {"plane-t", &Out::crosses, parameterLine},
        {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.I == at.Q + at.lambda * at.r); },
         says("The point of the plane that the ray's line goes through. Is it in the triangle?")},
        {"w", &Out::crosses, [](const Out &at) { return withNumbers(at.w == at.I - at.P0); },
         says("From {P0} to {I}.")},
        {"wu", &Out::crosses, [](const Out &at) { return asked(withProducts(dot(at.w, at.u))); }},
        {"wv", &Out::crosses, [](const Out &at) { return withProducts(dot(at.w, at.v)); },
         says("The last two of the five dot products.")},
        {"denominator", always, denominatorLine},
        {"s", &Out::crosses, lineOfS},
        {"t", &Out::crosses, lineOfT},
        {"place", &Out::crosses, placeLine},
        {"a", &Out::crosses, [](const Out &at) { return withResult(at.a == dot(at.w, at.uPerp)); },
         says("How far w reaches along u⊥, times the length of u⊥.")},
        {"b", &Out::crosses, [](const Out &at) { return withResult(at.b == dot(at.v, at.uPerp)); },
         says("The same for v.")},
        {"similar", &Out::crosses, similarLine}}});
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;
/// The perps are drawn a little longer than the farther of the feet on them.
constexpr double perpBeyondFoot = 1.12;

/// How far a vector reaches along a direction.
double reachAlong(const ExactVec3 &direction, const Place &vector) {
  return std::abs(glm::dot(vector, unitOf(direction)));
}

void drawSpan(Figure &figure, const Out &at) {
  const Place p0 = place(at.P0);
  figure.add(arrowInPicture(drawn(at.n, Role::Derived, Subject::Plane), p0, unitOf(at.perps.normal),
                            drawnNormalLength));
  const ExactVec3 &uPerp = at.perps.uPerp;
  const double reachOfW = at.crosses ? reachAlong(uPerp, place(at.w)) : 0;
  addDirection(figure, at.uPerp, p0, std::max(reachAlong(uPerp, place(at.v)), reachOfW) * perpBeyondFoot,
               Role::Derived, Subject::EdgeU);
  addDirection(figure, at.vPerp, p0, reachAlong(at.perps.vPerp, place(at.u)) * perpBeyondFoot, Role::Derived,
               Subject::EdgeV);
}

void drawEdges(Figure &figure, const Out &at) {
  const Role sound =
      at.in.T.isFree ? Role::Given : Role::Derived; // a triangle that was made is not there from the start
  const Role role = at.isTriangle ? sound : Role::Warning;
  figure.add(arrowOf(at.u, place(at.P0), role, Subject::EdgeU));
  figure.add(arrowOf(at.v, place(at.P0), role, Subject::EdgeV));
}

/// A point's foot on u⊥, with the way there.
void drawFoot(Figure &figure, const Out &at, const Term &foot, const Place &point) {
  const Place p0 = place(at.P0);
  const Place end = place(foot);
  figure.add(SegmentMark{{foot->mark + "/way", Role::Helper, Subject::Measure}, point, end});
  figure.add(pointOf(foot, Role::Derived, Subject::Measure));
  if (vectorOf(foot) != vectorOf(at.P0))
    figure.add(
        RightAngleMark{{foot->mark + "/angle", Role::Helper, Subject::Measure}, end, p0 - end, point - end});
}

/// Figure 4 of the note: the similar right triangles of t·v and v. From the tip of t·v the part s·u leads to
/// I, along the way to the foot: so I has the same foot.
void drawSimilarTriangles(Figure &figure, const Out &at) {
  figure.add(pointOf(at.C, Role::Derived, Subject::EdgeV));
  figure.add(SegmentMark{{at.C->mark + "/su", Role::Helper, Subject::EdgeU}, place(at.C), place(at.I)});
  drawFoot(figure, at, at.A, place(at.C));
  drawFoot(figure, at, at.B, place(at.P2));
}

Figure draw(const Out &at) {
  Figure figure;
  if (at.isTriangle)
    drawSpan(figure, at);
  drawEdges(figure, at);
  if (!at.crosses)
    return figure;
  addWayTo(figure, at.in.L, at.I, at.meet.plane.which == RayPlaneCase::Hit);
  figure.add(wayToHit(at.w, place(at.P0)));
  drawSimilarTriangles(figure, at);
  const bool hit = at.meet.which == RayTriangleCase::Hit;
  figure.add(pointOf(at.I, hit ? Role::Result : Role::Ghost, Subject::Ray));
  return figure;
}

ValueRow<Out> perpRow() {
  return valueGroup<Out>("perp", always,
                         {{named::vector("u_perp"), always, &Out::uPerp},
                          {named::vector("v_perp"), always, &Out::vPerp},
                          {named::number("uu"), always, [](const Out &at) { return dot(at.u, at.u); }},
                          {named::number("uv"), always, [](const Out &at) { return dot(at.u, at.v); }},
                          {named::number("vv"), always, [](const Out &at) { return dot(at.v, at.v); }},
                          {named::number("wu"), &Out::crosses, [](const Out &at) { return dot(at.w, at.u); }},
                          {named::number("wv"), &Out::crosses, [](const Out &at) { return dot(at.w, at.v); }},
                          {named::number("denominator"), always, &Out::G}});
}

} // namespace

Construction ray_triangle_perp() {
  return taught<Out, TriangleObject, RayObject>(
      {.id = "ray-triangle-perp",
       .word = "intersect",
       .title = [] { return words("where the ray meets the triangle"); },
       .roles = {"T", "L"},
       .makes = {{"I", &Out::crosses, &Out::I}},
       .letters = {"u", "v", "n", "G", "λ", "w", "s", "t", "a", "b", "A", "B", "C"},
       .cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "coincident",
                 "collinear"},
       .values = joined<ValueRow<Out>>({crossingRows<Out>([](const Out &at) { return at.meet.location; }),
                                        shareRows<Out>(),
                                        {barycentricRow<Out>(&Out::crosses, &Out::s, &Out::t), perpRow()}}),
       .lines = lines(),
       .marks = {"n", "uperp", "vperp", "u", "v", "w", "A", "B", "C", "I"},
       .tell = tell,
       .draw = draw,
       .nearby = rayTriangleNearby});
}

} // namespace halfspace
