// How a plane reflects a ray, and how bright the ray makes it as light: the part of the direction along the
// normal, which turns round, the part across, which stays, and the angles of both rays with the normal.
#include "geometry/angle.h"
#include "geometry/case_names.h"
#include "geometry/project_vector.h"
#include "geometry/reflect_vector.h"
#include "lessons/construction/parts/mirror_lines.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/taught.h"
#include "lessons/term/angle.h"
#include "lessons/term/prime.h"

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
  const ExactVec3 &normal = in.E.object.normal;
  const ExactVec3 &direction = in.L.object.direction;
  bool isProper = !isZero(normal) && !isZero(direction); ///< whether there are a mirror and a ray
  ProjectedVector<Rational> parts = projectVector(direction, normal);
  ExactVec3 turned = isProper ? reflectVector(direction, normal) : ExactVec3(0);
  bool isPerpendicular = crosses && isZero(parts.rejection);

  Term t = ownName(letter("t"), meet.t);
  Term H = madeName("H", meet.point);
  Term product = dot(r, n);
  Term a = atH(vectorLetter("a"), parts.projection, "a"); ///< the part of r along n
  Term h = atH(vectorLetter("h"), parts.rejection, "h");  ///< the part of r across n
  Term rPrime = atH(primed(in.L.letters[1]), turned, "rprime");
  Term theta = atH(letter("θ"), std::nullopt, "theta");
  Term thetaPrime = atH(primed(letter("θ")), std::nullopt, "thetaprime");
  Term cosine = applied(word("cos"), theta, cosineBetween(ExactVec3(-direction), normal));
  Term cosinePrime = applied(word("cos"), thetaPrime, cosineBetween(turned, normal));
  Term brightness = norm(product) / (norm(r) * norm(n));

  /// A letter that is drawn at H, where there is one.
  [[nodiscard]] Term atH(const Symbol &symbol, const std::optional<TermValue> &value, const char *id) const {
    const Term letter = ownName(symbol, value);
    return crosses ? letter.marked(mark(id)) : letter;
  }
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    if (at.isPerpendicular)
      return {caseName,
              words("{r} runs straight along {n}: the mirror sends the ray straight back.", at.letters)};
    if (at.meet.t == 0)
      return {caseName, words("t = 0: the ray starts in the mirror, and is turned there.")};
    return {caseName, words("The ray hits the mirror: its part along {n} turns round, and its part across "
                            "stays.",
                            at.letters)};
  case RayPlaneCase::Behind:
    return {caseName, words("{t} is negative: the mirror is behind the ray's start. Only the line of the "
                            "ray meets it, so the ray is not reflected.",
                            {{"t", equation(at.t)}})};
  case RayPlaneCase::Parallel:
    return {caseName, words("{r}·{n} = 0: the ray runs beside the mirror and never meets it. Nothing turns "
                            "round.",
                            at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName, words("{r}·{n} = 0 and {Q} is in the mirror: the ray runs along in it. Nothing turns "
                            "round.",
                            at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

/// Whether the reflected ray goes up: a question about tilted mirrors.
Word wayWord(const Out &at) {
  if (at.meet.which != RayPlaneCase::Hit)
    return {"none", words("nowhere")};
  const int sign = at.turned.z.sign();
  return sign > 0   ? Word{"up", words("upwards")}
         : sign < 0 ? Word{"down", words("downwards")}
                    : Word{"level", words("level")};
}

std::string hitWords(const Out &at) {
  return at.meet.which == RayPlaneCase::Hit
             ? words("The point where the ray meets the mirror.")
             : words("Only the line of the ray meets the mirror there, behind the start.");
}

std::string productWords(const Out &at) {
  const int sign = at.meet.denominator.sign();
  return sign < 0   ? words("Negative: {r} goes against {n}.", at.letters)
         : sign > 0 ? words("Positive: {r} goes to the side that {n} points to.", at.letters)
                    : words("Zero: {r} runs along the mirror and has no part along {n}.", at.letters);
}

/// How often n is the part of r along it.
Term timesNormal(const Out &at) { return at.product / dot(at.n, at.n); }

WorkingLine alongLine(const Out &at) {
  return asked(
      withNumbers(at.a == timesNormal(at) * at.n),
      words("The part of {r} along {n}: {r} projected onto {n}.", at.letters),
      {{at.product * at.n,
        words("{answer} is ({r}·{n}){n}. That is the part only when |{n}| = 1: divide by {n}·{n}.",
              at.letters)},
       {at.product / norm(at.n) * at.n,
        words("{answer} is divided by |{n}| once. {n} itself has this length too: divide by {n}·{n}.",
              at.letters)},
       {at.product / dot(at.r, at.r) * at.r,
        words("{answer} is the projection of {n} onto {r}.", at.letters)},
       {at.h, words("{answer} is the part across {n}.", at.letters)}});
}

WorkingLine acrossLine(const Out &at) {
  return asked(withNumbers(at.h == at.r - at.a),
               isZero(at.parts.rejection) ? words("The zero vector: {r} runs straight along {n}.", at.letters)
                                          : words("What is left: the part of {r} across {n}.", at.letters));
}

/// What comes out of the mirror, in a line that says more where it turns something.
std::string turnedWords(const Out &at, std::string sentence) {
  return at.crosses ? std::move(sentence) : words("{r} itself: there is nothing to turn round.", at.letters);
}

std::string reflectedWords(const Out &at) {
  return at.meet.which == RayPlaneCase::Behind
             ? words("The direction in which the mirror would send light that came along this line.")
             : turnedWords(at, words("The direction in which the mirror sends the ray."));
}

WorkingLine turnedLine(const Out &at) {
  return asked(
      withNumbers(at.rPrime == at.h - at.a),
      turnedWords(at, words("The part across stays, and the part along {n} turns round.", at.letters)),
      {{at.h + at.a, words("{answer} is {r} again: the part along {n} must change its sign.", at.letters)}});
}

MirroredDirection mirrored(const Out &at) { return {at.r, at.n, at.rPrime}; }

WorkingLine incidenceLine(const Out &at) {
  return asked(
      withNumbers(at.cosine == dot(-at.r, at.n) / (norm(at.r) * norm(at.n))),
      words("θ{degrees}°: the angle between −{r}, which leads back, and {n}.", at.letters,
            {{"degrees", relatedText(degreesOf(at.cosine))}}),
      {{at.product / (norm(at.r) * norm(at.n)),
        words("{answer} belongs to the angle between {r} and {n}. The way back is −{r}.", at.letters)}});
}

WorkingLine departureLine(const Out &at) {
  return asked(
      withNumbers(at.cosinePrime == dot(at.rPrime, at.n) / (norm(at.rPrime) * norm(at.n))),
      words("θ′{degrees}°: the angle between {reflected} and {n}. It is as large as θ.", at.letters,
            {{"degrees", relatedText(degreesOf(at.cosinePrime))}, {"reflected", plainText(at.rPrime)}}));
}

std::string brightnessWords(const Out &at) {
  if (!at.crosses)
    return words("0: the light runs along the plane and does not make it bright.");
  if (at.meet.which == RayPlaneCase::Behind)
    return words("Light that came to the plane in this direction would make it so bright.");
  return isZero(at.parts.rejection)
             ? words("1: light straight along {n} makes the plane as bright as can be.", at.letters)
             : words("Less than 1: the light falls at a slant, so it is spread over more of the plane.");
}

LineTable<Out> lines() {
  return {
      {"t", &Out::crosses,
       [](const Out &at) { return withNumbers(at.t == dot(at.P0 - at.Q, at.n) / at.product); },
       says("It takes this many steps {r} to get from {Q} to the mirror.")},
      {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.H == at.Q + at.t * at.r); }, hitWords},
      {"dot", &Out::isProper, [](const Out &at) { return withProducts(at.product); }, productWords},
      {"along", &Out::isProper, alongLine},
      {"across", &Out::isProper, acrossLine},
      {"check", &Out::isProper, [](const Out &at) { return line(withProducts(dot(at.h, at.n))); }},
      {"turned", &Out::isProper, turnedLine},
      {"reflected", &Out::isProper,
       [](const Out &at) { return mirroredLine(mirrored(at), at, reflectedWords(at)); }},
      {"lengths", &Out::isProper, [](const Out &at) { return sameLengthLine(mirrored(at)); }},
      {"incidence", &Out::isProper, incidenceLine},
      {"departure", &Out::isProper, departureLine},
      {"brightness", &Out::isProper, [](const Out &at) { return withNumbers(at.brightness); },
       brightnessWords}};
}

/// The normal is drawn so many times as long at H as it is.
constexpr double drawnNormalLength = 3;

void addArc(Figure &figure, const Term &angle, const Place &from, const Place &side, const Out &at) {
  if (!at.isPerpendicular)
    figure.add(ArcMark{drawn(angle, Role::Derived, Subject::Neutral), from, side, place(at.n)});
}

/// At H: the direction as it would go on without the mirror, its parts, and what becomes of them. The part
/// along n leads from the tip of the part across to that of r, and turned round to that of r′.
void drawReflection(Figure &figure, const Out &at) {
  const Place H = place(at.H);
  const Place r = place(at.r);
  const Place a = place(at.a);
  const Place h = place(at.h);
  figure.add(arrowInPicture({at.mark("normal"), Role::Helper, Subject::Plane, latexOf(at.n)}, H,
                            unitOf(at.normal), drawnNormalLength));
  figure.add(
      inLook(at.in.L.look, ArrowMark{{at.mark("onward"), Role::Ghost, Subject::Ray, latexOf(at.r)}, H, r}));
  figure.add(ArrowMark{drawn(at.a, Role::Derived, Subject::EdgeV), H + h, a});
  figure.add(ArrowMark{{at.mark("minus-a"), Role::Derived, Subject::EdgeV}, H + h, -a});
  if (!isZero(at.parts.rejection)) {
    figure.add(ArrowMark{drawn(at.h, Role::Derived, Subject::EdgeU), H, h});
    figure.add(RightAngleMark{{at.h->mark + "/angle", Role::Helper, Subject::EdgeU}, H + h, -h, a});
  }
  figure.add(arrowOf(at.rPrime, H, at.meet.which == RayPlaneCase::Hit ? Role::Result : Role::Ghost,
                     Subject::Measure));
  addArc(figure, at.theta, H, -r, at);
  addArc(figure, at.thetaPrime, H, place(at.rPrime), at);
}

Figure draw(const Out &at) {
  Figure figure;
  addMeeting(figure, at.in.L, at.in.E, at.meet, at.H);
  if (at.crosses) {
    drawReflection(figure, at);
    figure.reaches.push_back({at.in.E.id, place(at.H) + place(at.h)});
  }
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.isProper)
    return all;
  const RayObject &ray = at.in.L.object;
  addRaysAtPlane(
      ray, at.in.E.object,
      {words("{Q} would lie in the mirror, and the ray would be turned at its own start.", at.letters),
       words("The ray would lie in the mirror."),
       words("The ray would run beside the mirror, and nothing would turn round.")},
      all);
  if (at.meet.which == RayPlaneCase::Hit && !at.isPerpendicular)
    all.push_back({is("brightness", "1"), words("The ray would be sent straight back."), "L",
                   RayObject{ray.origin, at.parts.projection}});
  return all;
}

