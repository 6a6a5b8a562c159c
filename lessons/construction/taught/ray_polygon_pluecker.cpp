// Whether a ray goes through a convex polygon, by the signs of its products with the edges (note PL).
#include "geometry/case_names.h"
#include "geometry/intersect_ray_polygon.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/name_rows.h"
#include "lessons/construction/parts/product_signs.h"
#include "lessons/construction/parts/shifted_ray.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace halfspace {
namespace {

constexpr std::size_t mostCorners = 8;

struct In : Naming {
  Given<PolygonObject> W;
  Given<RayObject> L;
};

/// An edge as a line: direction, moment, and the product of the ray's line with it.
struct EdgeTerms {
  Term e, m, p;
};

/// How much of each corner of a triangle the point has in it.
struct WeightTerms {
  Term rho, sigma, tau;
};

struct Out : Naming, RayTerms {
  PolygonShape shape;
  RayPolygon<Rational> meet; ///< of a polygon that is not convex only the products
  std::vector<Term> corners;
  Term m;                       ///< the moment of the ray's line
  std::vector<EdgeTerms> edges; ///< edge i runs from corner i to the next
  Term S;                       ///< the sum of the products
  Term n, t, I;
  std::optional<WeightTerms> weights; ///< where a triangle's plane is crossed

  [[nodiscard]] const Term &corner(std::size_t index) const { return corners.at(index % corners.size()); }
  [[nodiscard]] bool isConvex() const { return shape == PolygonShape::Convex; }
  [[nodiscard]] std::string edgeNamed(std::size_t index) const {
    return edgeName(corner(index)->symbol, corner(index + 1)->symbol);
  }
};

RayPolygon<Rational> meetOf(const Ray<Rational> &ray, const std::vector<ExactVec3> &corners,
                            PolygonShape shape) {
  if (shape == PolygonShape::Convex)
    return intersectRayPolygon<Rational>(ray, corners);
  RayPolygon<Rational> meet;
  meet.products = productsWithEdges<Rational>(lineOf(ray), corners);
  return meet;
}

std::vector<EdgeTerms> edgesOf(const In &in, const std::vector<Term> &corners,
                               const std::vector<Rational> &products) {
  std::vector<EdgeTerms> edges;
  const auto &places = in.W.object.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string index = std::to_string(i);
    const std::size_t next = (i + 1) % corners.size();
    const std::string mark = in.mark("p" + index);
    const Term e = name(in.own(vectorLetter("e", index)), ExactVec3(places[next] - places[i]))
                       .marked(mark)
                       .standingFor(corners[next] - corners[i]);
    const Term m = name(in.own(vectorLetter("m", index)), ExactVec3(cross(places[i], places[next])))
                       .standingFor(cross(corners[i], e));
    edges.push_back({e, m, name(in.own(letter("p", index)), products[i]).marked(mark)});
  }
  return edges;
}

Term sumOf(const std::vector<EdgeTerms> &edges) {
  std::vector<Term> products;
  products.reserve(edges.size());
  for (const EdgeTerms &edge : edges)
    products.push_back(edge.p);
  return sum(std::move(products));
}

/// The weight of a corner belongs to the edge opposite to it: that of P0 to the edge from P1.
std::optional<WeightTerms> weightsOf(const In &in, const RayPolygon<Rational> &meet, const Rational &whole) {
  if (meet.products.size() != 3 || !meet.crosses())
    return {};
  const auto weight = [&](const char *greek, std::size_t edge) {
    return name(in.own(letter(greek)), Rational(meet.products[edge] / whole));
  };
  return WeightTerms{weight("ρ", 1), weight("σ", 2), weight("τ", 0)};
}

Out compute(const In &in) {
  const auto &places = in.W.object.corners;
  const auto &[origin, direction] = in.L.object;
  const Ray<Rational> ray{origin, direction};
  const PolygonShape shape = shapeOf(places);
  const auto meet = meetOf(ray, places, shape);
  const RayTerms L = termsOf(in.L);
  const std::vector<Term> corners = cornerTermsOf(in.W);
  const Rational whole = std::accumulate(meet.products.begin(), meet.products.end(), Rational(0));
  return {in,
          L,
          shape,
          meet,
          corners,
          name(in.own(vectorLetter("m")), lineOf(ray).moment).standingFor(cross(L.Q, L.r)),
          edgesOf(in, corners, meet.products),
          name(in.own(letter("S")), whole),
          name(in.own(vectorLetter("n")), planeThrough(places[0], places[1], places[2]).normal)
              .marked(in.mark("n")),
          name(in.own(letter("t")), meet.t),
          madeName(in, "I", meet.point),
          weightsOf(in, meet, whole)};
}

