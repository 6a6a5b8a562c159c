// Where a ray meets a sphere, by the quadratic equation for its parameter (note CG), and the right triangle
// behind its discriminant.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_sphere.h"
#include "lessons/construction/parts/line_at_sphere.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/value_words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<SphereObject> S;
  Given<RayObject> L;
};

struct Out : Computed<In>, RayTerms, LineAtSphere {
  explicit Out(const In &objects)
      : Computed(objects), RayTerms(termsOf(objects.L)), LineAtSphere(objects, objects.S, Q, r) {}

  RaySphereCase which = caseOfRay(met);

  /// Whether the ray gets to a contact.
  [[nodiscard]] bool isAhead(std::size_t contact) const { return met.along[contact].t.sign() >= 0; }
};

std::string twiceWords(const Out &at) {
  const WordValues values{{"t1", equation(at.contacts[0].t)},
                          {"t2", equation(at.contacts[1].t)},
                          {"H1", plainText(at.contacts[0].H)},
                          {"H2", plainText(at.contacts[1].H)}};
  if (!at.isAhead(1))
    return words("{t1} and {t2} are both negative: the sphere is behind the ray's start.", values);
  switch (at.met.origin) {
  case SolidLocation::Outside:
    return words("The ray enters the sphere at {H1}, with {t1}, and leaves it at {H2}, with {t2}.", values);
  case SolidLocation::Inside:
    return words(
        "The ray starts inside: {t1} is behind its start, and it leaves the sphere at {H2}, with {t2}.",
        values);
  case SolidLocation::On:
    break;
  }
  return at.isAhead(0)
             ? words("The ray starts on the sphere, goes inside and leaves it at {H2}, with {t2}.", values)
             : words("The ray starts on the sphere and leads away from it: it has only its start, {H2}, in "
                     "common with it.",
                     values);
}

std::string onceWords(const Out &at) {
  const ContactTerms &touch = at.contacts.front();
  const WordValues values{{"t", equation(touch.t)}, {"H", plainText(touch.H)}};
  return at.isAhead(0)
             ? words("D = 0: the ray touches the sphere in one point, {H}, with {t}.", values)
             : words("D = 0: the line touches the sphere in one point, {H}. But {t} is negative: it is "
                     "behind the ray's start.",
                     values);
}

CaseWords tell(const Out &at) {
  if (!at.isSphere)
    return {"zero-radius", words("The radius is 0: the sphere is only the point {c}.", at.letters), true};
  if (at.which == RaySphereCase::ZeroDirection)
    return zeroDirectionWords(at);
  const std::string caseName(nameOf(at.which));
  switch (at.met.contacts) {
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

std::string aheadWords(const Out &at) {
  const std::size_t behind = at.isAhead(0) ? 0 : at.isAhead(at.contacts.size() - 1) ? 1 : 2;
  if (behind == 0)
    return words("No t is negative: what the line meets, the ray meets too.");
  return behind == 1 && at.hasChord
             ? words("Only one t is not negative: the ray meets the sphere once.")
             : words("No t ≥ 0: the line meets the sphere, but only behind the start. The ray misses it.");
}

WorkingLine aheadLine(const Out &at) {
  std::vector<Chain> signs;
  for (const ContactTerms &contact : at.contacts)
    signs.push_back(compared(contact.t, 0));
  return line(std::move(signs), aheadWords(at));
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>({equationLines<Out>(says("From the centre {c} to the start {Q}.")),
                               {{"ahead", &Out::isMet, aheadLine}},
                               contactLines<Out>()});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isSphere)
    return figure;
  if (at.start != at.sphere.center)
    figure.add(arrowOf(at.w, place(at.c), Role::Derived, Subject::Point));
  if (!at.hasLine)
    return figure;
  for (std::size_t i = 0; i < at.contacts.size(); ++i) {
    addMeeting(figure, at.in.L, at.contacts[i].H, at.isAhead(i));
    drawNormal(figure, at.contacts[i]);
  }
  drawRightTriangle(figure, at, at);
  return figure;
}

/// What the ray would be, moved along its line, that starts at the nearer contact.
void addStartOnSphere(const Out &at, std::vector<SpecialCase> &all) {
  if (!at.isMet || at.met.origin == SolidLocation::On)
    return;
  SpecialCase start{is("origin", "on"), words("{Q} would lie on the sphere.", at.letters), "L", {}};
  const Surd &first = at.met.along.front().t;
  const Surd &last = at.met.along.back().t;
  const Surd &nearer = first.squared() <= last.squared() ? first : last;
  if (nearer.isRational())
    start.object = RayObject{at.start + at.direction * nearer.rationalPart(), at.direction};
  else
    start.rootedWay = nearer.squared() * dot(at.direction, at.direction);
  all.push_back(std::move(start));
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasLine)
    return all;
  addTouching<RayObject>(
      at, {is("contacts", "tangent"), words("The ray's line would touch the sphere."), "L", {}}, all);
  addStartOnSphere(at, all);
  addThroughCenter<RayObject>(
      at,
      {is("distance", "0"), words("The ray's line would go through the centre {c}.", at.letters), "L", {}},
      all);
  return all;
}

} // namespace

Construction ray_sphere() {
  return taught<Out, SphereObject, RayObject>(
      {.id = "ray-sphere",
       .word = "intersect",
       .title = [] { return words("where the ray meets the sphere"); },
       .roles = {"S", "L"},
       .makes = {{"M", &Out::hasLine, &Out::M}},
       .letters = {"w", "a", "b", "k", "D", "t1", "t2", "H1", "H2", "n1", "n2", "h", "s"},
       .cases = {"hit", "behind", "miss", "zero-direction", "zero-radius"},
       .values = joined<ValueRow<Out>>(
           {{{named::word("origin", {"outside", "on", "inside"}), &Out::isSphere,
              [](const Out &at) { return ToldValue(words("place of the start"), wordOf(at.met.origin)); }},
             {named::word("contacts", {"two", "tangent", "none"}), &Out::hasLine,
              [](const Out &at) { return ToldValue(words("common points"), wordOf(at.met.contacts)); }}},
            lineAtSphereRows<Out>()}),
       .lines = lines(),
       .marks = {"w", "H1", "n1", "H2", "n2", "M", "h", "radius", "s"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
