// Where a ray meets a plane, by substitution and by dot products (notes PG 4 and 5; facing normal: note RP
// 28).
#include "geometry/case_names.h"
#include "geometry/project_vector.h"
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

  Plane<Rational> plane = planeThrough(in.E.object.point, in.E.object.normal);
  RayPlane<Rational> meet = meetingOf(in.L.object, in.E.object);
  bool crosses = meet.crosses();
  bool hasPlane = meet.which != RayPlaneCase::ZeroNormal;

  Term d = ownName(letter("d"), plane.offset).standingFor(-dot(n, P0));
  Term f = applied(own(letter("f")), Q, evaluate(plane, in.L.object.origin)).standingFor(dot(n, Q - P0));
  Term numerator = dot(P0 - Q, n); ///< of t
  Term denominator = dot(r, n);
  ProjectedVector<Rational> left =
      projectVector(ExactVec3(in.E.object.point - in.L.object.origin), in.E.object.normal);
  ProjectedVector<Rational> step = projectVector(in.L.object.direction, in.E.object.normal);
  Term a = drawnName(vectorLetter("a"), left.projection); ///< from Q straight to the plane
  Term b = drawnName(vectorLetter("b"), step.projection); ///< the part of r along n
  Term t = ownName(letter("t"), meet.t);
  Term H = madeName("H", meet.point);
  /// The unit normal towards where the ray comes from, where it crosses the plane.
  Term facing = ownName(vectorLetter("n", "f"), facingOf(in.E.object, in.L.object)).marked(mark("facing"));
};

