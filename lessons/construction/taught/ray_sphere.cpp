// Where a ray meets a sphere, by the quadratic equation for its parameter (note CG), and the right triangle
// behind its discriminant.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/point_line.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<SphereObject> S;
  Given<RayObject> L;
};

/// A point that the ray's line and the sphere have in common.
struct Contact {
  Term t, H, n;
  bool isAhead; ///< t ≥ 0: the ray gets there
};

struct Out : Naming, SphereTerms, RayTerms {
  RaySphere<Rational> meet;
  PointLine<Rational> nearest; ///< the centre and the ray's line
  bool isPoint;                ///< the radius is 0: there is no sphere
  Term w;
  Term a, b, k, D;               ///< of the equation a·t² + 2b·t + k = 0: its discriminant is b² − a·k
  Term M, h, s;                  ///< the line's point nearest to the centre; its distance; half the chord
  std::vector<Contact> contacts; ///< by ascending t
};

Term coordinatesNamed(Symbol symbol, const std::array<Surd, 3> &coordinates) {
  return name(std::move(symbol), std::vector<Surd>(coordinates.begin(), coordinates.end()));
}

std::vector<Contact> contactsOf(const In &in, const RaySphere<Rational> &meet) {
  std::vector<Contact> contacts;
  for (const auto &[t, point, normal] : meet.along) {
    const std::string index = std::to_string(contacts.size() + 1);
    contacts.push_back(
        {name(in.own(letter("t", index)), t),
         coordinatesNamed(in.own(letter("H", index)), point).marked(in.mark("H" + index)),
         coordinatesNamed(in.own(vectorLetter("n", index)), normal).marked(in.mark("n" + index)),
         t.sign() >= 0});
  }
  return contacts;
}

Out compute(const In &in) {
  const auto &[center, radius] = in.S.object;
  const auto &[origin, direction] = in.L.object;
  const bool isPoint = radius == 0;
  const auto meet = isPoint ? RaySphere<Rational>{}
                            : intersectRaySphere(Ray<Rational>{origin, direction}, {center, radius});
  const auto nearest = measurePointLine(center, origin, direction);
  const ExactVec3 w = origin - center;
  const Rational square = dot(direction, direction);
  const bool hasChord = meet.contacts == SphereContacts::Two;
  return {in,
          termsOf(in.S),
          termsOf(in.L),
          meet,
          nearest,
          isPoint,
          name(in.own(vectorLetter("w")), w).marked(in.mark("w")),
          name(in.own(letter("a")), square),
          name(in.own(letter("b")), dot(direction, w)),
          name(in.own(letter("k")), Rational(dot(w, w) - radius * radius)),
          name(in.own(letter("D")), meet.discriminant),
          madeName(in, "M", nearest.foot),
          name(in.own(letter("h")), nearest.distance).marked(in.mark("h")),
          name(in.own(letter("s")), hasChord ? Surd::root(Rational(meet.discriminant / square)) : Surd())
              .marked(in.mark("s")),
          contactsOf(in, meet)};
}

bool hasLine(const Out &at) { return !at.isPoint && at.meet.which != RaySphereCase::ZeroDirection; }
bool hasChord(const Out &at) { return at.meet.contacts == SphereContacts::Two; }

std::string twiceWords(const Out &at) {
  const WordValues values{{"t1", equation(at.contacts[0].t)},
                          {"t2", equation(at.contacts[1].t)},
                          {"H1", plainText(at.contacts[0].H)},
                          {"H2", plainText(at.contacts[1].H)}};
  if (!at.contacts[1].isAhead)
    return words("{t1} and {t2} are both negative: the sphere is behind the ray's start.", values);
  switch (at.meet.origin) {
  case SolidLocation::Outside:
    return words("The ray enters the sphere at {H1}, with {t1}, and leaves it at {H2}, with {t2}.", values);
  case SolidLocation::Inside:
    return words(
        "The ray starts inside: {t1} is behind its start, and it leaves the sphere at {H2}, with {t2}.",
        values);
  case SolidLocation::On:
    break;
  }
  return at.contacts[0].isAhead
             ? words("The ray starts on the sphere, goes inside and leaves it at {H2}, with {t2}.", values)
             : words("The ray starts on the sphere and leads away from it: it has only its start, {H2}, in "
                     "common with it.",
                     values);
}

std::string onceWords(const Out &at) {
  const Contact &touch = at.contacts.front();
  const WordValues values{{"t", equation(touch.t)}, {"H", plainText(touch.H)}};
  return touch.isAhead
             ? words("D = 0: the ray touches the sphere in one point, {H}, with {t}.", values)
             : words("D = 0: the line touches the sphere in one point, {H}. But {t} is negative: it is "
                     "behind the ray's start.",
                     values);
}

