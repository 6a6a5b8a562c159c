// The ray that a mirror sends on where a ray hits it. It can hit another mirror.
#include "geometry/case_names.h"
#include "geometry/reflect_vector.h"
#include "lessons/construction/parts/mirror_lines.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<RayObject> L;
};

struct Out : Computed<In>, PlaneTerms, RayTerms {
  explicit Out(const In &objects)
      : Computed(objects), PlaneTerms(termsOf(objects.E)), RayTerms(termsOf(objects.L)) {}

  RayPlane<Rational> meet = meetingOf(in.L.object, in.E.object);
  bool crosses = meet.crosses();
  bool hits = meet.which == RayPlaneCase::Hit;
  bool isProper = !isZero(in.E.object.normal) && !isZero(in.L.object.direction); ///< a mirror and a ray
  RayObject sent =
      hits ? RayObject{meet.point, reflectVector(in.L.object.direction, in.E.object.normal)} : RayObject{};
  bool isPerpendicular = hits && isZero(cross(in.L.object.direction, in.E.object.normal));

  Term t = ownName(letter("t"), meet.t);
  Term product = dot(r, n);
  Term start = madeName("R", "Q", sent.origin);
  Term direction = madeName("R", "r", sent.direction);

  [[nodiscard]] MirroredDirection mirrored() const { return {r, n, direction}; }
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    return {caseName,
            at.isPerpendicular
                ? words("{L} hits the mirror at a right angle: the ray {R} runs straight back.", at.letters)
                : words("{L} hits the mirror in {R.Q}, and goes on from there as the ray {R}.", at.letters)};
  case RayPlaneCase::Behind:
    return {caseName, words("{t} is negative: {L} points away from the mirror, and nothing is sent on.",
                            at.letters, {{"t", equation(at.t)}})};
  case RayPlaneCase::Parallel:
    return {caseName,
            words("{r}·{n} = 0: {L} runs parallel to the mirror, and nothing is sent on.", at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName, words("{r}·{n} = 0 and {Q} is in the mirror: {L} runs along in it, and nothing is "
                            "sent on.",
                            at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

std::string productWords(const Out &at) {
  return at.crosses ? words("Not 0: the line of {L} meets the mirror once.", at.letters)
                    : words("0: {r} runs along the mirror, and never comes nearer to it.", at.letters);
}

std::string stepsWords(const Out &at) {
  return at.hits ? words("So many steps {r} lead from {Q} to the mirror.", at.letters)
                 : words("Negative: the mirror is behind {Q}.", at.letters);
}

std::string startWords(const Out &at) {
  return at.meet.t == 0 ? words("{Q} itself: the ray starts in the mirror.", at.letters)
                        : words("Where {L} hits the mirror, {R} starts.", at.letters);
}

WorkingLine directionLine(const Out &at) {
  return mirroredLine(
      at.mirrored(), at,
      at.isPerpendicular
          ? words("{r} runs along {n}, and is turned round as a whole.", at.letters)
          : words("The part of {r} along {n} turns round, and the part across {n} stays.", at.letters));
}

LineTable<Out> lines() {
  return {{"dot", &Out::isProper, [](const Out &at) { return withProducts(at.product); }, productWords},
          {"t", &Out::crosses,
           [](const Out &at) { return withNumbers(at.t == dot(at.P0 - at.Q, at.n) / at.product); },
           stepsWords},
          {"start", &Out::hits, [](const Out &at) { return withNumbers(at.start == at.Q + at.t * at.r); },
           startWords},
          {"direction", &Out::hits, directionLine},
          {"lengths", &Out::hits, [](const Out &at) { return sameLengthLine(at.mirrored()); }}};
}

Figure draw(const Out &at) {
  Figure figure;
  if (at.meet.which == RayPlaneCase::InPlane)
    figure.reachWithin(at.in.E.id, at.in.L.id, place(at.Q), unitOf(at.in.L.object.direction));
  if (!at.hits)
    return figure;
  const Place start = place(at.start);
  figure.reaches.push_back({at.in.E.id, start});
  addMeeting(figure, at.in.L, at.start, true);
  figure.add(RayMark{{at.mark("R"), Role::Result, Subject::Ray}, start, unitOf(at.sent.direction)});
  ArrowMark direction = arrowOf(at.direction, start, Role::Result, Subject::Ray);
  direction.isFree = true;
  figure.add(std::move(direction));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (at.isProper)
    addRaysAtPlane(at.in.L.object, at.in.E.object,
                   {words("{Q} would lie in the mirror, and {R} would start there, too.", at.letters),
                    words("{L} would run along in the mirror.", at.letters),
                    words("{L} would run parallel to the mirror.", at.letters)},
                   all);
  return all;
}

} // namespace

Construction mirror_ray() {
  return taught<Out, PlaneObject, RayObject>(
      {.id = "mirror-ray",
       .word = "mirror",
       .title = [] { return words("reflected ray"); },
       .roles = {"E", "L"},
       .makes = {{"R", RayObject::kind, &Out::hits, &Out::sent}},
       .letters = {"t"},
       .cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = {{named::number("dot"), always, &Out::product},
                  {named::number("t"), &Out::crosses, &Out::t},
                  {named::vector("point"), &Out::hits, &Out::start},
                  {named::vector("direction"), &Out::hits, &Out::direction}},
       .lines = lines(),
       .marks = {"R", "R.Q", "R.r"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
