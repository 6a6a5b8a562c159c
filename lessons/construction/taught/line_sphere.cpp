// Where a line meets a sphere, by the quadratic equation for its parameter (note CG).
#include "geometry/case_names.h"
#include "lessons/construction/parts/line_at_sphere.h"
#include "lessons/object/kinds/line.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<SphereObject> S;
};

struct Out : Computed<In>, LineTerms, LineAtSphere {
  explicit Out(const In &objects)
      : Computed(objects), LineTerms(termsOf(objects.g)), LineAtSphere(objects, objects.S, A, v) {}

  /// Whether the contact is a point that later entries can look at: no object has roots for coordinates.
  [[nodiscard]] bool makesContact(std::size_t index) const {
    return hasContact(index) && met.along[index].t.isRational();
  }
};

std::string pointWords(const Out &at) {
  if (isZero(at.direction))
    return words("The radius is 0: the sphere is only the point {c}.", at.letters);
  return at.nearest.which == PointLineCase::On
             ? words("The radius is 0: the sphere is only the point {c}, and the line {g} goes through it.",
                     at.letters)
             : words("The radius is 0: the sphere is only the point {c}, and the line {g} passes beside it.",
                     at.letters);
}

CaseWords tell(const Out &at) {
  if (!at.isSphere)
    return {"zero-radius", pointWords(at), true};
  if (!at.hasLine)
    return zeroLineWords(at, "zero-direction");
  const std::string caseName(nameOf(at.met.contacts));
  switch (at.met.contacts) {
  case SphereContacts::Two:
    return {caseName,
            words("{D} is positive: the line {g} meets the sphere in two points, {H1} with {t1} and "
                  "{H2} with {t2}.",
                  at.letters,
                  {{"D", equation(at.D)},
                   {"t1", equation(at.contacts[0].t)},
                   {"t2", equation(at.contacts[1].t)},
                   {"H1", plainText(at.contacts[0].H)},
                   {"H2", plainText(at.contacts[1].H)}})};
  case SphereContacts::Tangent:
    return {caseName, words("{D}: the line {g} touches the sphere in one point, {H1}, with {t1}.", at.letters,
                            {{"D", equation(at.D)},
                             {"t1", equation(at.contacts[0].t)},
                             {"H1", plainText(at.contacts[0].H)}})};
  case SphereContacts::None:
    break;
  }
  return {caseName,
          words("{D} is negative and has no real square root: no t fits, and the line {g} misses the "
                "sphere.",
                at.letters, {{"D", equation(at.D)}})};
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isSphere)
    return figure;
  if (at.start != at.sphere.center)
    figure.add(arrowOf(at.w, place(at.c), Role::Derived, Subject::Point));
  if (!at.hasLine)
    return figure;
  for (const ContactTerms &contact : at.contacts) {
    figure.add(pointOf(contact.H, Role::Result, Subject::Measure));
    drawNormal(figure, contact);
    figure.reaches.push_back({at.in.g.id, place(contact.H)});
  }
  drawRightTriangle(figure, at, at);
  figure.reaches.push_back({at.in.g.id, place(at.M)});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasLine)
    return all;
  addTouching<LineObject>(at, {is("case", "tangent"), words("The line would touch the sphere."), "g", {}},
                          all);
  addThroughCenter<LineObject>(
      at, {is("distance", "0"), words("The line would go through the centre {c}.", at.letters), "g", {}},
      all);
  return all;
}

MadeRow<Out> contactPoint(const std::string &name, std::size_t index) {
  return {name, PointObject::kind, [index](const Out &at) { return at.makesContact(index); },
          [index](const Out &at) { return PointObject{vectorOf(at.contacts[index].H)}; }};
}

} // namespace

Construction line_sphere() {
  return taught<Out, LineObject, SphereObject>(
      {.id = "line-sphere",
       .word = "intersect",
       .title = [] { return words("where the line meets the sphere"); },
       .roles = {"g", "S"},
       .makes = {contactPoint("H1", 0), contactPoint("H2", 1), {"M", &Out::hasLine, &Out::M}},
       .letters = {"w", "a", "b", "k", "D", "t1", "t2", "n1", "n2", "h", "s"},
       .cases = {"two", "tangent", "none", "zero-direction", "zero-radius"},
       .values = lineAtSphereRows<Out>(),
       .lines = joined<LineRow<Out>>(
           {equationLines<Out>(says("From the centre {c} to {A}.")), contactLines<Out>()}),
       .marks = {"w", "H1", "n1", "H2", "n2", "M", "h", "radius", "s"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