CaseWords tell(const In &, const Out &at) {
  if (at.isPoint)
    return {"zero-radius", words("The radius is 0: the sphere is only the point {c}.", at.letters), true};
  if (at.meet.which == RaySphereCase::ZeroDirection)
    return zeroDirectionWords(at);
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.contacts) {
  case SphereContacts::Two:
    return {caseName, twiceWords(at)};
  case SphereContacts::Tangent:
    return {caseName, onceWords(at)};
  case SphereContacts::None:
    break;
  }
  return {caseName,
          words("{D} is negative and has no root: no t fits, and the line of the ray misses the sphere.",
                {{"D", equation(at.D)}})};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (at.isPoint)
    return {};
  std::vector<NamedValue> values{
      {"origin", words("place of the start"), std::string(nameOf(at.meet.origin))}};
  if (!hasLine(at))
    return values;
  values.push_back({"contacts", words("common points"), std::string(nameOf(at.meet.contacts))});
  values.push_back(listed("discriminant", at.D));
  values.push_back(listed("nearest", at.M));
  values.push_back(listed("distance", at.h));
  if (at.contacts.empty())
    return values;
  std::vector<Term> parameters;
  for (const Contact &contact : at.contacts)
    parameters.push_back(contact.t);
  values.push_back(listed("t", list(parameters)));
  const std::array names{"first", "second"};
  for (std::size_t i = 0; i < at.contacts.size(); ++i) {
    const Contact &contact = at.contacts[i];
    values.push_back(
        {names.at(i), {}, std::vector<NamedValue>{listed("point", contact.H), listed("normal", contact.n)}});
  }
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!hasLine(at))
    return {};
  return {{"M", PointObject{at.nearest.foot}}};
}

WorkingLine startLine(const Out &at) {
  return asked(withNumbers(at.w == at.Q - at.c), words("From the centre {c} to the start {Q}.", at.letters));
}

WorkingLine constantLine(const Out &at) {
  const std::string where =
      at.meet.origin == SolidLocation::Outside  ? words("Positive: {Q} is outside the sphere.", at.letters)
      : at.meet.origin == SolidLocation::Inside ? words("Negative: {Q} is inside the sphere.", at.letters)
                                                : words("Zero: {Q} is on the sphere.", at.letters);
  return asked(withNumbers(at.k == dot(at.w, at.w) - power(at.R, 2)), where,
               {{dot(at.w, at.w) - at.R, words("{answer} has {R} where its square belongs.", at.letters)}});
}

WorkingLine quadraticLine(const Out &at) {
  const Term t = unknown("t");
  const Term left = at.a * power(t, 2) + 2 * at.b * t + at.k;
  return askedEquation(
      condition((0 == left).then(numbersPutIn(left)).then(calculated(left))),
      words("A quadratic equation: its solutions are the t where the line meets the sphere."));
}

std::string discriminantWords(const Out &at) {
  switch (at.meet.contacts) {
  case SphereContacts::Two:
    return words("Positive: it has a root, and two t fit.");
  case SphereContacts::Tangent:
    return words("Zero: only one t fits. The line touches the sphere.");
  case SphereContacts::None:
    break;
  }
  return words("Negative: it has no root, and no t fits. The line misses the sphere.");
}

WorkingLine discriminantLine(const Out &at) {
  return asked(
      withNumbers(at.D == power(at.b, 2) - at.a * at.k), discriminantWords(at),
      {{4 * at.D, words("{answer} is four times as much: b is only half of what stands before t, so there is "
                        "no 4 here.")},
       {power(at.b, 2) - 4 * (at.a * at.k),
        words("{answer} has a 4 too many: b is only half of what stands before t.")}});
}

/// The mistakes that both solutions invite.
std::vector<WrongTerm> solutionMistakes(const Out &at, const Term &t) {
  return {
      {t / 2, words("{answer} is half of it: b is half of what stands before t, so divide by a, not by 2a.")},
      {t * at.a, words("{answer} is not divided by a yet.")},
      {-t, words("{answer} has the wrong sign: the formula begins with −b.")}};
}

WorkingLine touchLine(const Out &at) {
  const Term &t = at.contacts.front().t;
  return asked(withNumbers(t == -at.b / at.a), words("√D is 0, so both solutions are this one."),
               solutionMistakes(at, t));
}

WorkingLine solutionLine(const Out &at, std::size_t index) {
  const Term &t = at.contacts[index].t;
  const Term &other = at.contacts[1 - index].t;
  std::vector<WrongTerm> mistakes{
      {other, words("{answer} is the other solution: mind the sign before the root.")}};
  for (WrongTerm &mistake : solutionMistakes(at, t))
    mistakes.push_back(std::move(mistake));
  return asked(withNumbers(t == (index == 0 ? -at.b - root(at.D) : -at.b + root(at.D)) / at.a), {},
               std::move(mistakes));
}

