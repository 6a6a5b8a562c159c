// Whether a ray goes through a convex polygon, by the signs of its products with the edges (note PL).
#include "geometry/case_names.h"
#include "geometry/intersect_ray_polygon.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/flattened_polygon.h"
#include "lessons/construction/parts/place_rows.h"
#include "lessons/construction/parts/plucker_edges.h"
#include "lessons/construction/parts/product_signs.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/parts/shifted_ray.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/polygon.h"

#include <algorithm>
#include <numeric>

namespace halfspace {
namespace {

constexpr std::size_t mostCorners = 8;

struct In : Naming {
  Given<PolygonObject> W;
  Given<RayObject> L;
};

std::vector<EdgeTerms> edgesOf(const In &in, const std::vector<Term> &corners,
                               const std::vector<Rational> &products) {
  std::vector<EdgeTerms> edges;
  const auto &places = in.W.object.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    edges.push_back(edgeTerms(in, i, lineThrough(places[i], places[next]), products[i], corners[i],
                              corners[next] - corners[i]));
  }
  return edges;
}

RayPolygon<Rational> meetOf(const Ray<Rational> &ray, const std::vector<ExactVec3> &corners,
                            PolygonShape shape) {
  if (shape == PolygonShape::Convex)
    return intersectRayPolygon<Rational>(ray, corners);
  RayPolygon<Rational> meet;
  meet.products = productsWithEdges<Rational>(lineOf(ray), corners);
  return meet;
}

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  const std::vector<ExactVec3> &places = in.W.object.corners;
  Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  PolygonShape shape = shapeOf(places);
  bool isConvex = shape == PolygonShape::Convex;
  RayPolygon<Rational> meet =
      meetOf(ray, places, shape); ///< of a polygon that is not convex only the products
  bool crosses = meet.crosses();
  bool hasDirection = !isZero(ray.direction);
  Rational whole = std::accumulate(meet.products.begin(), meet.products.end(), Rational(0));

  std::vector<Term> corners = cornerTermsOf(in.W);
  /// The moment of the ray's line.
  Term m = ownName(vectorLetter("m"), lineOf(ray).moment).standingFor(cross(Q, r));
  std::vector<EdgeTerms> edges =
      edgesOf(in, corners, meet.products); ///< edge i runs from corner i to the next
  Term S = ownName(letter("S"), whole);
  Term n = drawnName(vectorLetter("n"), planeThrough(places[0], places[1], places[2]).normal);
  Term t = ownName(letter("t"), meet.t);
  Term I = madeName("I", meet.point);
  /// Where a triangle's plane is crossed, how much of each corner the point has in it: the weight of a corner
  /// belongs to the edge opposite to it, that of P0 to the edge from P1.
  bool hasWeights = places.size() == 3 && crosses;
  Term rho = ownName(letter("ρ"), weightOf(1));
  Term sigma = ownName(letter("σ"), weightOf(2));
  Term tau = ownName(letter("τ"), weightOf(0));

  [[nodiscard]] const Term &corner(std::size_t index) const { return corners.at(index % corners.size()); }
  [[nodiscard]] std::string edgeNamed(std::size_t index) const {
    return edgeName(corner(index)->symbol, corner(index + 1)->symbol);
  }
  [[nodiscard]] Rational weightOf(std::size_t edge) const {
    return hasWeights ? Rational(meet.products[edge] / whole) : Rational(0);
  }
};

/// The sentence for the part of the polygon that the line goes through.
std::string partWords(const Out &at, const PlaceSentences &sentences) {
  const FaceLocation &location = at.meet.location;
  const auto feature = static_cast<std::size_t>(std::max(location.feature, 0));
  return words(
      sentenceFor(location.part, sentences),
      {{"t", equation(at.t)}, {"edge", at.edgeNamed(feature)}, {"corner", plainText(at.corner(feature))}});
}

