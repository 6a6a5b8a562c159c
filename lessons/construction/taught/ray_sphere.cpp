// Where a ray meets a sphere, by the quadratic equation for its parameter (note CG), and the right triangle
// behind its discriminant.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_sphere.h"
#include "geometry/point_line.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/sphere.h"

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

std::vector<Contact> contactsOf(const In &in, const RaySphere<Rational> &meet) {
  const auto coordinates = [](const auto &vector) { return std::vector<Surd>(vector.begin(), vector.end()); };
  std::vector<Contact> contacts;
  for (const auto &[t, point, normal] : meet.along) {
    const std::string index = std::to_string(contacts.size() + 1);
    contacts.push_back({ownName(in, letter("t", index), t),
                        drawnName(in, letter("H", index), coordinates(point)),
                        drawnName(in, vectorLetter("n", index), coordinates(normal)), t.sign() >= 0});
  }
  return contacts;
}

RaySphere<Rational> meetingOf(const In &in) {
  return intersectRaySphere(Ray<Rational>{in.L.object.origin, in.L.object.direction},
                            {in.S.object.center, in.S.object.radius});
}

/// 0 without a chord.
Surd halfChord(const In &in, const RaySphere<Rational> &meet) {
  const ExactVec3 &direction = in.L.object.direction;
  return meet.contacts == SphereContacts::Two
             ? Surd::root(Rational(meet.discriminant / dot(direction, direction)))
             : Surd();
}

struct Out : Computed<In>, SphereTerms, RayTerms {
  explicit Out(const In &objects)
      : Computed(objects), SphereTerms(termsOf(objects.S)), RayTerms(termsOf(objects.L)) {}

  bool isSphere = in.S.object.radius != 0; ///< else it is a point
  RaySphere<Rational> meet = isSphere ? meetingOf(in) : RaySphere<Rational>{};
  bool hasLine = isSphere && meet.which != RaySphereCase::ZeroDirection;
  bool hasChord = meet.contacts == SphereContacts::Two;
  /// The centre and the ray's line.
  PointLine<Rational> nearest =
      measurePointLine(in.S.object.center, in.L.object.origin, in.L.object.direction);

  const ExactVec3 &direction = in.L.object.direction;
  ExactVec3 way = in.L.object.origin - in.S.object.center;

  Term w = drawnName(vectorLetter("w"), way);
  // Of the equation a·t² + 2b·t + k = 0: its discriminant is b² − a·k.
  Term a = ownName(letter("a"), dot(direction, direction));
  Term b = ownName(letter("b"), dot(direction, way));
  Term k = ownName(letter("k"), Rational(dot(way, way) - in.S.object.radius * in.S.object.radius));
  Term D = ownName(letter("D"), meet.discriminant);
  Term M = madeName("M", nearest.foot); ///< the line's point nearest to the centre
  Term h = drawnName(letter("h"), nearest.distance);
  Term s = drawnName(letter("s"), halfChord(in, meet));
  std::vector<Contact> contacts = contactsOf(in, meet); ///< by ascending t
  bool isMet = !contacts.empty();
};

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

CaseWords tell(const Out &at) {
  if (!at.isSphere)
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
  return {caseName, words("{D} is negative and has no real square root: no t fits, and the line of the ray "
                          "misses the sphere.",
                          {{"D", equation(at.D)}})};
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
  return words("Negative: it has no real square root, and no t fits. The line misses the sphere.");
}

WorkingLine discriminantLine(const Out &at) {
  return asked(
      withNumbers(at.D == power(at.b, 2) - at.a * at.k), discriminantWords(at),
      {{4 * at.D, words("{answer} is four times as much: b is only half the coefficient of t, so there is "
                        "no 4 here.")},
       {power(at.b, 2) - 4 * (at.a * at.k),
        words("{answer} has a 4 too many: b is only half the coefficient of t.")}});
}