std::string aheadWords(const Out &at) {
  const std::size_t behind = at.contacts.front().isAhead ? 0 : at.contacts.back().isAhead ? 1 : 2;
  if (behind == 0)
    return words("No t is negative: what the line meets, the ray meets too.");
  return behind == 1 && hasChord(at)
             ? words("Only one t is not negative: the ray meets the sphere once.")
             : words("No t ≥ 0: the line meets the sphere, but only behind the start. The ray misses it.");
}

WorkingLine aheadLine(const Out &at) {
  std::vector<Chain> signs;
  for (const Contact &contact : at.contacts)
    signs.push_back(compared(contact.t, 0));
  return line(std::move(signs), aheadWords(at));
}

WorkingLine hitLine(const Out &at, const Contact &contact) {
  return asked(withNumbers(contact.H == at.Q + contact.t * at.r));
}

WorkingLine normalLine(const Out &at, const Contact &contact) {
  return asked(withNumbers(contact.n == (contact.H - at.c) / at.R),
               words("From the centre outwards. Divided by {R} it is one unit long.", at.letters));
}

void addContactLines(const Out &at, Explanation &lines) {
  if (at.contacts.empty())
    return;
  if (hasChord(at))
    for (std::size_t i = 0; i < at.contacts.size(); ++i)
      lines.add("t" + std::to_string(i + 1), [&at, i] { return solutionLine(at, i); });
  else
    lines.add("t1", [&at] { return touchLine(at); });
  lines.add("ahead", [&at] { return aheadLine(at); });
  for (std::size_t i = 0; i < at.contacts.size(); ++i) {
    const std::string index = std::to_string(i + 1);
    const Contact &contact = at.contacts[i];
    lines.add("hit" + index, [&] { return hitLine(at, contact); });
    lines.add("normal" + index, [&] { return normalLine(at, contact); });
  }
}

WorkingLine nearestLine(const Out &at) {
  return asked(withNumbers(at.M == at.Q - at.b / at.a * at.r),
               words("The line's point nearest to the centre: without the root, t is −b/a."));
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers(at.h == norm(at.M - at.c)), words("How far the line passes from the centre."));
}

WorkingLine chordLine(const Out &at) {
  return asked(withNumbers(at.s == root(power(at.R, 2) - power(at.h, 2))),
               at.nearest.which == PointLineCase::On
                   ? words("The chord goes through the centre, so its half is as long as {R}.", at.letters)
                   : words("Half of the chord, by Pythagoras: {R} is the longest side.", at.letters),
               {{power(at.R, 2) - power(at.h, 2), words("{answer} is s²: its root is still to be taken.")},
                {at.R - at.h,
                 words("{answer} is {R} − h: the squares are subtracted, not the lengths.", at.letters)}});
}

