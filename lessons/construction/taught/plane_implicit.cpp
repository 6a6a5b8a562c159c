// The implicit equation of a plane: 0 = n·(P − P0), numbers put in, expanded, collected, normalized (note PG
// 1 and 3).
#include "geometry/point_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/made_plane.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/plane.h"

#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
};

/// A vector in the plane with short coordinates, for n ≠ 0.
Term vectorInPlane(const ExactVec3 &normal, const Term &n) {
  if (normal.y == 0 && normal.z == 0)
    return list({0, 2, 0});
  return cross(n, list({1, 0, 0}));
}

struct Out : Computed<In>, PlaneTerms {
  explicit Out(const In &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  Plane<Rational> equation = planeThrough(in.E.object.point, in.E.object.normal);
  bool hasPlane = !isZero(in.E.object.normal);

  Term P = anyPoint(); ///< of space
  Term second = P0 + vectorInPlane(in.E.object.normal, n);
  Term P1 = madeName("P1", second->value).standingFor(second); ///< a second point of the plane
  Term left = dot(n, P - P0);                                  ///< of the equation
};

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return zeroNormalWords(at);
  return {"plane", words("A point P lies in the plane exactly when {equation}.",
                         {{"equation", plainText(equationOf(at))}})};
}

WorkingLine implicitLine(const Out &at) {
  return line(condition(0 == at.left),
              at.hasPlane ? words("P lies in the plane exactly when this dot product is zero.")
                          : words("This dot product is zero for every P, so it tells no plane."));
}

WorkingLine insertLine(const Out &at) {
  return line(condition(Chain(0).then(namesPutIn(at.left)).then(numbersPutIn(at.left))),
              words("The numbers put in, with P = (x, y, z)."));
}

WorkingLine expandLine(const Out &at) {
  return askedEquation(condition((0 == at.left).then(multipliedOut(at.left))),
                       words("Multiplied out, coordinate by coordinate."));
}

WorkingLine collectLine(const Out &at) {
  const Chain collected = (0 == at.left)
                              .then(calculated(dot(at.n, at.P)) - multipliedOut(dot(at.n, at.P0)))
                              .then(calculated(at.left).marked(at.in.E.id));
  const Term onlyAdded = sum(calculated(at.P0)->parts);
  return askedEquation(
      condition(collected),
      words("Collected: the numbers before x, y and z are the coordinates of {n}, and the constant is "
            "−{n}·{P0}.",
            at.letters),
      {{dot(at.n, at.P) + dot(at.n, at.P0),
        words("In {answer} the constant is {n}·{P0}: the minus sign of P − {P0} is lost.", at.letters)},
       {dot(at.n, at.P) - onlyAdded, words("In {answer} the coordinates of {P0} are only added up: each is "
                                           "multiplied by that of {n} first.",
                                           at.letters)}});
}

std::string constantWords(const Out &at) {
  return words("{point}, another point of the plane, gives the same number as {P0}.", at.letters,
               {{"point", equation(at.P1)}});
}

std::string normalizedWords(const Out &at) {
  if (isUnit(at.n))
    return words("|{n}| is 1: the equation is normalized already, so its right side gives distances.",
                 at.letters);
  return words(
      "Divided by the length of the normal, {length}: the normalized form. The plane is the same, and "
      "the right side now gives distances.",
      {{"length", equation(norm(at.n))}});
}

WorkingLine normalizedLine(const Out &at) {
  const Term unit = at.left / norm(at.n);
  return asked(
      condition((0 == unit).then(calculated(at.left) / calculated(norm(at.n))).then(calculated(unit))),
      normalizedWords(at),
      {{at.left, words("{answer} is not normalized: every number is divided by |{n}|.", at.letters)},
       {at.left / dot(at.n, at.n),
        words("{answer} is divided by {n}·{n}: divide by its root, |{n}|.", at.letters)}});
}

