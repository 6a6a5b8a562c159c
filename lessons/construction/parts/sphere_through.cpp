#include "lessons/construction/parts/sphere_through.h"

namespace halfspace {
namespace {

std::array<ExactVec3, 4> placesOf(const std::array<Term, 4> &points) {
  return {vectorOf(points[0]), vectorOf(points[1]), vectorOf(points[2]), vectorOf(points[3])};
}

std::array<Term, 3> sidesOf(const Naming &naming, const std::array<ExactVec3, 3> &sides) {
  return {drawnName(naming, vectorLetter("u"), sides[0]), drawnName(naming, vectorLetter("v"), sides[1]),
          drawnName(naming, vectorLetter("w"), sides[2])};
}

std::array<Term, 3> normalsOf(const Naming &naming, const std::array<ExactVec3, 3> &normals) {
  return {ownName(naming, vectorLetter("n", "1"), normals[0]),
          ownName(naming, vectorLetter("n", "2"), normals[1]),
          ownName(naming, vectorLetter("n", "3"), normals[2])};
}

/// Of some of the points, for a sentence that says why they have no sphere of their own.
WordValues lettersOf(const SphereThrough &at, const std::vector<std::size_t> &points) {
  static constexpr std::array places{"first", "second", "third"};
  WordValues values;
  for (const std::size_t point : points)
    values.emplace_back(places.at(values.size()), plainText(at.corners.at(point)));
  return values;
}

/// Three different points on one line.
std::optional<WordValues> threeOnALine(const SphereThrough &at) {
  const std::array<ExactVec3, 4> points = placesOf(at.corners);
  for (std::size_t left = points.size(); left-- > 0;) { // all but one
    std::vector<std::size_t> three;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i != left)
        three.push_back(i);
    const ExactVec3 first = points.at(three[1]) - points.at(three[0]);
    const ExactVec3 second = points.at(three[2]) - points.at(three[0]);
    if (isZero(cross(first, second)) && !isZero(first) && !isZero(second) && first != second)
      return lettersOf(at, three);
  }
  return {};
}

std::optional<WordValues> twoThatAreOne(const SphereThrough &at) {
  const std::array<ExactVec3, 4> points = placesOf(at.corners);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i + 1; k < points.size(); ++k)
      if (points.at(i) == points.at(k))
        return lettersOf(at, {i, k});
  return {};
}

std::string noSphereWords(const SphereThrough &at) {
  if (const auto three = threeOnALine(at))
    return words("{first}, {second} and {third} lie on one line, and a sphere meets a line in two points at "
                 "most: no sphere goes through all of them.",
                 *three);
  return words(
      "The four points lie in one plane, but not on one circle: no sphere goes through all of them.");
}

std::string manySpheresWords(const SphereThrough &at) {
  if (const auto two = twoThatAreOne(at))
    return words("{first} and {second} are the same point: through what is left go infinitely many spheres.",
                 *two);
  return words("The four points lie on one circle: infinitely many spheres go through it.");
}

} // namespace

SphereThrough::SphereThrough(const Naming &naming, const std::array<Term, 4> &points)
    : corners(points), found(circumsphereOf(placesOf(points))), sides(sidesOf(naming, found.sides)),
      normals(normalsOf(naming, found.normals)), V(ownName(naming, letter("V"), found.determinant)),
      M(madeName(naming, "M", found.center)),
      R(madeName(naming, "S", "R", found.radius).marked(naming.mark("S"))) {}

CaseWords tellSphereThrough(const SphereThrough &at) {
  switch (at.found.which) {
  case CircumsphereCase::Sphere:
    return {"sphere",
            words("One sphere goes through all four points, with the centre {center} and the radius "
                  "{radius}.",
                  {{"center", equation(at.M)}, {"radius", equation(at.R)}})};
  case CircumsphereCase::NoSphere:
    return {"no-sphere", noSphereWords(at), true};
  case CircumsphereCase::ManySpheres:
    break;
  }
  return {"many-spheres", manySpheresWords(at), true};
}

WorkingLine sideLine(const SphereThrough &at, std::size_t index) {
  const Term &from = at.corners[0];
  const Term &to = at.corners.at(index + 1);
  return asked(withNumbers(at.sides.at(index) == to - from),
               words("From {from} to {to}.", {{"from", plainText(from)}, {"to", plainText(to)}}),
               {{from - to, words("{answer} points backwards: take the end minus the start.")}});
}