/// For people: the inside of the polygon, the edge P₀P₁ …
std::string partWords(const Out &at) {
  const FaceLocation &location = at.meet.location;
  const auto feature = static_cast<std::size_t>(std::max(location.feature, 0));
  switch (location.part) {
  case FacePart::Interior:
    return words("the inside of the polygon");
  case FacePart::Edge:
    return words("the edge {edge}", {{"edge", at.edgeNamed(feature)}});
  case FacePart::Vertex:
    return words("the corner {corner}", {{"corner", plainText(at.corner(feature))}});
  case FacePart::Outside:
    break;
  }
  return words("the plane outside the polygon");
}

/// Why corners in a plane are not those of a convex polygon.
std::string notConvexWords(const In &in, const Out &at) {
  const auto &places = in.W.object.corners;
  const std::size_t count = places.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + 1; k < count; ++k)
      if (places[i] == places[k])
        return words("{first} and {second} are the same point: the polygon has a corner too many.",
                     {{"first", plainText(at.corner(i))}, {"second", plainText(at.corner(k))}});
  if (count == 3)
    return words("{first}, {second} and {third} lie on one line: this is no triangle.",
                 {{"first", plainText(at.corner(0))},
                  {"second", plainText(at.corner(1))},
                  {"third", plainText(at.corner(2))}});
  for (std::size_t i = 0; i < count; ++i) {
    const ExactVec3 &corner = places[(i + 1) % count];
    if (isZero(cross(corner - places[i], places[(i + 2) % count] - corner)))
      return words(
          "{first}, {corner} and {last} lie on one line, so {corner} is no corner of a convex polygon.",
          {{"first", plainText(at.corner(i))},
           {"corner", plainText(at.corner(i + 1))},
           {"last", plainText(at.corner(i + 2))}});
  }
  return words("The polygon bends inwards or crosses itself: it is not convex, and the signs alone do not "
               "tell what is inside.");
}

CaseWords tellMeeting(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const std::pair<std::string_view, std::string> t{"t", equation(at.t)};
  const std::pair<std::string_view, std::string> part{"part", partWords(at)};
  switch (at.meet.which) {
  case RayPolygonCase::Hit:
    return {caseName,
            words("No two products differ in sign: the ray goes through {part}, at {t}.", {part, t})};
  case RayPolygonCase::Behind:
    return {caseName, words("No two products differ in sign, so the line of the ray goes through {part}. But "
                            "{t} is negative: that is behind the ray's start.",
                            {part, t})};
  case RayPolygonCase::Miss:
    return {caseName, words("Two products differ in sign: the line of the ray passes outside the polygon.")};
  case RayPolygonCase::Parallel:
    return {
        caseName,
        words("The products add up to 0: the ray runs parallel to the polygon's plane and never meets it.")};
  case RayPolygonCase::InPlane:
  case RayPolygonCase::ZeroDirection:
    break;
  }
  return {caseName, words("All products are 0: the ray runs inside the polygon's plane, and no single point "
                          "is the hit.")};
}

CaseWords tell(const In &in, const Out &at) {
  if (isZero(in.L.object.direction))
    return zeroDirectionWords(at);
  switch (at.shape) {
  case PolygonShape::Convex:
    return tellMeeting(at);
  case PolygonShape::NotPlanar:
    return {"not-planar",
            words("The corners do not lie in one plane: no flat polygon is there to go through."), true};
  case PolygonShape::NotConvex:
    break;
  }
  return {"not-convex", notConvexWords(in, at), true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<Term> products;
  for (const EdgeTerms &edge : at.edges)
    products.push_back(edge.p);
  std::vector<NamedValue> values{listed("products", list(std::move(products))),
                                 listed("sum", at.S),
                                 {"signs", words("signs"), nameOf(signsOf(at.meet.products))}};
  if (!at.meet.crosses())
    return values;
  values.push_back({"location", words("place"), std::string(nameOf(at.meet.location.part))});
  if (at.meet.location.feature >= 0)
    values.push_back({"feature", {}, at.meet.location.feature});
  values.push_back(listed("t", at.t));
  values.push_back(listed("point", at.I));
  if (at.weights)
    values.push_back(listed("barycentric", list({at.weights->rho, at.weights->sigma, at.weights->tau})));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.meet.crosses())
    return {};
  return {{"I", PointObject{at.meet.point}}};
}