WorkingLine scaledLine(const Out &at) {
  const Term twice = dot((2 * at.n).marked(at.mark("kn")), at.P - at.P0);
  return line(
      condition((0 == twice).then(calculated(twice))),
      words("Twice the normal doubles every number and changes nothing: the same points make it zero."));
}

Figure draw(const Out &at) {
  Figure figure;
  const Place point = place(at.P0);
  const Place normal = place(at.n);
  const Place other = place(at.P1);
  if (!at.hasPlane)
    return figure;
  figure.reaches.push_back({at.in.E.id, other});
  figure.add(SegmentMark{{at.P1->mark + "/way", Role::Helper}, point, other});
  figure.add(inLook(at.in.E.look, pointOf(at.P1, Role::Derived, Subject::Plane)));
  figure.add(RightAngleMark{{at.P1->mark + "/angle", Role::Helper}, point, normal, other - point});
  // Not from P0, where it would lie on n: a normal may stand on any point of its plane.
  MarkBase twice{at.mark("kn"), Role::Ghost, Subject::Plane, latexOf(2 * at.n)};
  figure.add(inLook(at.in.E.look, ArrowMark{std::move(twice), other, 2.0 * normal}));
  return figure;
}

/// What the plane would be whose normal makes a right angle with an axis: it is parallel to that, or has it.
SpecialCase parallelToAxis(const In &in, int axis) {
  PlaneObject tilted = in.E.object;
  tilted.normal[axis] = 0;
  const std::array<std::string, 3> sentences{words("The normal would make a right angle with the x-axis."),
                                             words("The normal would make a right angle with the y-axis."),
                                             words("The normal would make a right angle with the z-axis.")};
  return {is("coefficients." + std::to_string(axis), "0"), sentences.at(static_cast<std::size_t>(axis)), "E",
          tilted};
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasPlane)
    return all;
  const auto &[point, normal] = at.in.E.object;
  if (at.equation.offset != 0)
    all.push_back({is("origin_distance", "0"), words("The plane would go through the origin."), "E",
                   PlaneObject{projectVector(point, normal).rejection, normal}});
  for (int axis = 0; axis < 3; ++axis)
    if (SpecialCase tilted = parallelToAxis(at.in, axis);
        normal[axis] != 0 && !isZero(objectAs<PlaneObject>(*tilted.object)->normal))
      all.push_back(std::move(tilted));
  return all;
}

/// Four coefficients.
template <class Four> Value rowOf(const Four &numbers) {
  return std::vector<Surd>(numbers.begin(), numbers.end());
}

ToldValue primitiveValue(const Out &at) {
  return {words("in smallest whole numbers"), rowOf(primitiveCoefficients(at.equation))};
}

ToldValue normalizedValue(const Out &at) {
  return {words("normalized"), rowOf(normalizedCoefficients(at.equation))};
}

ToldValue distanceValue(const Out &at) {
  return {words("signed distance of the origin"),
          measurePointPlane(ExactVec3(0), at.equation).signedDistance};
}

} // namespace

Construction plane_implicit() {
  return taught<Out, PlaneObject>(
      {.id = "plane-implicit",
       .title = [] { return words("equation, step by step"); },
       .roles = {"E"},
       .makes = {{"P1", &Out::hasPlane, &Out::P1}},
       .cases = {"plane", "zero-normal"},
       .values = {{named::list("coefficients", 4), always, coefficientsValue},
                  {named::list("primitive", 4), &Out::hasPlane, primitiveValue},
                  {named::list("normalized", 4), &Out::hasPlane, normalizedValue},
                  {named::number("origin_distance"), &Out::hasPlane, distanceValue}},
       .lines = {{"implicit", always, implicitLine},
                 {"insert", always, insertLine},
                 {"expand", &Out::hasPlane, expandLine},
                 {"collect", &Out::hasPlane, collectLine},
                 {"constant", &Out::hasPlane, [](const Out &at) { return withProducts(dot(at.n, at.P1)); },
                  constantWords},
                 {"normalized", &Out::hasPlane, normalizedLine},
                 {"scaled", &Out::hasPlane, scaledLine}},
       .marks = {"P1", "kn"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
