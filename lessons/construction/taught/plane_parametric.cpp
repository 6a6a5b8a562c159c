// The plane of a triangle by a point and two sides, P0 + s u + t v: what s and t say of a point, and the way
// back to the implicit equation (note PG 2, whose v and w are the u and v of PG 6.2; the latter are taken).
#include "geometry/case_names.h"
#include "geometry/intersect_ray_triangle.h"
#include "geometry/point_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
  Given<PointObject> P;
};

/// How the construction's input is: the first that holds.
enum class ParametricCase { InPlane, OffPlane, Coincident, Collinear };

struct Out : Naming, TriangleTerms {
  ParametricCase which;
  FaceLocation location;
  Plane<Rational> plane;
  Rational sValue, tValue;
  Term P, u, v, n;
  Term s, t;
  Term su, tv; ///< the two parts of the way from P0 to P
  Term P3;     ///< the parallelogram's fourth corner

  [[nodiscard]] bool isDegenerate() const {
    return which == ParametricCase::Coincident || which == ParametricCase::Collinear;
  }
  [[nodiscard]] bool isInPlane() const { return which == ParametricCase::InPlane; }
};

ParametricCase caseOf(const RayTriangle<Rational> &meet) {
  if (meet.which == RayTriangleCase::Coincident)
    return ParametricCase::Coincident;
  if (meet.which == RayTriangleCase::Collinear)
    return ParametricCase::Collinear;
  return meet.plane.t == 0 ? ParametricCase::InPlane : ParametricCase::OffPlane;
}

Out compute(const In &in) {
  const Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
  const ExactVec3 normal = perpsOf(triangle).normal;
  // A ray from the point along the normal starts in the plane exactly where the point lies in it.
  const auto meet = intersectRayTriangle(Ray<Rational>{in.P.object.at, normal}, triangle);
  const TriangleTerms T = termsOf(in.T);
  const Term P = termOf(in.P);
  const Term u = name(in.own(vectorLetter("u")), meet.perps.u).marked(in.mark("u"));
  const Term v = name(in.own(vectorLetter("v")), meet.perps.v).marked(in.mark("v"));
  const Term n = name(in.own(vectorLetter("n")), normal).marked(in.mark("n"));
  // Found by the perps, of which a later lesson tells.
  const Term w = P - T.P0;
  const Term s = name(in.own(letter("s")), meet.s).standingFor(dot(w, cross(n, v)) / dot(u, cross(n, v)));
  const Term t =
      name(in.own(letter("t")), meet.tTriangle).standingFor(dot(w, cross(n, u)) / dot(v, cross(n, u)));
  const Term corner = T.P0 + u + v;
  return {in,
          T,
          caseOf(meet),
          meet.location,
          planeThrough(triangle.p0, normal),
          meet.s,
          meet.tTriangle,
          P,
          u,
          v,
          n,
          s,
          t,
          (s * u).marked(in.mark("su")),
          (t * v).marked(in.mark("tv")),
          madeName(in, "P3", corner->value).standingFor(corner)};
}

/// Where the point is, for people: inside the triangle, on the edge P₀P₁ …
std::string placeName(const Out &at) {
  const std::array corners{&at.P0, &at.P1, &at.P2};
  const auto corner = [&](int index) { return *corners.at(static_cast<std::size_t>(index)); };
  switch (at.location.part) {
  case FacePart::Interior:
    return words("inside the triangle");
  case FacePart::Edge: // named by the corner opposite to it
    return words("on the edge {edge}",
                 {{"edge", edgeName(corner(at.location.feature == 0 ? 1 : 0)->symbol,
                                    corner(at.location.feature == 2 ? 1 : 2)->symbol)}});
  case FacePart::Vertex:
    return words("at the corner {corner}", {{"corner", plainText(corner(at.location.feature))}});
  case FacePart::Outside:
    break;
  }
  return words("outside the triangle");
}