/// Why corners in a plane are not those of a convex polygon.
std::string notConvexWords(const Out &at) {
  const auto &places = at.in.W.object.corners;
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
  switch (at.meet.which) {
  case RayPolygonCase::Hit:
    return {
        caseName,
        partWords(
            at,
            {says("No two products differ in sign: the ray goes through the inside of the polygon, at {t}."),
             says("No two products differ in sign: the ray goes through the edge {edge}, at {t}."),
             says("No two products differ in sign: the ray goes through the corner {corner}, at {t}.")})};
  case RayPolygonCase::Behind:
    return {
        caseName,
        partWords(at, {says("No two products differ in sign, so the line of the ray goes through the inside "
                            "of the polygon. But {t} is negative: that is behind the ray's start."),
                       says("No two products differ in sign, so the line of the ray goes through the edge "
                            "{edge}. But {t} is negative: that is behind the ray's start."),
                       says("No two products differ in sign, so the line of the ray goes through the corner "
                            "{corner}. But {t} is negative: that is behind the ray's start.")})};
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

CaseWords tell(const Out &at) {
  if (isZero(at.in.L.object.direction))
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
  return {"not-convex", notConvexWords(at), true};
}

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

bool hasEdge(const Out &at, std::size_t index) { return index < at.edges.size(); }

WorkingLine edgeLine(const Out &at, std::size_t index) {
  const Term &from = at.corner(index);
  const Term &to = at.corner(index + 1);
  return asked(withNumbers(at.edges[index].e == to - from),
               words("The edge {edge}, from one corner to the next.", {{"edge", at.edgeNamed(index)}}),
               {{from - to, words("{answer} points backwards: take the end minus the start.")}});
}

WorkingLine edgeMomentLine(const Out &at, std::size_t index) {
  const EdgeTerms &edge = at.edges[index];
  return momentLine(edge.m, at.corner(index), edge.e, words("The moment of its line."));
}

WorkingLine edgeProductLine(const Out &at, std::size_t index) {
  return productLine(at, at.m, at.edges[index], signWords(at, index));
}

std::string commonSignWords(const Out &at) {
  const ProductSigns signs = signsOf(at.meet.products);
  if (!at.hasDirection)
    return allZeroWithoutRay(at);
  if (!at.isConvex)
    return words("The signs say which way the ray passes each edge. They decide for a flat, convex polygon "
                 "only.");
  if (signs == ProductSigns::Zero)
    return words("All are 0: the ray and all edges lie in one plane.");
  if (signs == ProductSigns::Mixed)
    return words("Both signs are there: the line of the ray passes outside the polygon.");
  return partWords(
      at, {says("No two differ in sign: the line of the ray goes through the inside of the polygon."),
           says("No two differ in sign: the line of the ray goes through the edge {edge}."),
           says("No two differ in sign: the line of the ray goes through the corner {corner}.")});
}

std::string sumWords(const Out &at) {
  if (sign(*numberOf(at.S)) != 0)
    return words("All products together.");
  if (!at.hasDirection)
    return zeroWithoutRay(at);
  return at.isConvex ? words("Zero: the ray crosses the polygon's plane nowhere, or runs inside it.")
                     : words("Zero: the products alone do not tell why.");
}

WorkingLine normalLine(const Out &at) {
  const Term &first = at.edges[0].e;
  const Term &second = at.edges[1].e;
  return asked(withProducts(at.n == cross(first, second)),
               words("Two edges of the polygon give a normal of its plane."),
               {{cross(second, first), words("{answer} is the cross product the other way round.")}});
}

WorkingLine parameterLine(const Out &at) {
  return asked(withNumbers(at.t == dot(at.corner(0) - at.Q, at.n) / dot(at.r, at.n)),
               at.meet.t < 0
                   ? words("Negative: the line crosses the plane before the ray's start {Q}.", at.letters)
                   : words("Not negative: the ray itself gets to the plane."),
               {wrongSignOf(at.t, at)});
}

WorkingLine weightLine(const Out &at, const Term &weight, std::size_t opposite) {
  return asked(withNumbers(weight == at.edges[opposite].p / at.S),
               words("The weight of {corner}: the product of the edge opposite to it, as a share of S.",
                     {{"corner", plainText(at.corner(opposite + 2))}}));
}

WorkingLine signsLine(const Out &at) { return resultsLine(productsOf(at.edges), commonSignWords(at)); }

Chain sumOf(const Out &at) { return withNumbers(at.S == sum(productsOf(at.edges))); }

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {{{"moment", always,
         [](const Out &at) { return momentLine(at.m, at.Q, at.r, words("The moment of the ray's line.")); }}},
       linesOfEach<Out>(mostCorners, hasEdge,
                        {{"e", edgeLine}, {"m", edgeMomentLine}, {"edge", edgeProductLine}}),
       {{"signs", always, signsLine},
        {"sum", always, sumOf, sumWords},
        {"normal", &Out::isConvex, normalLine},
        {"t", &Out::crosses, parameterLine},
        {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.I == at.Q + at.t * at.r); },
         says("Here the line of the ray crosses the polygon's plane.")},
        {"rho", &Out::hasWeights, [](const Out &at) { return weightLine(at, at.rho, 1); }},
        {"sigma", &Out::hasWeights, [](const Out &at) { return weightLine(at, at.sigma, 2); }},
        {"tau", &Out::hasWeights, [](const Out &at) { return weightLine(at, at.tau, 0); }},
        {"mix", &Out::hasWeights,
         [](const Out &at) {
           return withNumbers(at.I ==
                              at.rho * at.corner(0) + at.sigma * at.corner(1) + at.tau * at.corner(2));
         },
         says("The corners mixed with these weights give the point {I}.")}}});
}

