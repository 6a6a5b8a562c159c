#include "lessons/construction/parts/line_at_sphere.h"

#include "lessons/construction/parts/sphere_triangle.h"

#include <utility>

namespace halfspace {
namespace {

/// For sentences that have a {Q} for the line's point.
WordValues lettersOf(const LineAtSphere &at) { return {{"Q", plainText(at.from)}, {"R", plainText(at.R)}}; }

Term contactName(const Naming &naming, const std::string &index, const std::vector<Surd> &point) {
  return naming.made.contains("H" + index) ? madeName(naming, "H" + index, point)
                                           : drawnName(naming, letter("H", index), point);
}

std::vector<ContactTerms> contactsOf(const Naming &naming, const LineSphere<Rational> &met) {
  const auto coordinates = [](const auto &vector) { return std::vector<Surd>(vector.begin(), vector.end()); };
  std::vector<ContactTerms> contacts;
  for (const auto &[t, point, normal] : met.along) {
    const std::string index = std::to_string(contacts.size() + 1);
    contacts.push_back({ownName(naming, letter("t", index), t),
                        contactName(naming, index, coordinates(point)),
                        drawnName(naming, vectorLetter("n", index), coordinates(normal))});
  }
  return contacts;
}

/// 0 without a chord.
Surd halfChord(const LineAtSphere &at) {
  return at.hasChord ? Surd::root(Rational(at.met.discriminant / dot(at.direction, at.direction))) : Surd();
}

std::string discriminantWords(const LineAtSphere &at) {
  switch (at.met.contacts) {
  case SphereContacts::Two:
    return words("Positive: it has a root, and two t fit.");
  case SphereContacts::Tangent:
    return words("Zero: only one t fits. The line touches the sphere.");
  case SphereContacts::None:
    break;
  }
  return words("Negative: it has no real square root, and no t fits. The line misses the sphere.");
}

/// The mistakes that both solutions invite.
std::vector<WrongTerm> solutionMistakes(const LineAtSphere &at, const Term &t) {
  return {
      {t / 2, words("{answer} is half of it: b is half the coefficient of t, so divide by a, not by 2a.")},
      {t * at.a, words("{answer} is not divided by a yet.")},
      {-t, words("{answer} has the wrong sign: the formula begins with −b.")}};
}

WorkingLine touchLine(const LineAtSphere &at) {
  const Term &t = at.contacts.front().t;
  return asked(withNumbers(t == -at.b / at.a), words("√D is 0, so both solutions are this one."),
               solutionMistakes(at, t));
}

WorkingLine solutionLine(const LineAtSphere &at, std::size_t index) {
  const Term &t = at.contacts[index].t;
  const Term &other = at.contacts[1 - index].t;
  std::vector<WrongTerm> mistakes{
      {other, words("{answer} is the other solution: mind the sign before the root.")}};
  for (WrongTerm &mistake : solutionMistakes(at, t))
    mistakes.push_back(std::move(mistake));
  return asked(withNumbers(t == (index == 0 ? -at.b - root(at.D) : -at.b + root(at.D)) / at.a), {},
               std::move(mistakes));
}

/// The normals are drawn this long in every picture.
constexpr double drawnNormalLength = 2;

} // namespace

LineAtSphere::LineAtSphere(const Naming &naming, const Given<SphereObject> &given, Term point, Term way)
    : SphereTerms(termsOf(given)), from(std::move(point)),
      along(std::move(way)), sphere{given.object.center, given.object.radius},
      w(drawnName(naming, vectorLetter("w"), ExactVec3(start - sphere.center))),
      a(ownName(naming, letter("a"), dot(direction, direction))),
      b(ownName(naming, letter("b"), met.leaving)), k(ownName(naming, letter("k"), met.power)),
      D(ownName(naming, letter("D"), met.discriminant)), M(madeName(naming, "M", nearest.foot)),
      h(drawnName(naming, letter("h"), nearest.distance)),
      s(drawnName(naming, letter("s"), halfChord(*this))), contacts(contactsOf(naming, met)) {}

WorkingLine constantLine(const LineAtSphere &at) {
  const std::string where =
      at.met.origin == SolidLocation::Outside  ? words("Positive: {Q} is outside the sphere.", lettersOf(at))
      : at.met.origin == SolidLocation::Inside ? words("Negative: {Q} is inside the sphere.", lettersOf(at))
                                               : words("Zero: {Q} is on the sphere.", lettersOf(at));
  return asked(
      withNumbers(at.k == dot(at.w, at.w) - power(at.R, 2)), where,
      {{dot(at.w, at.w) - at.R, words("{answer} has {R} where its square belongs.", lettersOf(at))}});
}

WorkingLine quadraticLine(const LineAtSphere &at) {
  const Term t = unknown("t");
  const Term left = at.a * power(t, 2) + 2 * at.b * t + at.k;
  return askedEquation(
      condition((0 == left).then(numbersPutIn(left)).then(calculated(left))),
      words("A quadratic equation: its solutions are the t where the line meets the sphere."));
}

WorkingLine discriminantLine(const LineAtSphere &at) {
  return asked(
      withNumbers(at.D == power(at.b, 2) - at.a * at.k), discriminantWords(at),
      {{4 * at.D, words("{answer} is four times as much: b is only half the coefficient of t, so there is "
                        "no 4 here.")},
       {power(at.b, 2) - 4 * (at.a * at.k),
        words("{answer} has a 4 too many: b is only half the coefficient of t.")}});
}

WorkingLine firstSolutionLine(const LineAtSphere &at) {
  return at.hasChord ? solutionLine(at, 0) : touchLine(at);
}

WorkingLine secondSolutionLine(const LineAtSphere &at) { return solutionLine(at, 1); }

std::string powerWords(const LineAtSphere &at) {
  return words("This is k: the same for every line through {Q} that meets the sphere twice.", lettersOf(at));
}

WorkingLine contactLine(const LineAtSphere &at, std::size_t index) {
  const auto &[t, H, n] = at.contacts[index];
  return asked(withNumbers(H == at.from + t * at.along));
}

WorkingLine normalLine(const LineAtSphere &at, std::size_t index) {
  const auto &[t, H, n] = at.contacts[index];
  return asked(withNumbers(n == (H - at.c) / at.R),
               words("From the centre outwards. Divided by {R} it is one unit long.", lettersOf(at)));
}

WorkingLine chordLine(const LineAtSphere &at) {
  return asked(withNumbers(at.s == root(power(at.R, 2) - power(at.h, 2))),
               at.nearest.which == PointLineCase::On
                   ? words("The chord goes through the centre, so its half is as long as {R}.", lettersOf(at))
                   : words("Half of the chord, by Pythagoras: {R} is the longest side.", lettersOf(at)),
               {{power(at.R, 2) - power(at.h, 2), words("{answer} is s²: its root is still to be taken.")},
                {at.R - at.h,
                 words("{answer} is {R} − h: the squares are subtracted, not the lengths.", lettersOf(at))}});
}

WorkingLine triangleLine(const LineAtSphere &at) {
  return line(withNumbers(at.D == at.a * (power(at.R, 2) - power(at.h, 2))),
              at.hasChord ? words("h < {R}: the discriminant is positive.", lettersOf(at))
              : !at.isMet ? words("h > {R}: the discriminant is negative.", lettersOf(at))
                          : words("h = {R}: the discriminant is 0.", lettersOf(at)));
}

Term parametersOf(const LineAtSphere &at) {
  std::vector<Term> parameters;
  for (const ContactTerms &contact : at.contacts)
    parameters.push_back(contact.t);
  return list(std::move(parameters));
}

void drawNormal(Figure &figure, const ContactTerms &contact) {
  figure.add(arrowInPicture(drawn(contact.n, Role::Derived, Subject::Measure), place(contact.H),
                            place(contact.n), drawnNormalLength));
}

void drawRightTriangle(Figure &figure, const Naming &naming, const LineAtSphere &at) {
  figure.add(pointOf(at.M, Role::Derived, Subject::Measure));
  drawSphereTriangle(figure, {at.c, at.M, at.h, at.s, at.R, naming.mark("radius")},
                     at.isMet ? std::optional(place(at.contacts.front().H)) : std::nullopt);
}

} // namespace halfspace