/// What the signs of the three shares say.
std::string sharesWords(const Out &at) {
  const std::string place = placeName(at);
  switch (at.location.part) {
  case FacePart::Interior:
    return words("All three are positive: {P} is {place}.", at.letters, {{"place", place}});
  case FacePart::Edge:
    return words("One is 0 and the others are positive: {P} is {place}.", at.letters, {{"place", place}});
  case FacePart::Vertex:
    return words("Two are 0: {P} is {place}.", at.letters, {{"place", place}});
  case FacePart::Outside:
    break;
  }
  return words("At least one is negative: {P} is {place}.", at.letters, {{"place", place}});
}

CaseWords tell(const In &in, const Out &at) {
  switch (at.which) {
  case ParametricCase::InPlane:
    return {"in-plane", words("{P} is {place}: {s}, {t}.", at.letters,
                              {{"place", placeName(at)}, {"s", equation(at.s)}, {"t", equation(at.t)}})};
  case ParametricCase::OffPlane:
    return {"off-plane",
            words("{P} does not lie in the triangle's plane: no s and t lead to it.", at.letters)};
  case ParametricCase::Coincident: {
    const auto &[p0, p1, p2] = in.T.object;
    const Term &first = p0 == p1 || p0 == p2 ? at.P0 : at.P1;
    const Term &second = p0 == p1 ? at.P1 : at.P2;
    return {"coincident",
            words("{first} and {second} are the same point: the corners span no plane.",
                  {{"first", plainText(first)}, {"second", plainText(second)}}),
            true};
  }
  case ParametricCase::Collinear:
    break;
  }
  return {"collinear",
          words("{P0}, {P1} and {P2} lie on one line: every s and t lead to a point of this line, and the "
                "corners span no plane.",
                at.letters),
          true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (at.isDegenerate())
    return {};
  std::vector<NamedValue> values;
  if (at.isInPlane()) {
    values = {listed("s", at.s),
              listed("t", at.t),
              listed("point", at.P),
              listed("barycentric", list({1 - at.s - at.t, at.s, at.t})),
              {"location", words("place"), std::string(nameOf(at.location.part))}};
    if (at.location.feature >= 0)
      values.push_back({"feature", {}, at.location.feature});
    values.push_back({"in_parallelogram", words("in the parallelogram"),
                      isInParallelogram(at.sValue, at.tValue) ? "yes" : "no"});
    values.push_back({"more_of", words("the larger of s and t"),
                      at.sValue > at.tValue   ? "s"
                      : at.sValue < at.tValue ? "t"
                                              : "none"});
  }
  values.push_back(listed("normal", at.n));
  const auto primitive = primitiveCoefficients(at.plane);
  values.push_back(
      {"primitive", words("in lowest integers"), std::vector<Surd>(primitive.begin(), primitive.end())});
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) { return {{"P3", PointObject{vectorOf(at.P3)}}}; }

WorkingLine sideLine(const Out &at) {
  return asked(withNumbers(at.v == at.P2 - at.P0),
               words("Two sides of the triangle, both from {P0}.", at.letters));
}

WorkingLine pointLine(const Out &at) {
  return asked(withNumbers(at.P == at.P0 + at.su + at.tv),
               words("From {P0}, s steps of u and then t steps of v.", at.letters));
}

WorkingLine mixedLine(const Out &at) {
  return asked(withNumbers(at.P == (1 - at.s - at.t) * at.P0 + at.s * at.P1 + at.t * at.P2),
               words("The same point without u and v: a mixture of the three corners."));
}

WorkingLine sharesLine(const Out &at) {
  return line({withResult(1 - at.s - at.t), withResult(at.s), withResult(at.t)}, sharesWords(at));
}

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.u, at.v)),
               at.isDegenerate() ? crossProductWords(at.n)
                                 : words("Perpendicular to u and to v, so it is a normal of the plane."),
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