/// In units of the picture: only its direction matters.
constexpr double drawnNormalLength = 3;

Figure draw(const Out &at) {
  Figure figure;
  for (std::size_t i = 0; i < at.edges.size(); ++i)
    addEdge(figure, at.edges[i], at.corner(i), at.corner(i + 1), relatedLatex(calculated(at.edges[i].p)));
  if (at.isConvex)
    addDirection(figure, at.n, place(at.corner(1)), drawnNormalLength, Role::Derived, Subject::Plane);
  if (at.crosses)
    addMeeting(figure, at.in.L, at.I, at.meet.t >= 0, at.meet.which == RayPolygonCase::Hit);
  return figure;
}

/// The ray moved sideways until its line meets a corner or an edge; none of those that it meets already.
void addShifted(const Out &at, std::vector<SpecialCase> &all) {
  const RayObject &ray = at.in.L.object;
  for (std::size_t i = 0; i < at.places.size(); ++i) {
    const Conditions feature = is("feature", std::to_string(i));
    addRayThrough(
        ray, at.places[i], both(is("location", "vertex"), feature),
        words("The ray's line would go through the corner {corner}.", {{"corner", plainText(at.corner(i))}}),
        all);
    addRayThrough(
        ray, {at.places[i], at.places[(i + 1) % at.places.size()]}, both(is("location", "edge"), feature),
        words("The ray's line would go through the edge {edge}.", {{"edge", at.edgeNamed(i)}}), all);
  }
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasDirection)
    return all;
  if (at.shape == PolygonShape::NotPlanar)
    return {{isNot("case", "not-planar"), words("The corners would lie in one plane."), "W",
             flattenedPolygon(at.in.W.object)}};
  if (!at.crosses)
    return all;
  addShifted(at, all);
  addRaysAtPlane(at.in.L.object, {at.places[0], vectorOf(at.n)},
                 {words("{Q} would lie in the polygon's plane.", at.letters),
                  words("The ray would lie in the polygon's plane."),
                  words("The ray would run parallel to the polygon's plane.")},
                 all);
  return all;
}

/// The one edge whose product is the largest without its sign; none where several are.
std::optional<std::size_t> largestEdge(const Out &at) {
  std::vector<std::size_t> edges(at.meet.products.size());
  std::iota(edges.begin(), edges.end(), 0);
  const auto size = [&](std::size_t edge) { return abs(at.meet.products[edge]); };
  std::ranges::sort(edges, std::greater(), size);
  return size(edges[0]) == size(edges[1]) ? std::nullopt : std::optional(edges[0]);
}

ValueTable<Out> values() {
  return joined<ValueRow<Out>>(
      {{{named::list("products", mostCorners), always,
         [](const Out &at) { return list(productsOf(at.edges)); }},
        {named::number("sum"), always, &Out::S},
        signsRow<Out>([](const Out &at) { return signsOf(at.meet.products); }),
        {named::index("largest_edge"), [](const Out &at) { return largestEdge(at).has_value(); },
         [](const Out &at) { return Value(static_cast<int>(*largestEdge(at))); }}},
       placeRows<Out>(&Out::crosses, [](const Out &at) { return at.meet.location; }),
       {{named::number("t"), &Out::crosses, &Out::t},
        {named::vector("point"), &Out::crosses, &Out::I},
        {named::list("barycentric", 3), &Out::hasWeights, [](const Out &at) {
           return list({at.rho, at.sigma, at.tau});
         }}}});
}

} // namespace

Construction ray_polygon_pluecker() {
  return taught<Out, PolygonObject, RayObject>(
      {.id = "ray-polygon-pluecker",
       .word = "intersect",
       .title = [] { return words("where the ray meets the polygon"); },
       .roles = {"W", "L"},
       .makes = {{"I", &Out::crosses, &Out::I}},
       .letters = joined({{"m", "S", "n", "t", "ρ", "σ", "τ"},
                          numbered("e", mostCorners),
                          numbered("m", mostCorners),
                          numbered("p", mostCorners)}),
       .cases = {"hit", "behind", "miss", "parallel", "in-plane", "zero-direction", "not-planar",
                 "not-convex"},
       .values = values(),
       .lines = lines(),
       .marks = joined({numbered("p", mostCorners), {"n", "I"}}),
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