CaseWords tell(const Out &at) {
  const std::string t = equation(at.t);
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    if (at.meet.t == 0)
      return {caseName, words("t = 0: the ray starts in the plane, so it hits at its own start.")};
    return {caseName, words("{t} is positive: the ray hits the plane.", {{"t", t}})};
  case RayPlaneCase::Behind:
    return {caseName,
            words("{t} is negative: the plane is behind the ray's start, so the ray does not hit it.",
                  {{"t", t}})};
  case RayPlaneCase::Parallel:
    return {
        caseName,
        words(
            "{r}·{n} = 0 but ({P0} − {Q})·{n} is not: the ray runs parallel to the plane and never meets it.",
            at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName,
            words("{r}·{n} = 0 and ({P0} − {Q})·{n} = 0: the ray lies in the plane. Every t fits, so "
                  "0/0 names no single point.",
                  at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

/// The sentence, where there are a plane and a ray that it can speak of; else which of them is missing.
std::string wordsOfBoth(const Out &at, std::string sentence) {
  if (at.meet.which == RayPlaneCase::ZeroNormal)
    return words("{n} is the zero vector: there is no plane.", at.letters);
  if (at.meet.which == RayPlaneCase::ZeroDirection)
    return words("{r} is the zero vector: there is no ray.", at.letters);
  return sentence;
}

WorkingLine substituteLine(const Out &at) {
  const Term inserted = dot(at.n, at.Q + unknown("t") * at.r) + at.d;
  return askedEquation(
      condition((0 == inserted).then(multipliedOut(inserted))),
      wordsOfBoth(at,
                  words("The ray's points {Q} + t·{r} put into the plane's equation. One unknown is left: t.",
                        at.letters)));
}

std::string collectWords(const Out &at) {
  if (at.meet.denominator != 0)
    return words("Collected by t: {r}·{n} is the coefficient of t, and f({Q}) the constant term.",
                 at.letters);
  return at.meet.numerator == 0
             ? words("{r}·{n} is 0, and so is f({Q}): t drops out, and every t satisfies 0 = 0.", at.letters)
             : words("{r}·{n} is 0: t drops out, and f({Q}) is not 0, so no t satisfies the equation.",
                     at.letters);
}

WorkingLine collectLine(const Out &at) {
  const Term collected = at.denominator * unknown("t") + at.f;
  return askedEquation(condition((0 == collected).then(calculated(collected))), collectWords(at));
}

WorkingLine numeratorLine(const Out &at) {
  return asked(
      withNumbers(at.numerator),
      wordsOfBoth(
          at,
          words("This is −f({Q}). It says how far the plane is from {Q} along {n}, times |{n}|: a distance "
                "only when |{n}| = 1, or when it is 0.",
                at.letters)),
      {{at.f, words("{answer} is f({Q}) = {n}·({Q} − {P0}): the numerator goes the other way, from {Q} "
                    "to {P0}.",
                    at.letters)}});
}

std::string denominatorWords(const Out &at) {
  return wordsOfBoth(at,
                     words("How far one step {r} goes along {n}, times |{n}|. Zero means that no step comes "
                           "nearer to the plane.",
                           at.letters));
}

std::string leftWords(const Out &at) {
  return isZero(at.left.projection) ? words("The zero vector: {Q} lies in the plane.", at.letters)
                                    : words("From {Q} straight to the plane, along {n}.", at.letters);
}

std::string stepWords(const Out &at) {
  return wordsOfBoth(at, isZero(at.step.projection)
                             ? words("The zero vector: {r} does not lead nearer to the plane.", at.letters)
                             : words("The part of {r} along {n}: what one step brings.", at.letters));
}

WorkingLine parameterLine(const Out &at) {
  return asked(withNumbers(at.t == at.numerator / at.denominator),
               words("It takes this many steps {r} to get from {Q} to the plane. This is a distance only "
                     "when |{r}| = 1, or when it is 0.",
                     at.letters),
               {wrongSignOf(at.t, at)});
}

std::string hitWords(const Out &at) {
  return at.meet.which == RayPlaneCase::Hit
             ? words("The point where the ray meets the plane.")
             : words("Here the line through the ray meets the plane, behind the start: the ray itself never "
                     "gets there.");
}

WorkingLine facingLine(const Out &at) {
  const Term unit = at.n / norm(at.n);
  return at.meet.denominator > 0
             ? asked(withResult(at.facing == -unit),
                     words("{r}·{n} is positive: {r} goes to the side that {n} points to. So the facing "
                           "normal is −{n}, made one unit long.",
                           at.letters))
             : asked(withResult(at.facing == unit),
                     words("{r}·{n} is negative: {r} goes against {n}. So the facing normal is {n}, made one "
                           "unit long.",
                           at.letters));
}

/// What is left to the plane, at the start of the ray, with its right angle there.
void drawLeft(Figure &figure, const Out &at) {
  if (isZero(at.left.projection))
    return;
  figure.add(arrowOf(at.a, place(at.Q), Role::Derived, Subject::Measure));
  const ExactVec3 foot = at.in.L.object.origin + at.left.projection;
  const ExactVec3 inPlane =
      isZero(at.step.rejection) ? ExactVec3(at.in.E.object.point - foot) : at.step.rejection;
  if (!isZero(inPlane))
    figure.add(RightAngleMark{
        {at.a->mark + "/angle", Role::Helper, Subject::Measure}, place(foot), -place(at.a), place(inPlane)});
}

/// What one step brings, with the way across from the tip of the step.
void drawStep(Figure &figure, const Out &at) {
  if (isZero(at.step.projection))
    return;
  const Place start = place(at.Q);
  figure.add(arrowOf(at.b, start, Role::Derived, Subject::EdgeU)); // beside the ray in its own colour
  if (!isZero(at.step.rejection))
    figure.add(SegmentMark{
        {at.b->mark + "/across", Role::Helper, Subject::EdgeU}, start + place(at.b), start + place(at.r)});
}

/// The unit normal is drawn this long in every picture.
constexpr double drawnNormalLength = 2.5;

Figure draw(const Out &at) {
  Figure figure;
  addMeeting(figure, at.in.L, at.in.E, at.meet, at.H);
  if (at.crosses)
    figure.add(arrowInPicture(drawn(at.facing, Role::Derived, Subject::Measure), place(at.H),
                              place(at.facing), drawnNormalLength));
  if (at.hasPlane) {
    drawLeft(figure, at);
    drawStep(figure, at);
  }
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (isZero(vectorOf(at.n)) || isZero(vectorOf(at.r)))
    return all;
  addRaysAtPlane(at.in.L.object, at.in.E.object,
                 {words("{Q} would lie in the plane, and the ray would hit it at its own start.", at.letters),
                  words("The ray would lie in the plane."),
                  words("The ray would run parallel to the plane.")},
                 all);
  return all;
}

} // namespace

Construction ray_plane_dot() {
  return taught<Out, PlaneObject, RayObject>(
      {.id = "ray-plane-dot",
       .word = "intersect",
       .title = [] { return words("where the ray meets the plane"); },
       .roles = {"E", "L"},
       .makes = {{"H", &Out::crosses, &Out::H}},
       .letters = {"d", "f", "a", "b", "t", "nf"},
       .cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = {{named::number("numerator"), always, &Out::numerator},
                  {named::number("denominator"), always, &Out::denominator},
                  {named::number("t"), &Out::crosses, &Out::t},
                  {named::vector("point"), &Out::crosses, &Out::H},
                  {named::vector("facing_normal"), &Out::crosses, &Out::facing}},
       .lines = {{"substitute", always, substituteLine},
                 {"collect", always, collectLine},
                 {"numerator", always, numeratorLine},
                 {"denominator", always, [](const Out &at) { return withNumbers(at.denominator); },
                  denominatorWords},
                 {"left", &Out::hasPlane,
                  [](const Out &at) { return withNumbers(at.a == at.numerator / dot(at.n, at.n) * at.n); },
                  leftWords},
                 {"step", &Out::hasPlane,
                  [](const Out &at) { return withNumbers(at.b == at.denominator / dot(at.n, at.n) * at.n); },
                  stepWords},
                 {"t", &Out::crosses, parameterLine},
                 {"ratio", &Out::crosses, [](const Out &at) { return withNumbers(at.a == at.t * at.b); },
                  says("What is left is t times what one step brings.")},
                 {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.H == at.Q + at.t * at.r); },
                  hitWords},
                 {"facing", &Out::crosses, facingLine}},
       .marks = {"H", "a", "b", "facing"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