/// The discriminant in the right triangle.
WorkingLine triangleLine(const Out &at) {
  return line(withNumbers(at.D == at.a * (power(at.R, 2) - power(at.h, 2))),
              hasChord(at)          ? words("h < {R}: the discriminant is positive.", at.letters)
              : at.contacts.empty() ? words("h > {R}: the discriminant is negative.", at.letters)
                                    : words("h = {R}: the discriminant is 0.", at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (at.isPoint)
    return lines;
  lines.add("w", [&at] { return startLine(at); });
  if (!hasLine(at))
    return lines;
  lines.add("a", [&at] { return asked(withProducts(at.a == dot(at.r, at.r))); });
  lines.add("b", [&at] { return asked(withProducts(at.b == dot(at.r, at.w))); });
  lines.add("k", [&at] { return constantLine(at); });
  lines.add("quadratic", [&at] { return quadraticLine(at); });
  lines.add("discriminant", [&at] { return discriminantLine(at); });
  addContactLines(at, lines);
  lines.add("nearest", [&at] { return nearestLine(at); });
  lines.add("h", [&at] { return distanceLine(at); });
  if (hasChord(at))
    lines.add("s", [&at] { return chordLine(at); });
  lines.add("triangle", [&at] { return triangleLine(at); });
  return lines;
}

/// The unit normals are drawn this long in every picture.
constexpr double drawnNormalLength = 2;

void drawContact(Figure &figure, const In &in, const Out &at, const Contact &contact) {
  const Place point = place(contact.H);
  if (contact.isAhead)
    figure.reaches.push_back({in.L.id, point});
  else
    figure.add(SegmentMark{{contact.H->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  figure.add(pointOf(contact.H, contact.isAhead ? Role::Result : Role::Ghost, Subject::Ray));
  figure.add(ArrowMark{drawn(contact.n, Role::Derived, Subject::Measure), point, place(contact.n), false,
                       drawnNormalLength});
}

/// The right triangle of the centre, the line's nearest point and the first contact. The radius is a mark of
/// its own: where there is no chord it leads to the one contact alone.
void drawTriangle(Figure &figure, const In &in, const Out &at) {
  const Place center = place(at.c);
  const Place middle = place(at.M);
  const bool isBeside = at.nearest.which == PointLineCase::Off;
  figure.add(pointOf(at.M, Role::Derived, Subject::Measure));
  if (isBeside)
    figure.add(SegmentMark{drawn(at.h, Role::Derived, Subject::Measure), center, middle});
  if (at.contacts.empty())
    return;
  const Place contact = place(at.contacts.front().H);
  figure.add(SegmentMark{
      {in.mark("radius"), Role::Derived, Subject::Triangle, latexOf(in.S.letters[1])}, center, contact});
  if (!hasChord(at))
    return;
  figure.add(SegmentMark{drawn(at.s, Role::Result, Subject::Measure), middle, contact});
  if (isBeside)
    figure.add(RightAngleMark{
        {at.s->mark + "/angle", Role::Helper, Subject::Measure}, middle, center - middle, contact - middle});
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (at.isPoint)
    return figure;
  if (in.L.object.origin != in.S.object.center)
    figure.add(arrowOf(at.w, place(at.c), Role::Derived, Subject::Point));
  if (!hasLine(at))
    return figure;
  for (const Contact &contact : at.contacts)
    drawContact(figure, in, at, contact);
  drawTriangle(figure, in, at);
  return figure;
}

/// What the ray would be, moved sideways, whose line touches the sphere.
void addTangent(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  const Surd &distance = at.nearest.distance;
  const Rational &radius = in.S.object.radius;
  if (at.meet.contacts == SphereContacts::Tangent || distance == Surd())
    return;
  SpecialCase tangent{"contacts = tangent", words("The ray's line would touch the sphere."), "L", {}};
  const ExactVec3 aside = at.nearest.foot - in.S.object.center;
  const auto &[origin, direction] = in.L.object;
  if (distance.isRational())
    tangent.object = RayObject{origin + aside * (radius / distance.rationalPart() - 1), direction};
  else
    tangent.rootedWay = (distance + -radius).squared();
  all.push_back(std::move(tangent));
}

/// What the ray would be, moved along its line, that starts at the nearer contact.
void addStartOnSphere(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  if (at.contacts.empty() || at.meet.origin == SolidLocation::On)
    return;
  SpecialCase start{"origin = on", words("{Q} would lie on the sphere.", at.letters), "L", {}};
  const Surd &first = at.meet.along.front().t;
  const Surd &last = at.meet.along.back().t;
  const Surd &nearer = first.squared() <= last.squared() ? first : last;
  const auto &[origin, direction] = in.L.object;
  if (nearer.isRational())
    start.object = RayObject{origin + direction * nearer.rationalPart(), direction};
  else
    start.rootedWay = nearer.squared() * dot(direction, direction);
  all.push_back(std::move(start));
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (!hasLine(at))
    return all;
  addTangent(in, at, all);
  addStartOnSphere(in, at, all);
  if (at.nearest.which == PointLineCase::Off) {
    const auto &[origin, direction] = in.L.object;
    all.push_back({"distance = 0", words("The ray's line would go through the centre {c}.", at.letters), "L",
                   RayObject{origin + in.S.object.center - at.nearest.foot, direction}});
  }
  return all;
}

ValueName contactName(std::string name) {
  return named::group(std::move(name), {named::vector("point"), named::vector("normal")});
}

} // namespace

Construction ray_sphere() {
  return makeConstruction<In, Out, SphereObject, RayObject>(
      "ray-sphere", {"S", "L"}, {{"M", "point"}},
      {"w", "a", "b", "k", "D", "t1", "t2", "H1", "H2", "n1", "n2", "h", "s"},
      {.cases = {"hit", "behind", "miss", "zero-direction", "zero-radius"},
       .values = {named::word("origin", {"outside", "on", "inside"}),
                  named::word("contacts", {"two", "tangent", "none"}), named::number("discriminant"),
                  named::vector("nearest"), named::number("distance"), named::list("t", 2),
                  contactName("first"), contactName("second")},
       .lines = {"w", "a", "b", "k", "quadratic", "discriminant", "t1", "t2", "ahead", "hit1", "normal1",
                 "hit2", "normal2", "nearest", "h", "s", "triangle"},
       .marks = {"w", "H1", "n1", "H2", "n2", "M", "h", "radius", "s"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
