// The plane of a triangle by a point and two sides, P0 + s u + t v: what s and t say of a point, and the way
// back to the implicit equation (note PG 2, whose v and w are the u and v of PG 6.2; the latter are taken).
#include "geometry/case_names.h"
#include "geometry/point_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <glm/geometric.hpp>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<PointObject> P;
};

struct Out : Computed<In>, TriangleTerms {
  explicit Out(const In &objects) : Computed(objects), TriangleTerms(termsOf(objects.T)) {}

  Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
  /// A ray from the point along the normal starts in the plane exactly where the point lies in it.
  RayTriangle<Rational> meet =
      intersectRayTriangle(Ray<Rational>{in.P.object.at, ExactVec3(perpsOf(triangle).normal)}, triangle);
  const TrianglePerps<Rational> &perps = meet.perps;
  Plane<Rational> plane = planeThrough(triangle.p0, perps.normal);
  bool isTriangle = perps.denominator != 0;
  bool isInPlane = isTriangle && meet.plane.t == 0;

  Term P = termOf(in.P);
  Term u = drawnName(vectorLetter("u"), perps.u);
  Term v = drawnName(vectorLetter("v"), perps.v);
  Term n = drawnName(vectorLetter("n"), perps.normal);
  // Found by the perps, of which a later lesson tells.
  Term s = ownName(letter("s"), meet.s).standingFor(dot(P - P0, cross(n, v)) / dot(u, cross(n, v)));
  Term t = ownName(letter("t"), meet.tTriangle).standingFor(dot(P - P0, cross(n, u)) / dot(v, cross(n, u)));
  // The two parts of the way from P0 to P.
  Term su = (s * u).marked(mark("su"));
  Term tv = (t * v).marked(mark("tv"));
  Term corner = P0 + u + v;
  Term P3 = madeName("P3", corner->value).standingFor(corner); ///< the parallelogram's fourth corner
};

/// What the signs of the three shares say.
std::string sharesWords(const Out &at) {
  return placeWords(at.meet.location, at,
                    {says("All three are positive: {P} is inside the triangle."),
                     says("One is 0 and the others are positive: {P} is on the edge {edge}."),
                     says("Two are 0: {P} is at the corner {corner}."),
                     says("At least one is negative: {P} is outside the triangle.")},
                    at.letters);
}

CaseWords tell(const Out &at) {
  if (at.isInPlane)
    return {"in-plane", placeWords(at.meet.location, at,
                                   {says("{P} is inside the triangle: {s}, {t}."),
                                    says("{P} is on the edge {edge}: {s}, {t}."),
                                    says("{P} is at the corner {corner}: {s}, {t}."),
                                    says("{P} is outside the triangle: {s}, {t}.")},
                                   {{"P", plainText(at.P)}, {"s", equation(at.s)}, {"t", equation(at.t)}})};
  if (at.isTriangle)
    return {"off-plane",
            words("{P} does not lie in the triangle's plane: no s and t lead to it.", at.letters)};
  if (at.meet.which == RayTriangleCase::Coincident) {
    const auto [first, second] = coincidentCorners(at.in.T.object, at);
    return {"coincident",
            words("{first} and {second} are the same point: the corners span no plane.",
                  {{"first", plainText(first)}, {"second", plainText(second)}}),
            true};
  }
  return {"collinear",
          words("{P0}, {P1} and {P2} lie on one line: every s and t lead to a point of this line, and the "
                "corners span no plane.",
                at.letters),
          true};
}

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.u, at.v)),
               at.isTriangle ? words("Perpendicular to u and to v, so it is a normal of the plane.")
                             : crossProductWords(at.n),
               {{cross(at.v, at.u), words("{answer} is the cross product the other way round: v × u.")}});
}

WorkingLine implicitLine(const Out &at) {
  const Term anywhere = list({unknown("x"), unknown("y"), unknown("z")});
  const Term left = dot(at.n, anywhere - at.P0);
  return askedEquation(condition((0 == left).then(calculated(left))),
                       words("The implicit equation, with u × v for the normal."),
                       {{dot(at.n, anywhere) + dot(at.n, at.P0),
                         words("In {answer} the constant is n·{P0}: the minus sign is lost.", at.letters)}});
}