/// The mistakes that both solutions invite.
std::vector<WrongTerm> solutionMistakes(const Out &at, const Term &t) {
  return {
      {t / 2, words("{answer} is half of it: b is half the coefficient of t, so divide by a, not by 2a.")},
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
  return behind == 1 && at.hasChord
             ? words("Only one t is not negative: the ray meets the sphere once.")
             : words("No t ≥ 0: the line meets the sphere, but only behind the start. The ray misses it.");
}

WorkingLine aheadLine(const Out &at) {
  std::vector<Chain> signs;
  for (const Contact &contact : at.contacts)
    signs.push_back(compared(contact.t, 0));
  return line(std::move(signs), aheadWords(at));
}

bool hasContact(const Out &at, std::size_t index) { return index < at.contacts.size(); }

WorkingLine hitLine(const Out &at, std::size_t index) {
  const auto &[t, H, n, isAhead] = at.contacts[index];
  return asked(withNumbers(H == at.Q + t * at.r));
}

WorkingLine normalLine(const Out &at, std::size_t index) {
  const auto &[t, H, n, isAhead] = at.contacts[index];
  return asked(withNumbers(n == (H - at.c) / at.R),
               words("From the centre outwards. Divided by {R} it is one unit long.", at.letters));
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
              at.hasChord ? words("h < {R}: the discriminant is positive.", at.letters)
              : !at.isMet ? words("h > {R}: the discriminant is negative.", at.letters)
                          : words("h = {R}: the discriminant is 0.", at.letters));
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {{{"w", &Out::isSphere, [](const Out &at) { return withNumbers(at.w == at.Q - at.c); },
         says("From the centre {c} to the start {Q}.")},
        {"a", &Out::hasLine, [](const Out &at) { return asked(withProducts(at.a == dot(at.r, at.r))); }},
        {"b", &Out::hasLine, [](const Out &at) { return asked(withProducts(at.b == dot(at.r, at.w))); }},
        {"k", &Out::hasLine, constantLine},
        {"quadratic", &Out::hasLine, quadraticLine},
        {"discriminant", &Out::hasLine, discriminantLine},
        {"t1", &Out::isMet, [](const Out &at) { return at.hasChord ? solutionLine(at, 0) : touchLine(at); }},
        {"t2", &Out::hasChord, [](const Out &at) { return solutionLine(at, 1); }},
        {"power", &Out::hasChord,
         [](const Out &at) { return withNumbers(at.contacts[0].t * at.contacts[1].t * dot(at.r, at.r)); },
         says("This is k: the same for every line through {Q} that meets the sphere twice.")},
        {"ahead", &Out::isMet, aheadLine}},
       linesOfEach<Out>(2, hasContact, {{"hit", hitLine}, {"normal", normalLine}}, 1),
       {{"nearest", &Out::hasLine,
         [](const Out &at) { return withNumbers(at.M == at.Q - at.b / at.a * at.r); },
         says("The line's point nearest to the centre: without the root, t is −b/a.")},
        {"h", &Out::hasLine, [](const Out &at) { return withNumbers(at.h == norm(at.M - at.c)); },
         says("How far the line passes from the centre.")},
        {"s", &Out::hasChord, chordLine},
        {"triangle", &Out::hasLine, triangleLine}}});
}

/// The unit normals are drawn this long in every picture.
constexpr double drawnNormalLength = 2;

void drawContact(Figure &figure, const Out &at, const Contact &contact) {
  addMeeting(figure, at.in.L, contact.H, contact.isAhead);
  figure.add(arrowInPicture(drawn(contact.n, Role::Derived, Subject::Measure), place(contact.H),
                            place(contact.n), drawnNormalLength));
}

/// The right triangle of the centre, the line's nearest point and the first contact. The radius is a mark of
/// its own: where there is no chord it leads to the one contact alone.
void drawTriangle(Figure &figure, const Out &at) {
  const Place center = place(at.c);
  const Place middle = place(at.M);
  const bool isBeside = at.nearest.which == PointLineCase::Off;
  figure.add(pointOf(at.M, Role::Derived, Subject::Measure));
  if (isBeside)
    figure.add(SegmentMark{drawn(at.h, Role::Derived, Subject::Measure), center, middle});
  if (!at.isMet)
    return;
  const Place contact = place(at.contacts.front().H);
  figure.add(SegmentMark{
      {at.mark("radius"), Role::Derived, Subject::Triangle, latexOf(at.in.S.letters[1])}, center, contact});
  if (!at.hasChord)
    return;
  figure.add(SegmentMark{drawn(at.s, Role::Result, Subject::Measure), middle, contact});
  if (isBeside)
    figure.add(RightAngleMark{
        {at.s->mark + "/angle", Role::Helper, Subject::Measure}, middle, center - middle, contact - middle});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isSphere)
    return figure;
  if (at.in.L.object.origin != at.in.S.object.center)
    figure.add(arrowOf(at.w, place(at.c), Role::Derived, Subject::Point));
  if (!at.hasLine)
    return figure;
  for (const Contact &contact : at.contacts)
    drawContact(figure, at, contact);
  drawTriangle(figure, at);
  return figure;
}

