// What a line and a sphere have to do with each other, as all constructions of both calculate it: the
// quadratic equation for the line's parameter (note CG), and the right triangle behind its discriminant.
#pragma once

#include "geometry/intersect_line_sphere.h"
#include "geometry/point_line.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/sphere.h"

namespace halfspace {

/// A point that the line and the sphere have in common.
struct ContactTerms {
  Term t, H, n;
};

/// The letters of the lines, each with what it is. H₁ and H₂ are letters of the construction's own, or of
/// points that it makes.
struct LineAtSphere : SphereTerms {
  /// Of the line through a point along a direction, which may be zero.
  LineAtSphere(const Naming &naming, const Given<SphereObject> &sphere, Term point, Term direction);

  Term from, along; ///< the line's point and its direction, in the letters of the scene
  ExactVec3 start = vectorOf(from);
  ExactVec3 direction = vectorOf(along);
  Sphere<Rational> sphere;
  bool isSphere = sphere.radius != 0; ///< else it is a point
  LineSphere<Rational> met =
      isSphere ? intersectLineSphere(start, direction, sphere) : LineSphere<Rational>{};
  bool hasLine = isSphere && !isZero(direction);
  bool hasChord = met.contacts == SphereContacts::Two;
  bool isMet = !met.along.empty();
  PointLine<Rational> nearest =
      measurePointLine(sphere.center, start, direction); ///< the centre and the line

  Term w;
  // Of the equation a·t² + 2b·t + k = 0: its discriminant is b² − a·k.
  Term a, b, k, D;
  Term M; ///< the line's point nearest to the centre
  Term h, s;
  std::vector<ContactTerms> contacts; ///< by ascending t

  [[nodiscard]] bool hasContact(std::size_t index) const { return index < contacts.size(); }
};

/// The lines from a, b and k to the solutions.
[[nodiscard]] WorkingLine constantLine(const LineAtSphere &at);
[[nodiscard]] WorkingLine quadraticLine(const LineAtSphere &at);
[[nodiscard]] WorkingLine discriminantLine(const LineAtSphere &at);
[[nodiscard]] WorkingLine firstSolutionLine(const LineAtSphere &at);
[[nodiscard]] WorkingLine secondSolutionLine(const LineAtSphere &at);
[[nodiscard]] std::string powerWords(const LineAtSphere &at);

/// The lines of a contact, and of the right triangle.
[[nodiscard]] WorkingLine contactLine(const LineAtSphere &at, std::size_t index);
[[nodiscard]] WorkingLine normalLine(const LineAtSphere &at, std::size_t index);
[[nodiscard]] WorkingLine chordLine(const LineAtSphere &at);
[[nodiscard]] WorkingLine triangleLine(const LineAtSphere &at);

/// The unit normal at a contact.
void drawNormal(Figure &figure, const ContactTerms &contact);
/// The right triangle of the centre, the line's nearest point and the first contact. The radius is a mark of
/// its own: where there is no chord it leads to the one contact alone.
void drawRightTriangle(Figure &figure, const Naming &naming, const LineAtSphere &at);

/// From w, of which the sentence says where it leads, to the solutions.
template <class Out> [[nodiscard]] LineTable<Out> equationLines(Sentence ofWay) {
  return {
      {"w", &Out::isSphere, [](const Out &at) { return withNumbers(at.w == at.from - at.c); }, ofWay},
      {"a", &Out::hasLine,
       [](const Out &at) { return asked(withProducts(at.a == dot(at.along, at.along))); }},
      {"b", &Out::hasLine, [](const Out &at) { return asked(withProducts(at.b == dot(at.along, at.w))); }},
      {"k", &Out::hasLine, constantLine},
      {"quadratic", &Out::hasLine, quadraticLine},
      {"discriminant", &Out::hasLine, discriminantLine},
      {"t1", &Out::isMet, firstSolutionLine},
      {"t2", &Out::hasChord, secondSolutionLine},
      {"power", &Out::hasChord,
       [](const Out &at) {
         return withNumbers(at.contacts[0].t * at.contacts[1].t * dot(at.along, at.along));
       },
       powerWords}};
}

/// From the contacts to the right triangle.
template <class Out> [[nodiscard]] LineTable<Out> contactLines() {
  return joined<LineRow<Out>>(
      {linesOfEach<Out>(
           2, [](const Out &at, std::size_t index) { return at.hasContact(index); },
           {{"hit", contactLine}, {"normal", normalLine}}, 1),
       {{"nearest", &Out::hasLine,
         [](const Out &at) { return withNumbers(at.M == at.from - at.b / at.a * at.along); },
         says("The line's point nearest to the centre: without the root, t is −b/a.")},
        {"h", &Out::hasLine, [](const Out &at) { return withNumbers(at.h == norm(at.M - at.c)); },
         says("How far the line passes from the centre.")},
        {"s", &Out::hasChord, chordLine},
        {"triangle", &Out::hasLine, triangleLine}}});
}

/// The values of a contact.
template <class Out> [[nodiscard]] ValueRow<Out> contactRow(const std::string &name, std::size_t index) {
  return valueGroup<Out>(
      name, [index](const Out &at) { return at.hasContact(index); },
      {{named::vector("point"), always, [index](const Out &at) { return at.contacts[index].H; }},
       {named::vector("normal"), always, [index](const Out &at) { return at.contacts[index].n; }}});
}

/// The solutions beside each other.
[[nodiscard]] Term parametersOf(const LineAtSphere &at);

/// The values from the discriminant to the contacts.
template <class Out> [[nodiscard]] ValueTable<Out> lineAtSphereRows() {
  return {{named::number("discriminant"), &Out::hasLine, &Out::D},
          {named::vector("nearest"), &Out::hasLine, &Out::M},
          {named::number("distance"), &Out::hasLine, &Out::h},
          {named::list("t", 2), &Out::isMet, parametersOf},
          contactRow<Out>("first", 0),
          contactRow<Out>("second", 1)};
}

/// Adds what the line would be, moved sideways, that touches the sphere; nothing where it does, or goes
/// through the centre. `special` says all but what the object would be.
template <class Line>
void addTouching(const LineAtSphere &at, SpecialCase special, std::vector<SpecialCase> &all) {
  const Surd &distance = at.nearest.distance;
  if (at.met.contacts == SphereContacts::Tangent || distance == Surd())
    return;
  const ExactVec3 aside = at.nearest.foot - at.sphere.center;
  if (distance.isRational())
    special.object =
        Line{at.start + aside * Rational(at.sphere.radius / distance.rationalPart() - 1), at.direction};
  else
    special.rootedWay = (distance + -at.sphere.radius).squared();
  all.push_back(std::move(special));
}

/// Adds what it would be, moved sideways, that goes through the centre; nothing where it does.
template <class Line>
void addThroughCenter(const LineAtSphere &at, SpecialCase special, std::vector<SpecialCase> &all) {
  if (at.nearest.which != PointLineCase::Off)
    return;
  special.object = Line{at.start + at.sphere.center - at.nearest.foot, at.direction};
  all.push_back(std::move(special));
}

} // namespace halfspace
