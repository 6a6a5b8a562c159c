#include "lessons/construction/parts/ray_triangle_cases.h"

#include "geometry/point_line.h"
#include "geometry/project_vector.h"
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
void addShifted(const TriangleObject &triangle, const RayObject &ray, const TriangleTerms &terms,
                std::vector<SpecialCase> &all) {
  const auto add = [&](const ExactVec3 &shift, const std::string &location, std::size_t feature,
                       std::string sentence) {
    if (!isZero(shift))
      all.push_back({"location = " + location + " and feature = " + std::to_string(feature),
                     std::move(sentence), "L", RayObject{ray.origin + shift, ray.direction}});
  };
  const auto corners = placesOf(triangle);
  const CornerTerms names = termsIn(terms);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    add(projectVector(ExactVec3(corners.at(i) - ray.origin), ray.direction).rejection, "vertex", i,
        words("The ray's line would go through the corner {corner}.", {{"corner", plainText(*names.at(i))}}));
    if (const auto shift = shiftOntoSegment(ray, corners.at(i), corners.at(next)))
      add(*shift, "edge", 3 - i - next, // the corner opposite to it
          words("The ray's line would go through the edge {edge}.",
                {{"edge", edgeName((*names.at(i))->symbol, (*names.at(next))->symbol)}}));
  }
}

} // namespace

std::string placeWords(const FaceLocation &location, const TriangleTerms &corners) {
  switch (location.part) {
  case FacePart::Interior:
    return words("inside the triangle");
  case FacePart::Edge: // named by the corner opposite to it
    return words("on the edge {edge}",
                 {{"edge", edgeName(cornerAt(corners, location.feature == 0 ? 1 : 0)->symbol,
                                    cornerAt(corners, location.feature == 2 ? 1 : 2)->symbol)}});
  case FacePart::Vertex:
    return words("at the corner {corner}", {{"corner", plainText(cornerAt(corners, location.feature))}});
  case FacePart::Outside:
    break;
  }
  return words("outside the triangle");
}

std::string coincidentWords(const TriangleObject &triangle, const TriangleTerms &corners) {
  const auto &[p0, p1, p2] = triangle;
  if (p0 == p1 && p0 == p2)
    return words("{first}, {second} and {third} are the same point", {{"first", plainText(corners.P0)},
                                                                      {"second", plainText(corners.P1)},
                                                                      {"third", plainText(corners.P2)}});
  const Term &first = p0 == p1 || p0 == p2 ? corners.P0 : corners.P1;
  const Term &second = p0 == p1 ? corners.P1 : corners.P2;
  return words("{first} and {second} are the same point",
               {{"first", plainText(first)}, {"second", plainText(second)}});
}

void addFlattened(const TriangleObject &triangle, const Naming &naming, std::vector<SpecialCase> &all) {
  const auto corners = placesOf(triangle);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactVec3 &from = corners.at((i + 1) % corners.size());
    const ExactVec3 &to = corners.at((i + 2) % corners.size());
    std::array flat = corners;
    flat.at(i) = measurePointLine(corners.at(i), from, ExactVec3(to - from)).foot;
    if (flat.at(i) != from && flat.at(i) != to)
      all.push_back({"case = collinear", words("{P0}, {P1} and {P2} would lie on one line.", naming.letters),
                     "T", TriangleObject{flat[0], flat[1], flat[2]}});
  }
}

ArrowMark wayToHit(const Term &w, const Place &p0) {
  return inLook({Hue::Red}, arrowOf(w, p0, Role::Derived, Subject::Ray));
}

std::vector<SpecialCase> rayTriangleNearby(const TriangleObject &triangle, const RayObject &ray,
                                           const TriangleTerms &corners, const Naming &naming) {
  std::vector<SpecialCase> all;
  const auto &[origin, direction] = ray;
  const ExactVec3 normal = cross(ExactVec3(triangle.p1 - triangle.p0), ExactVec3(triangle.p2 - triangle.p0));
  if (isZero(normal) || isZero(direction))
    return all;
  addFlattened(triangle, naming, all);
  const ExactVec3 offPlane = projectVector(ExactVec3(origin - triangle.p0), normal).projection;
  const bool startsInPlane = isZero(offPlane);
  if (dot(direction, normal) == 0) {
    if (!startsInPlane)
      all.push_back({"case = in-plane", words("The ray would lie in the triangle's plane."), "L",
                     RayObject{origin - offPlane, direction}});
    return all;
  }
  addShifted(triangle, ray, corners, all);
  if (!startsInPlane)
    all.push_back({"t = 0", words("{Q} would lie in the triangle's plane.", naming.letters), "L",
                   RayObject{origin - offPlane, direction}});
  if (const ExactVec3 turned = projectVector(direction, normal).rejection; !isZero(turned))
    all.push_back({startsInPlane ? "case = in-plane" : "case = parallel",
                   startsInPlane ? words("The ray would lie in the triangle's plane.")
                                 : words("The ray would run parallel to the triangle's plane."),
                   "L", RayObject{origin, turned}});
  return all;
}

} // namespace halfspace