/// What the ray would be, moved sideways, whose line touches the sphere.
void addTangent(const Out &at, std::vector<SpecialCase> &all) {
  const Surd &distance = at.nearest.distance;
  const Rational &radius = at.in.S.object.radius;
  if (at.meet.contacts == SphereContacts::Tangent || distance == Surd())
    return;
  SpecialCase tangent{is("contacts", "tangent"), words("The ray's line would touch the sphere."), "L", {}};
  const ExactVec3 aside = at.nearest.foot - at.in.S.object.center;
  const auto &[origin, direction] = at.in.L.object;
  if (distance.isRational())
    tangent.object = RayObject{origin + aside * (radius / distance.rationalPart() - 1), direction};
  else
    tangent.rootedWay = (distance + -radius).squared();
  all.push_back(std::move(tangent));
}

/// What the ray would be, moved along its line, that starts at the nearer contact.
void addStartOnSphere(const Out &at, std::vector<SpecialCase> &all) {
  if (!at.isMet || at.meet.origin == SolidLocation::On)
    return;
  SpecialCase start{is("origin", "on"), words("{Q} would lie on the sphere.", at.letters), "L", {}};
  const Surd &first = at.meet.along.front().t;
  const Surd &last = at.meet.along.back().t;
  const Surd &nearer = first.squared() <= last.squared() ? first : last;
  const auto &[origin, direction] = at.in.L.object;
  if (nearer.isRational())
    start.object = RayObject{origin + direction * nearer.rationalPart(), direction};
  else
    start.rootedWay = nearer.squared() * dot(direction, direction);
  all.push_back(std::move(start));
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasLine)
    return all;
  addTangent(at, all);
  addStartOnSphere(at, all);
  if (at.nearest.which == PointLineCase::Off) {
    const auto &[origin, direction] = at.in.L.object;
    all.push_back({is("distance", "0"), words("The ray's line would go through the centre {c}.", at.letters),
                   "L", RayObject{origin + at.in.S.object.center - at.nearest.foot, direction}});
  }
  return all;
}

ValueRow<Out> contactRow(const std::string &name, std::size_t index) {
  return valueGroup<Out>(
      name, [index](const Out &at) { return hasContact(at, index); },
      {{named::vector("point"), always, [index](const Out &at) { return at.contacts[index].H; }},
       {named::vector("normal"), always, [index](const Out &at) { return at.contacts[index].n; }}});
}

Term parametersOf(const Out &at) {
  std::vector<Term> parameters;
  for (const Contact &contact : at.contacts)
    parameters.push_back(contact.t);
  return list(std::move(parameters));
}

} // namespace

Construction ray_sphere() {
  return taught<Out, SphereObject, RayObject>(
      {.id = "ray-sphere",
       .word = "intersect",
       .roles = {"S", "L"},
       .makes = {{"M", &Out::hasLine, &Out::M}},
       .letters = {"w", "a", "b", "k", "D", "t1", "t2", "H1", "H2", "n1", "n2", "h", "s"},
       .cases = {"hit", "behind", "miss", "zero-direction", "zero-radius"},
       .values = {{named::word("origin", {"outside", "on", "inside"}), &Out::isSphere,
                   [](const Out &at) {
                     return ToldValue(words("place of the start"), wordOf(at.meet.origin));
                   }},
                  {named::word("contacts", {"two", "tangent", "none"}), &Out::hasLine,
                   [](const Out &at) { return ToldValue(words("common points"), wordOf(at.meet.contacts)); }},
                  {named::number("discriminant"), &Out::hasLine, &Out::D},
                  {named::vector("nearest"), &Out::hasLine, &Out::M},
                  {named::number("distance"), &Out::hasLine, &Out::h},
                  {named::list("t", 2), &Out::isMet, parametersOf},
                  contactRow("first", 0),
                  contactRow("second", 1)},
       .lines = lines(),
       .marks = {"w", "H1", "n1", "H2", "n2", "M", "h", "radius", "s"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