ValueTable<Out> values() {
  return {{named::number("t"), &Out::crosses, &Out::t},
          {named::vector("point"), &Out::crosses, &Out::H},
          {named::number("dot"), always, &Out::product},
          {named::vector("along"), &Out::isProper, &Out::a},
          {named::vector("across"), &Out::isProper, &Out::h},
          {named::vector("reflected"), &Out::isProper, &Out::rPrime},
          {named::word("points", {"up", "down", "level", "none"}), always,
           [](const Out &at) { return ToldValue(words("direction of the reflected ray"), wayWord(at)); }},
          {named::number("turn"), &Out::isProper, [](const Out &at) { return dot(at.r, at.rPrime); }},
          {named::number("cos_incidence"), &Out::isProper, &Out::cosine},
          {named::number("brightness"), &Out::isProper,
           [](const Out &at) { return ToldValue(words("brightness"), listed({}, at.brightness).value); }}};
}

} // namespace

Construction reflection() {
  return taught<Out, PlaneObject, RayObject>(
      {.id = "reflection",
       .word = "reflect",
       .title = [] { return words("direction of reflection"); },
       .roles = {"E", "L"},
       .makes = {{"H", &Out::crosses, &Out::H}},
       .letters = {"t", "a", "h", "θ"},
       .cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = values(),
       .lines = lines(),
       .marks = {"H", "normal", "onward", "a", "minus-a", "h", "rprime", "theta", "thetaprime"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