WorkingLine equationLine(const SphereThrough &at, std::size_t index) {
  const Term &side = at.sides.at(index);
  const Term anywhere = list({unknown("x"), unknown("y"), unknown("z")}); // a point may be called P
  const Term left = dot(side, anywhere - at.corners[0]) - dot(side, side) / 2;
  return askedEquation(
      condition((0 == left).then(numbersPutIn(left)).then(calculated(left))),
      words("This holds for the points (x, y, z) that are as far from {from} as from {to}: in the squares of "
            "both distances x², y² and z² are the same.",
            {{"from", plainText(at.corners[0])}, {"to", plainText(at.corners.at(index + 1))}}));
}

WorkingLine crossLine(const SphereThrough &at, std::size_t index) {
  const Term &first = at.sides.at((index + 1) % 3);
  const Term &second = at.sides.at((index + 2) % 3);
  return asked(withProducts(at.normals.at(index) == cross(first, second)), {},
               {{cross(second, first), words("{answer} is the cross product the other way round.")}});
}

WorkingLine volumeLine(const SphereThrough &at) {
  return asked(
      withProducts(at.V == dot(at.sides[0], at.normals[0])),
      at.hasSphere
          ? words("The determinant of the three equations. It is not 0: one point fulfils all of them.")
          : words("The determinant of the equations for the centre is 0: the four points "
                  "lie in one plane."),
      {{-at.V, words("{answer} has the wrong sign.")}});
}

WorkingLine centerLine(const SphereThrough &at) {
  const auto &[u, v, w] = at.sides;
  const auto &[n1, n2, n3] = at.normals;
  const Term top = dot(u, u) * n1 + dot(v, v) * n2 + dot(w, w) * n3;
  const WordValues letters{{"A", plainText(at.corners[0])}};
  return asked(
      withNumbers(at.M == at.corners[0] + top / (2 * at.V)),
      words("The solution of the three equations, by Cramer's rule: the centre."),
      {{top / (2 * at.V),
        words("{answer} is the way from {A} to the centre: {A} is still to be added.", letters)},
       {at.corners[0] + top / at.V, words("{answer} is twice as far from {A}: divide by 2V.", letters)}});
}

WorkingLine radiusLine(const SphereThrough &at) {
  const Term way = at.M - at.corners[0];
  return asked(
      withNumbers(at.R == norm(way)), words("The radius: how far the centre is from any of the four."),
      {{dot(way, way), words("{answer} is the square of the radius: its root is still to be taken.")}});
}

WorkingLine checkLine(const SphereThrough &at) {
  return resultsLine({norm(at.M - at.corners[1]), norm(at.M - at.corners[2]), norm(at.M - at.corners[3])},
                     words("The others are as far from the centre."));
}

Figure drawSphereThrough(const Naming &naming, const SphereThrough &at) {
  Figure figure;
  const Place first = place(at.corners[0]);
  for (const Term &side : at.sides)
    if (!isZero(vectorOf(side)))
      figure.add(arrowOf(side, first, Role::Derived, Subject::Point));
  if (!at.hasSphere)
    return figure;
  figure.add(
      SphereMark{{naming.mark("S"), Role::Result, Subject::Measure, latexOf(naming.made.at("S").symbol)},
                 place(at.M),
                 toDouble(at.found.radius)});
  figure.add(pointOf(at.M, Role::Result, Subject::Measure));
  const std::string radius = naming.mark("radius");
  MarkBase measured{radius, Role::Result, Subject::Measure, latexOf(at.R)};
  measured.coordinates = relatedLatex(calculated(at.R), Fractions::Flat);
  figure.add(SegmentMark{std::move(measured), place(at.M), first});
  for (std::size_t i = 1; i < at.corners.size(); ++i)
    figure.add(SegmentMark{
        {partOf(radius, i), Role::Helper, Subject::Measure}, place(at.M), place(at.corners.at(i))});
  return figure;
}

std::optional<ExactVec3> flattenedCorner(const SphereThrough &at) {
  if (!at.hasSphere)
    return {};
  const ExactVec3 &normal = at.found.normals[2];
  return ExactVec3(vectorOf(at.corners[3]) - normal * Rational(at.found.determinant / dot(normal, normal)));
}

} // namespace halfspace
