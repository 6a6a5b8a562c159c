#include "lessons/construction/parts/ray_triangle_cases.h"

#include "geometry/point_line.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/parts/shifted_ray.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

using CornerTerms = std::array<const Term *, 3>;

CornerTerms termsIn(const TriangleTerms &corners) { return {&corners.P0, &corners.P1, &corners.P2}; }

std::array<ExactVec3, 3> placesOf(const TriangleObject &triangle) {
  return {triangle.p0, triangle.p1, triangle.p2};
}

const Term &cornerAt(const TriangleTerms &corners, int index) {
  return *termsIn(corners).at(static_cast<std::size_t>(index));
}

/// What the ray would be, moved sideways, whose line meets a corner or an edge; none of the kind that it
/// meets already.
void addShifted(const RayAtTriangle &at, std::vector<SpecialCase> &all) {
  const auto corners = placesOf(at.in.T.object);
  const CornerTerms names = termsIn(at);
  const auto place = [](const std::string &location, std::size_t feature) {
    return both(is("location", location), is("feature", std::to_string(feature)));
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    addRayThrough(
        at.in.L.object, corners.at(i), place("vertex", i),
        words("The ray's line would go through the corner {corner}.", {{"corner", plainText(*names.at(i))}}),
        all);
    addRayThrough(at.in.L.object, {corners.at(i), corners.at(next)},
                  place("edge", 3 - i - next), // the corner opposite to it
                  words("The ray's line would go through the edge {edge}.",
                        {{"edge", edgeName((*names.at(i))->symbol, (*names.at(next))->symbol)}}),
                  all);
  }
}

/// The edge or the corner that a point lies on, for sentences: {edge}, {corner}.
WordValues placeValues(const FaceLocation &location, const TriangleTerms &corners) {
  switch (location.part) {
  case FacePart::Edge: // named by the corner opposite to it
    return {{"edge", edgeName(cornerAt(corners, location.feature == 0 ? 1 : 0)->symbol,
                              cornerAt(corners, location.feature == 2 ? 1 : 2)->symbol)}};
  case FacePart::Vertex:
    return {{"corner", plainText(cornerAt(corners, location.feature))}};
  case FacePart::Interior:
  case FacePart::Outside:
    break;
  }
  return {};
}

} // namespace

std::string placeWords(const FaceLocation &location, const TriangleTerms &corners,
                       const PlaceSentences &sentences, WordValues values) {
  for (auto &value : placeValues(location, corners))
    values.push_back(std::move(value));
  return words(sentenceFor(location.part, sentences), values);
}

std::pair<Term, Term> coincidentCorners(const TriangleObject &triangle, const TriangleTerms &corners) {
  const auto &[p0, p1, p2] = triangle;
  return {p0 == p1 || p0 == p2 ? corners.P0 : corners.P1, p0 == p1 ? corners.P1 : corners.P2};
}

std::string coincidentWords(const TriangleObject &triangle, const TriangleTerms &corners,
                            const CoincidentSentences &sentences) {
  const auto &[p0, p1, p2] = triangle;
  if (p0 == p1 && p0 == p2)
    return words(sentences.three.english, {{"first", plainText(corners.P0)},
                                           {"second", plainText(corners.P1)},
                                           {"third", plainText(corners.P2)}});
  const auto [first, second] = coincidentCorners(triangle, corners);
  return words(sentences.two.english, {{"first", plainText(first)}, {"second", plainText(second)}});
}

Surd cosineOf(const TrianglePerps<Rational> &perps) {
  const Rational squares = perps.uu * perps.vv;
  return squares == 0 ? Surd() : overRoot(perps.uv, squares);
}

void addFlattened(const TriangleObject &triangle, const Naming &naming, std::vector<SpecialCase> &all) {
  const auto corners = placesOf(triangle);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactVec3 &from = corners.at((i + 1) % corners.size());
    const ExactVec3 &to = corners.at((i + 2) % corners.size());
    std::array flat = corners;
    flat.at(i) = measurePointLine(corners.at(i), from, ExactVec3(to - from)).foot;
    if (flat.at(i) != from && flat.at(i) != to)
      all.push_back({is("case", "collinear"),
                     words("{P0}, {P1} and {P2} would lie on one line.", naming.letters), "T",
                     TriangleObject{flat[0], flat[1], flat[2]}});
  }
}

ArrowMark wayToHit(const Term &w, const Place &p0) {
  return inLook({Hue::Red}, arrowOf(w, p0, Role::Derived, Subject::Ray));
}

WorkingLine sidesNormalLine(const Term &n, const Term &u, const Term &v, std::string sentence) {
  return asked(withProducts(n == cross(u, v)), std::move(sentence),
               {{cross(v, u), words("{answer} is the cross product the other way round: v × u.")}});
}

std::vector<SpecialCase> rayTriangleNearby(const RayAtTriangle &at) {
  std::vector<SpecialCase> all;
  const ExactVec3 normal = perpsOf(at.triangle).normal;
  const RayObject &ray = at.in.L.object;
  if (isZero(normal) || isZero(ray.direction))
    return all;
  addFlattened(at.in.T.object, at, all);
  if (dot(ray.direction, normal) != 0)
    addShifted(at, all);
  addRaysAtPlane(ray, {at.triangle.p0, normal},
                 {words("{Q} would lie in the triangle's plane.", at.letters),
                  words("The ray would lie in the triangle's plane."),
                  words("The ray would run parallel to the triangle's plane.")},
                 all);
  return all;
}

} // namespace halfspace