std::string checkWords(const Out &at) {
  return at.isInPlane ? words("{P} satisfies it, whatever s and t are.", at.letters)
                      : words("Not 0: {P} does not lie in the plane.", at.letters);
}

LineTable<Out> lines() {
  return {{"u", always, [](const Out &at) { return asked(withNumbers(at.u == at.P1 - at.P0)); }},
          {"v", always, [](const Out &at) { return withNumbers(at.v == at.P2 - at.P0); },
           says("Two sides of the triangle, both from {P0}.")},
          {"point", &Out::isInPlane, [](const Out &at) { return withNumbers(at.P == at.P0 + at.su + at.tv); },
           says("From {P0}, s steps of u and then t steps of v.")},
          {"mixed", &Out::isInPlane,
           [](const Out &at) {
             return withNumbers(at.P == (1 - at.s - at.t) * at.P0 + at.s * at.P1 + at.t * at.P2);
           },
           says("The same point without u and v: a mixture of the three corners.")},
          {"shares", &Out::isInPlane,
           [](const Out &at) {
             return resultsLine({1 - at.s - at.t, at.s, at.t}, sharesWords(at));
           }},
          {"normal", always, normalLine},
          {"implicit", &Out::isTriangle, implicitLine},
          {"check", &Out::isTriangle, [](const Out &at) { return withNumbers(dot(at.n, at.P - at.P0)); },
           checkWords}};
}

ToldValue largerValue(const Out &at) {
  const auto &[s, t] = std::pair(at.meet.s, at.meet.tTriangle);
  return {words("the larger of s and t"), s > t ? Word{"s", "s"} : s < t ? Word{"t", "t"} : noneOfThem()};
}

ToldValue parallelogramValue(const Out &at) {
  return {words("in the parallelogram"), yesOrNo(isInParallelogram(at.meet.s, at.meet.tTriangle))};
}