WorkingLine checkLine(const Out &at) {
  return asked(withNumbers(dot(at.n, at.P - at.P0)),
               at.isInPlane() ? words("{P} fulfils it, whatever s and t are.", at.letters)
                              : words("Not 0: {P} does not lie in the plane.", at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("u", [&at] { return asked(withNumbers(at.u == at.P1 - at.P0)); });
  lines.add("v", [&at] { return sideLine(at); });
  if (at.isInPlane()) {
    lines.add("point", [&at] { return pointLine(at); });
    lines.add("mixed", [&at] { return mixedLine(at); });
    lines.add("shares", [&at] { return sharesLine(at); });
  }
  lines.add("normal", [&at] { return normalLine(at); });
  if (at.isDegenerate())
    return lines;
  lines.add("implicit", [&at] { return implicitLine(at); });
  lines.add("check", [&at] { return checkLine(at); });
  return lines;
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
  if (at.sValue != 0)
    figure.add(ArrowMark{drawn(at.su, Role::Derived, Subject::EdgeU), p0, place(at.su)});
  if (at.tValue != 0)
    figure.add(ArrowMark{drawn(at.tv, Role::Derived, Subject::EdgeV), p0 + place(at.su), place(at.tv)});
}

Figure draw(const In &, const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  const Role role = at.isDegenerate() ? Role::Warning : Role::Given;
  figure.add(pointOf(at.P3, Role::Ghost, Subject::Triangle));
  if (!isZero(vectorOf(at.u)))
    figure.add(arrowOf(at.u, p0, role, Subject::EdgeU));
  if (!isZero(vectorOf(at.v)))
    figure.add(arrowOf(at.v, p0, role, Subject::EdgeV));
  if (at.isDegenerate())
    return figure;
  figure.add(PolygonMark{{at.P3->mark + "/region", Role::Ghost, Subject::Triangle},
                         {p0, place(at.P1), place(at.P3), place(at.P2)}});
  figure.add(ArrowMark{drawn(at.n, Role::Derived, Subject::Plane), p0, unitOf(at.plane.normal), false,
                       drawnNormalLength});
  drawEdgeLines(figure, at);
  if (at.isInPlane())
    drawWay(figure, at);
  return figure;
}

/// Where the point would lie for which a share would be 0, moved along a side.
std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (at.isDegenerate())
    return all;
  const auto add = [&](const char *when, std::string sentence, const ExactVec3 &place) {
    all.push_back({when, std::move(sentence), "P", PointObject{place}});
  };
  const ExactVec3 &p = in.P.object.at;
  if (!at.isInPlane()) {
    const ExactVec3 way = p - in.T.object.p0;
    add("case = in-plane", words("{P} would lie in the triangle's plane.", at.letters),
        p - projectVector(way, at.plane.normal).projection);
    return all;
  }
  const ExactVec3 u = in.T.object.p1 - in.T.object.p0;
  const ExactVec3 v = in.T.object.p2 - in.T.object.p0;
  // The point nearest on each edge's line.
  const auto onto = [&](const ExactVec3 &from, const ExactVec3 &along) {
    return ExactVec3(from + projectVector(ExactVec3(p - from), along).projection);
  };
  const auto edge = [&](const Term &from, const Term &to) {
    return words("{P} would lie on the line through {from} and {to}.", at.letters,
                 {{"from", plainText(from)}, {"to", plainText(to)}});
  };
  if (at.sValue != 0)
    add("s = 0", edge(at.P0, at.P2), onto(in.T.object.p0, v));
  if (at.tValue != 0)
    add("t = 0", edge(at.P0, at.P1), onto(in.T.object.p0, u));
  if (at.sValue + at.tValue != 1)
    add("barycentric.0 = 0", edge(at.P1, at.P2), onto(in.T.object.p1, ExactVec3(v - u)));
  return all;
}

} // namespace

Construction plane_parametric() {
  return makeConstruction<In, Out, TriangleObject, PointObject>(
      "plane-parametric", {"T", "P"}, {{"P3", "point"}}, {"u", "v", "n", "s", "t"},
      {.cases = {"in-plane", "off-plane", "coincident", "collinear"},
       .values = {named::number("s"), named::number("t"), named::vector("point"),
                  named::list("barycentric", 3),
                  named::word("location", {"interior", "edge", "vertex", "outside"}), named::index("feature"),
                  named::word("in_parallelogram", {"yes", "no"}), named::word("more_of", {"s", "t", "none"}),
                  named::vector("normal"), named::list("primitive", 4)},
       .lines = {"u", "v", "point", "mixed", "shares", "normal", "implicit", "check"},
       .marks = {"P3", "u", "v", "n", "s0", "t0", "st1", "su", "tv"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