/// Of a point on a line and the line's direction.
WorkingLine momentLine(const Term &moment, const Term &point, const Term &direction, std::string sentence) {
  return asked(withProducts(moment == cross(point, direction)), std::move(sentence),
               {{cross(direction, point),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

bool hasNoDirection(const Out &at) { return isZero(vectorOf(at.r)); }

std::string signWords(const Out &at, std::size_t index) {
  const Rational &product = at.meet.products[index];
  const WordValues edge{{"r", plainText(at.r)}, {"edge", at.edgeNamed(index)}};
  if (product > 0)
    return words(
        "Positive: seen with {r} pointing at you, the edge {edge} goes counterclockwise around the ray.",
        edge);
  if (product < 0)
    return words("Negative: seen with {r} pointing at you, the edge {edge} goes clockwise around the ray.",
                 edge);
  const std::string reason = withoutDirectionWords(at.r, at.edges[index].e);
  return reason.empty() ? words("Zero: the ray and the edge {edge} lie in one plane.", edge) : reason;
}

WorkingLine productLine(const Out &at, std::size_t index) {
  const auto &[e, m, p] = at.edges[index];
  return asked(
      withNumbers((p == permuted(at.r, at.m, e, m)) == dot(at.r, m) + dot(e, at.m)), signWords(at, index),
      {{dot(at.r, e) + dot(at.m, m),
        words("{answer} multiplies direction by direction and moment by moment: cross over, each "
              "direction with the other line's moment.")},
       {dot(at.r, at.m) + dot(e, m),
        words("{answer} multiplies each direction by its own line's moment: take the other's.")},
       {dot(at.r, m) - dot(e, at.m), words("{answer} subtracts the second product: the two are added.")}});
}

void addEdgeLines(const Out &at, std::size_t index, Explanation &lines) {
  const std::string id = std::to_string(index);
  const EdgeTerms &edge = at.edges[index];
  const Term &from = at.corner(index);
  lines.add("e" + id, [&at, &edge, &from, index] {
    return asked(withNumbers(edge.e == at.corner(index + 1) - from),
                 words("The edge {edge}, from one corner to the next.", {{"edge", at.edgeNamed(index)}}),
                 {{from - at.corner(index + 1), words("{answer} points backwards: take the end minus the "
                                                      "start.")}});
  });
  lines.add("m" + id,
            [&edge, &from] { return momentLine(edge.m, from, edge.e, words("The moment of its line.")); });
  lines.add("edge" + id, [&at, index] { return productLine(at, index); });
}

std::string commonSignWords(const Out &at) {
  const ProductSigns signs = signsOf(at.meet.products);
  if (hasNoDirection(at))
    return words("All are 0, because {r} is the zero vector: there is no line.", at.letters);
  if (!at.isConvex())
    return words("The signs say which way the ray passes each edge. They decide for a flat, convex polygon "
                 "only.");
  if (signs == ProductSigns::Zero)
    return words("All are 0: the ray and all edges lie in one plane.");
  if (signs == ProductSigns::Mixed)
    return words("Both signs are there: the line of the ray passes outside the polygon.");
  return words("No two differ in sign: the line of the ray goes through {part}.", {{"part", partWords(at)}});
}

WorkingLine signsLine(const Out &at) {
  std::vector<Chain> products;
  for (const EdgeTerms &edge : at.edges)
    products.push_back(withResult(edge.p));
  return line(std::move(products), commonSignWords(at));
}

std::string sumWords(const Out &at) {
  if (sign(*numberOf(at.S)) != 0)
    return words("All products together.");
  if (hasNoDirection(at))
    return words("Zero, because {r} is the zero vector: there is no ray.", at.letters);
  return at.isConvex() ? words("Zero: the ray crosses the polygon's plane nowhere, or runs inside it.")
                       : words("Zero: the products alone do not tell why.");
}

WorkingLine sumLine(const Out &at) { return asked(withNumbers(at.S == sumOf(at.edges)), sumWords(at)); }

void addPlaneLines(const Out &at, Explanation &lines) {
  lines.add("normal", [&at] {
    const Term &first = at.edges[0].e;
    const Term &second = at.edges[1].e;
    return asked(withProducts(at.n == cross(first, second)),
                 words("Two edges of the polygon give a normal of its plane."),
                 {{cross(second, first), words("{answer} is the cross product the other way round.")}});
  });
  if (!at.meet.crosses())
    return;
  lines.add("t", [&at] {
    return asked(withNumbers(at.t == dot(at.corner(0) - at.Q, at.n) / dot(at.r, at.n)),
                 at.meet.t < 0
                     ? words("Negative: the line crosses the plane before the ray's start {Q}.", at.letters)
                     : words("Not negative: the ray itself gets to the plane."),
                 {wrongSignOf(at.t, at)});
  });
  lines.add("hit", [&at] {
    return asked(withNumbers(at.I == at.Q + at.t * at.r),
                 words("Here the line of the ray crosses the polygon's plane."));
  });
}

void addWeightLines(const Out &at, Explanation &lines) {
  const auto add = [&](const char *id, const Term &weight, std::size_t opposite) {
    lines.add(id, [&at, weight, opposite] {
      return asked(withNumbers(weight == at.edges[opposite].p / at.S),
                   words("The weight of {corner}: the product of the edge opposite to it, as a share of S.",
                         {{"corner", plainText(at.corner(opposite + 2))}}));
    });
  };
  add("rho", at.weights->rho, 1);
  add("sigma", at.weights->sigma, 2);
  add("tau", at.weights->tau, 0);
  lines.add("mix", [&at] {
    const auto &[rho, sigma, tau] = *at.weights;
    return asked(withNumbers(at.I == rho * at.corner(0) + sigma * at.corner(1) + tau * at.corner(2)),
                 words("The corners mixed with these weights give the point {I}.", at.letters));
  });
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("moment", [&at] { return momentLine(at.m, at.Q, at.r, words("The moment of the ray's line.")); });
  for (std::size_t i = 0; i < at.edges.size(); ++i)
    addEdgeLines(at, i, lines);
  lines.add("signs", [&at] { return signsLine(at); });
  lines.add("sum", [&at] { return sumLine(at); });
  if (at.isConvex())
    addPlaneLines(at, lines);
  if (at.weights)
    addWeightLines(at, lines);
  return lines;
}

/// The part of an edge that its arrow covers: the head stands clear of the corner, near the middle.
constexpr double arrowPart = 0.6;

/// In the colour of its sign, with an arrow that says which way it runs.
void drawEdge(Figure &figure, const Out &at, std::size_t index) {
  const EdgeTerms &edge = at.edges[index];
  const Place from = place(at.corner(index));
  const Place way = place(edge.e);
  if (isZero(vectorOf(edge.e)))
    return;
  const Rational &product = at.meet.products[index];
  const Subject subject = product > 0 ? Subject::EdgeU : product < 0 ? Subject::EdgeV : Subject::Measure;
  MarkBase base = drawn(edge.p, Role::Derived, subject);
  base.numbers = relatedLatex(calculated(edge.p));
  const std::string arrow = base.id + "/way";
  figure.add(SegmentMark{std::move(base), from, place(at.corner(index + 1))});
  figure.add(ArrowMark{{arrow, Role::Derived, subject}, from, way * arrowPart});
}

/// In units of the picture: only its direction matters.
constexpr double drawnNormalLength = 3;

Figure draw(const In &in, const Out &at) {
  Figure figure;
  for (std::size_t i = 0; i < at.edges.size(); ++i)
    drawEdge(figure, at, i);
  if (at.isConvex())
    figure.add(arrowOfLength(drawn(at.n, Role::Derived, Subject::Plane), place(at.corner(1)), vectorOf(at.n),
                             drawnNormalLength));
  if (!at.meet.crosses())
    return figure;
  const Place point = place(at.I);
  if (at.meet.t >= 0)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{at.I->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  const bool isHit = at.meet.which == RayPolygonCase::Hit;
  figure.add(pointOf(at.I, isHit ? Role::Result : Role::Ghost, Subject::Ray));
  return figure;
}

/// The ray moved sideways until its line meets a corner or an edge; none of those that it meets already.
void addShifted(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  const auto &corners = in.W.object.corners;
  const RayObject &ray = in.L.object;
  const auto add = [&](const ExactVec3 &shift, const char *location, std::size_t feature,
                       std::string sentence) {
    if (!isZero(shift))
      all.push_back({"location = " + std::string(location) + " and feature = " + std::to_string(feature),
                     std::move(sentence), "L", RayObject{ray.origin + shift, ray.direction}});
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add(projectVector(ExactVec3(corners[i] - ray.origin), ray.direction).rejection, "vertex", i,
        words("The ray's line would go through the corner {corner}.", {{"corner", plainText(at.corner(i))}}));
    if (const auto shift = shiftOntoSegment(ray, corners[i], corners[(i + 1) % corners.size()]))
      add(*shift, "edge", i,
          words("The ray's line would go through the edge {edge}.", {{"edge", at.edgeNamed(i)}}));
  }
}

/// The ray moved until it starts in the plane, or turned until it runs along it.
void addAlongPlane(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  const auto &[origin, direction] = in.L.object;
  const ExactVec3 normal = vectorOf(at.n);
  const ExactVec3 offPlane = projectVector(ExactVec3(origin - in.W.object.corners[0]), normal).projection;
  const bool startsInPlane = isZero(offPlane);
  if (!startsInPlane)
    all.push_back({"t = 0", words("{Q} would lie in the polygon's plane.", at.letters), "L",
                   RayObject{origin - offPlane, direction}});
  if (const ExactVec3 turned = projectVector(direction, normal).rejection; !isZero(turned))
    all.push_back({startsInPlane ? "case = in-plane" : "case = parallel",
                   startsInPlane ? words("The ray would lie in the polygon's plane.")
                                 : words("The ray would run parallel to the polygon's plane."),
                   "L", RayObject{origin, turned}});
}

/// The polygon with all corners moved into the plane of the first ones.
SpecialCase flattened(const In &in) {
  PolygonObject flat = in.W.object;
  const Plane<Rational> plane = planeOf<Rational>(weighted(flat.corners));
  for (ExactVec3 &corner : flat.corners)
    corner -= plane.normal * Rational(evaluate(plane, corner) / dot(plane.normal, plane.normal));
  return {"case != not-planar", words("The corners would lie in one plane."), "W", flat};
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (isZero(in.L.object.direction))
    return all;
  if (at.shape == PolygonShape::NotPlanar)
    return {flattened(in)};
  if (!at.meet.crosses())
    return all;
  addShifted(in, at, all);
  addAlongPlane(in, at, all);
  return all;
}

/// The lines of the edges stand together edge by edge.
std::vector<std::string> lineNames() {
  std::vector<std::string> names{"moment"};
  for (std::size_t i = 0; i < mostCorners; ++i)
    for (const char *word : {"e", "m", "edge"})
      names.push_back(word + std::to_string(i));
  return joined({names, {"signs", "sum", "normal", "t", "hit", "rho", "sigma", "tau", "mix"}});
}

} // namespace

Construction ray_polygon_pluecker() {
  return makeConstruction<In, Out, PolygonObject, RayObject>(
      "ray-polygon-pluecker", {"W", "L"}, {{"I", "point"}},
      joined({{"m", "S", "n", "t", "ρ", "σ", "τ"},
              numbered("e", mostCorners),
              numbered("m", mostCorners),
              numbered("p", mostCorners)}),
      {.cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "not-planar",
                 "not-convex"},
       .values = {named::list("products", mostCorners), named::number("sum"),
                  named::word("signs", {"same", "mixed", "zero"}),
                  named::word("location", {"interior", "edge", "vertex", "outside"}), named::index("feature"),
                  named::number("t"), named::vector("point"), named::list("barycentric", 3)},
       .lines = lineNames(),
       .marks = joined({numbered("p", mostCorners), {"n", "I"}})},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