ToldValue primitiveValue(const Out &at) {
  const auto primitive = primitiveCoefficients(at.plane);
  return {words("in smallest whole numbers"), std::vector<Surd>(primitive.begin(), primitive.end())};
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;
/// The line of an edge is drawn so far from the edge's middle, in lengths of the edge.
constexpr double edgeLineReach = 0.9;

/// The whole line that an edge is a piece of: all points for which one share is 0.
LineMark edgeLine(std::string id, std::string label, const ExactVec3 &from, const ExactVec3 &to) {
  const ExactVec3 edge = to - from;
  const double reach = glm::length(place(edge)) * edgeLineReach;
  LineMark line{{std::move(id), Role::Ghost, Subject::Measure, std::move(label)},
                place(ExactVec3(from + edge * Rational(1, 2))),
                unitOf(edge)};
  line.held = Extent{-reach, reach};
  return line;
}

void drawEdgeLines(Figure &figure, const Out &at) {
  const ExactVec3 p0 = vectorOf(at.P0);
  const ExactVec3 p1 = vectorOf(at.P1);
  const ExactVec3 p2 = vectorOf(at.P2);
  const auto zero = [](const Term &share) { return latexOf(share) + " = 0"; };
  figure.add(edgeLine(at.mark("s0"), zero(at.s), p0, p2));
  figure.add(edgeLine(at.mark("t0"), zero(at.t), p0, p1));
  figure.add(edgeLine(at.mark("st1"), latexOf(at.s + at.t) + " = 1", p1, p2));
}

/// The way from P0 to P along the two sides.
void drawWay(Figure &figure, const Out &at) {
  const Place p0 = place(at.P0);
  if (at.meet.s != 0)
    figure.add(ArrowMark{drawn(at.su, Role::Derived, Subject::EdgeU), p0, place(at.su)});
  if (at.meet.tTriangle != 0)
    figure.add(ArrowMark{drawn(at.tv, Role::Derived, Subject::EdgeV), p0 + place(at.su), place(at.tv)});
}

Figure draw(const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  const Role role = !at.isTriangle ? Role::Warning : Role::Given;
  figure.add(pointOf(at.P3, Role::Ghost, Subject::Triangle));
  if (!isZero(vectorOf(at.u)))
    figure.add(arrowOf(at.u, p0, role, Subject::EdgeU));
  if (!isZero(vectorOf(at.v)))
    figure.add(arrowOf(at.v, p0, role, Subject::EdgeV));
  if (!at.isTriangle)
    return figure;
  figure.add(PolygonMark{{at.P3->mark + "/region", Role::Ghost, Subject::Triangle},
                         {p0, place(at.P1), place(at.P3), place(at.P2)}});
  figure.add(ArrowMark{drawn(at.n, Role::Derived, Subject::Plane), p0, unitOf(at.plane.normal), false,
                       drawnNormalLength});
  drawEdgeLines(figure, at);
  if (at.isInPlane)
    drawWay(figure, at);
  return figure;
}

/// Where the point would lie for which a share would be 0, moved along a side.
std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.isTriangle)
    return all;
  const auto add = [&](Conditions when, std::string sentence, const ExactVec3 &place) {
    all.push_back({std::move(when), std::move(sentence), "P", PointObject{place}});
  };
  const ExactVec3 &p = at.in.P.object.at;
  if (!at.isInPlane) {
    const ExactVec3 way = p - at.in.T.object.p0;
    add(is("case", "in-plane"), words("{P} would lie in the triangle's plane.", at.letters),
        p - projectVector(way, at.plane.normal).projection);
    return all;
  }
  const ExactVec3 u = at.in.T.object.p1 - at.in.T.object.p0;
  const ExactVec3 v = at.in.T.object.p2 - at.in.T.object.p0;
  // The point nearest on each edge's line.
  const auto onto = [&](const ExactVec3 &from, const ExactVec3 &along) {
    return ExactVec3(from + projectVector(ExactVec3(p - from), along).projection);
  };
  const auto edge = [&](const Term &from, const Term &to) {
    return words("{P} would lie on the line through {from} and {to}.", at.letters,
                 {{"from", plainText(from)}, {"to", plainText(to)}});
  };
  if (at.meet.s != 0)
    add(is("s", "0"), edge(at.P0, at.P2), onto(at.in.T.object.p0, v));
  if (at.meet.tTriangle != 0)
    add(is("t", "0"), edge(at.P0, at.P1), onto(at.in.T.object.p0, u));
  if (at.meet.s + at.meet.tTriangle != 1)
    add(is("barycentric.0", "0"), edge(at.P1, at.P2), onto(at.in.T.object.p1, ExactVec3(v - u)));
  return all;
}

} // namespace

Construction plane_parametric() {
  return taught<Out, TriangleObject, PointObject>(
      {.id = "plane-parametric",
       .title = [] { return words("the point by s and t"); },
       .roles = {"T", "P"},
       .makes = {{"P3", always, &Out::P3}},
       .letters = {"u", "v", "n", "s", "t"},
       .cases = {"in-plane", "off-plane", "coincident", "collinear"},
       .values = joined<ValueRow<Out>>(
           {{{named::number("s"), &Out::isInPlane, &Out::s},
             {named::number("t"), &Out::isInPlane, &Out::t},
             {named::vector("point"), &Out::isInPlane, &Out::P},
             {named::list("barycentric", 3), &Out::isInPlane,
              [](const Out &at) {
                return list({1 - at.s - at.t, at.s, at.t});
              }}},
            placeRows<Out>(&Out::isInPlane, [](const Out &at) { return at.meet.location; }),
            {{named::word("in_parallelogram", {"yes", "no"}), &Out::isInPlane, parallelogramValue},
             {named::word("more_of", {"s", "t", "none"}), &Out::isInPlane, largerValue},
             {named::vector("normal"), &Out::isTriangle, &Out::n},
             {named::list("primitive", 4), &Out::isTriangle, primitiveValue}}}),
       .lines = lines(),
       .marks = {"P3", "u", "v", "n", "s0", "t0", "st1", "su", "tv"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
