// Where a ray meets a plane, as a picture (note RP 23 to 28): what D, v_d and v_0 measure along the normal,
// and the similar triangles from which t follows. The note's R_0 is Q here, its R_d is r, its r_i is H; its
// normal is one unit long, and here of any length.
#include "geometry/case_names.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> G;
  Given<RayObject> L;
};

struct Out : Computed<In>, PlaneTerms, RayTerms {
  explicit Out(const In &objects)
      : Computed(objects), PlaneTerms(termsOf(objects.G)), RayTerms(termsOf(objects.L)) {}

  RayPlane<Rational> meet = meetingOf(in.L.object, in.G.object);
  bool hasPlane = meet.which != RayPlaneCase::ZeroNormal;
  /// Whether there are a plane and a ray.
  bool isProper = hasPlane && meet.which != RayPlaneCase::ZeroDirection;
  bool crosses = meet.crosses();
  ExactVec3 toPlane = projectVector(in.G.object.point, in.G.object.normal).projection;
  ExactVec3 toStart = projectVector(in.L.object.origin, in.G.object.normal).projection;
  ExactVec3 along = projectVector(in.L.object.direction, in.G.object.normal).projection;
  ExactVec3 across = in.L.object.direction - along; ///< the part of r that lies in the plane's direction

  Term D = ownName(letter("D"), dot(in.G.object.point, in.G.object.normal)).marked(mark("OB"));
  Term vd = ownName(letter("v", "d"), meet.denominator).marked(mark("QE"));
  Term v0 = ownName(letter("v", "0"), meet.numerator).marked(mark("QC"));
  Term t = ownName(letter("t"), meet.t);
  Term H = madeName("H", meet.point);

  // The origin, and the feet of Q and of the plane on the line through it along n.
  Term O = drawnName(letter("O"), ExactVec3(0));
  Term A = drawnName(letter("A"), toStart);
  Term B = drawnName(letter("B"), toPlane);
  // The foot of Q in the plane, that of F on QC, and the tip of r.
  Term C = drawnName(letter("C"), ExactVec3(in.L.object.origin + toPlane - toStart));
  Term E = drawnName(letter("E"), ExactVec3(in.L.object.origin + along));
  Term F = drawnName(letter("F"), ExactVec3(in.L.object.origin + in.L.object.direction));
  /// The unit normal towards where the ray comes from, where it crosses the plane.
  Term facing = ownName(vectorLetter("n", "f"), facingOf(in.G.object, in.L.object)).marked(mark("facing"));
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const std::string t = equation(at.t);
  const std::string v0 = equation(at.v0);
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    if (at.meet.t == 0)
      return {caseName, words("{v0}: {Q} lies in the plane, and the ray hits it at its own start.",
                              {{"v0", v0}, {"Q", plainText(at.Q)}})};
    return {caseName, words("{t} is positive: the ray hits the plane after so many steps {r}.",
                            {{"t", t}, {"r", plainText(at.r)}})};
  case RayPlaneCase::Behind:
    return {caseName, words("{t} is negative: the plane is behind the ray's start.", {{"t", t}})};
  case RayPlaneCase::Parallel:
    return {caseName,
            words("{r} has no part along {n}: the ray runs parallel to the plane and never meets it.",
                  at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName, words("{r} has no part along {n}, and {Q} is in the plane: the whole ray lies in it, "
                            "and no single point is the hit.",
                            at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

/// Of a fraction: −1, 0, 1.
int signOf(const Term &term) { return sign(*numberOf(term)).value(); }

/// Which way the plane lies, seen from the origin.
Word wayOf(const Out &at) {
  const int sign = signOf(at.D);
  return sign > 0   ? Word{"with-n", words("with {n}", at.letters)}
         : sign < 0 ? Word{"against-n", words("against {n}", at.letters)}
                    : noneOfThem();
}

/// What becomes of n in the facing normal.
Word turnOf(const Out &at) {
  if (!at.crosses)
    return noneOfThem();
  return at.meet.denominator > 0 ? Word{"turned", words("{n} turned round", at.letters)}
                                 : Word{"kept", words("{n} as it is", at.letters)};
}

/// What belongs to n as a whole: how far a product with it reaches, as a vector.
Term alongNormal(const Out &at, const Term &product) { return product / dot(at.n, at.n) * at.n; }

std::string originWords(const Out &at) {
  const int sign = signOf(at.D);
  return sign > 0
             ? words("Positive: the plane lies on that side of the origin to which {n} points.", at.letters)
         : sign < 0    ? words("Negative: from the origin to the plane you go against {n}.", at.letters)
         : at.hasPlane ? words("Zero: the plane passes through the origin.")
                       : zeroWithoutPlane(at);
}

std::string stepWords(const Out &at) {
  const int sign = at.meet.denominator.sign();
  return sign > 0      ? words("Positive: each step {r} goes to the side that {n} points to.", at.letters)
         : sign < 0    ? words("Negative: each step {r} goes against {n}.", at.letters)
         : at.hasPlane ? words("Zero: no step gains anything along {n}.", at.letters)
                       : zeroWithoutPlane(at);
}

WorkingLine startLine(const Out &at) {
  return asked(
      withNumbers(at.v0 == at.D - dot(at.n, at.Q)),
      at.hasPlane ? words("From where {Q} is, along {n}, to where the plane is.", at.letters)
                  : zeroWithoutPlane(at),
      {{-at.v0, words("{answer} is {n}·{Q} − D, from the plane to {Q}: turn it round.", at.letters)}});
}

/// The opposite sides of the rectangle, as vectors: Q, A, B and C are flat where Q is on the line from the
/// origin along n, or in the plane.
WorkingLine rectangleLine(const Out &at) {
  const ExactVec3 Q = vectorOf(at.Q);
  const bool areCorners = Q != vectorOf(at.A) && Q != vectorOf(at.C);
  return line(withNumbers(at.C - at.Q == at.B - at.A),
              areCorners
                  ? words("Opposite sides of a rectangle: the same arrow.")
                  : words("The same arrow, though the four points are no corners of a rectangle here."));
}

/// Of triangles only where there are two: they are flat for a ray along n, and the large one is a point where
/// the ray starts in the plane.
std::string similarWords(const Out &at) {
  if (isZero(at.across))
    return words("Along {n}: t times what a step gains. There are no triangles here, because the ray runs "
                 "along {n}.",
                 at.letters);
  return at.meet.t == 0
             ? words(
                   "Along {n}: t is 0, because {Q} is in the plane already, and there is only one triangle.",
                   at.letters)
             : words("Along {n}: t times the side of the small triangle is that of the large one.",
                     at.letters);
}

WorkingLine similarLine(const Out &at) {
  return line(withNumbers(at.C - at.Q == at.t * (at.E - at.Q)), similarWords(at));
}

WorkingLine rayLine(const Out &at) {
  return line(withNumbers(at.H - at.Q == at.t * (at.F - at.Q)),
              words("Along the ray, too: t times the step."));
}

std::string hitWords(const Out &at) {
  return at.meet.which == RayPlaneCase::Hit ? words("The point where the ray meets the plane.")
                                            : words("Only the line backwards meets the plane there.");
}

/// A length of the figure by what was worked out along n.
Chain lengthOf(const Out &at, const Term &side, const Term &product) {
  return withNumbers(norm(side) == norm(product) / norm(at.n));
}

WorkingLine facingLine(const Out &at) {
  const Term unit = at.n / norm(at.n);
  const bool turns = at.meet.denominator > 0;
  return asked(
      withResult(at.facing == (turns ? -unit : unit)),
      turns ? words("v_d is positive: the ray goes to the side that {n} points to, so take −{n}.", at.letters)
            : words("v_d is negative: the ray goes against {n}, so take {n}.", at.letters));
}

LineTable<Out> lines() {
  return {
      {"D", always, [](const Out &at) { return withProducts(at.D == dot(at.P0, at.n)); }, originWords},
      {"B", &Out::hasPlane, [](const Out &at) { return withNumbers(at.B == alongNormal(at, at.D)); },
       says("The point of the plane that is nearest to the origin. When |{n}| = 1, the denominator is "
            "1, and it is D·{n}.")},
      {"vd", always, [](const Out &at) { return withProducts(at.vd == dot(at.n, at.r)); }, stepWords},
      {"F", &Out::hasPlane, [](const Out &at) { return withNumbers(at.F == at.Q + at.r); },
       says("One step from {Q}.")},
      {"E", &Out::hasPlane, [](const Out &at) { return withNumbers(at.E == at.Q + alongNormal(at, at.vd)); },
       says("The foot of F on the line through {Q} along {n}.")},
      {"A", &Out::hasPlane,
       [](const Out &at) { return withNumbers(at.A == alongNormal(at, dot(at.n, at.Q))); },
       says("The foot of {Q} on the line through the origin along {n}.")},
      {"v0", always, startLine},
      {"C", &Out::hasPlane, [](const Out &at) { return withNumbers(at.C == at.Q + alongNormal(at, at.v0)); },
       says("The foot of {Q} in the plane.")},
      {"rectangle", &Out::hasPlane, rectangleLine},
      {"t", &Out::crosses, [](const Out &at) { return withNumbers(at.t == at.v0 / at.vd); },
       says("It takes this many steps {r} to get from {Q} to the plane.")},
      {"similar-n", &Out::crosses, similarLine},
      {"similar-r", &Out::crosses, rayLine},
      {"hit", &Out::crosses, [](const Out &at) { return withNumbers(at.H == at.Q + at.t * at.r); }, hitWords},
      {"OB", &Out::hasPlane, [](const Out &at) { return lengthOf(at, at.B, at.D); },
       says("How far the plane is from the origin.")},
      {"QE", &Out::hasPlane, [](const Out &at) { return lengthOf(at, at.E - at.Q, at.vd); },
       says("How far one step leads along {n}.")},
      {"QC", &Out::hasPlane, [](const Out &at) { return lengthOf(at, at.C - at.Q, at.v0); },
       says("How far {Q} is from the plane.")},
      {"facing", &Out::crosses, facingLine}};
}

/// A way between two points of the figure, if they are not one.
void drawWay(Figure &figure, std::string mark, Role role, Subject subject, const Term &from, const Term &to) {
  if (vectorOf(from) != vectorOf(to))
    figure.add(SegmentMark{{std::move(mark), role, subject}, place(from), place(to)});
}

/// The right angle at a foot between the way to a point and a direction; none where one of them is zero.
void drawAngle(Figure &figure, Subject subject, const Term &foot, const Term &from, const ExactVec3 &square) {
  if (vectorOf(from) != vectorOf(foot) && !isZero(square))
    figure.add(RightAngleMark{{foot->mark + "/angle", Role::Helper, subject},
                              place(foot),
                              place(from) - place(foot),
                              place(square)});
}

/// A point on a line along n, with the way to it from another.
void drawFoot(Figure &figure, const Out &at, const Term &foot, const Term &from, Subject subject) {
  figure.add(pointOf(foot, Role::Derived, subject));
  drawWay(figure, foot->mark + "/way", Role::Helper, subject, from, foot);
  drawAngle(figure, subject, foot, from, vectorOf(at.n));
}

/// The triangle of Q and two points; none where it is flat.
void drawTriangle(Figure &figure, const Out &at, const char *mark, Subject subject, const Term &foot,
                  const Term &tip) {
  const ExactVec3 Q = vectorOf(at.Q);
  if (!isZero(cross(ExactVec3(vectorOf(foot) - Q), ExactVec3(vectorOf(tip) - Q))))
    figure.add(PolygonMark{{at.mark(mark), Role::Derived, subject}, {place(at.Q), place(foot), place(tip)}});
}

/// The figure of the note, in which a way along the normal makes right angles with the plane.
void drawDistances(Figure &figure, const Out &at) {
  figure.add(pointOf(at.O, Role::Derived, Subject::Neutral));
  figure.add(pointOf(at.B, Role::Derived, Subject::Plane));
  drawWay(figure, at.mark("OB"), Role::Helper, Subject::Plane, at.O, at.B);
  drawAngle(figure, Subject::Plane, at.B, at.O, at.across);
  drawFoot(figure, at, at.A, at.Q, Subject::Neutral);
  figure.add(pointOf(at.F, Role::Derived, Subject::Ray));
  drawFoot(figure, at, at.E, at.F, Subject::EdgeU);
  figure.add(pointOf(at.C, Role::Derived, Subject::EdgeV));
  drawWay(figure, at.mark("AB"), Role::Derived, Subject::EdgeV, at.A, at.B);
  drawWay(figure, at.mark("QC"), Role::Helper, Subject::EdgeV, at.Q, at.C);
  drawWay(figure, at.mark("QE"), Role::Derived, Subject::EdgeU, at.Q, at.E);
  drawAngle(figure, Subject::EdgeV, at.C, at.Q, at.across);
  if (!at.crosses)
    return;
  drawTriangle(figure, at, "large", Subject::EdgeV, at.C, at.H);
  drawTriangle(figure, at, "small", Subject::EdgeU, at.E, at.F);
}

/// The facing normal is drawn so long in every picture.
constexpr double drawnNormalLength = 2;

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  drawDistances(figure, at);
  figure.reaches = {{at.in.G.id, place(at.B)}, {at.in.G.id, place(at.C)}};
  addMeeting(figure, at.in.L, at.in.G, at.meet, at.H);
  if (at.crosses)
    figure.add(arrowInPicture(drawn(at.facing, Role::Derived, Subject::Measure), place(at.H),
                              place(at.facing), drawnNormalLength));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, normal] = at.in.G.object;
  if (isZero(normal) || isZero(vectorOf(at.r)))
    return all;
  addRaysAtPlane(at.in.L.object, at.in.G.object,
                 {words("{Q} would lie in the plane, and the ray would hit it at its own start.", at.letters),
                  words("The ray would lie in the plane."),
                  words("The ray would run parallel to the plane.")},
                 all);
  if (!isZero(at.toPlane))
    all.push_back({is("D", "0"), words("The plane would pass through the origin."), "G",
                   PlaneObject{point - at.toPlane, normal}});
  return all;
}

} // namespace

Construction ray_plane_picture() {
  return taught<Out, PlaneObject, RayObject>(
      {.id = "ray-plane-picture",
       .title = [] { return words("ray and plane as a flat picture"); },
       .roles = {"G", "L"},
       .makes = {{"H", &Out::crosses, &Out::H}},
       .letters = {"D", "vd", "v0", "t", "O", "A", "B", "C", "E", "F", "nf"},
       .cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = {{named::number("D"), always, &Out::D},
                  {named::number("numerator"), always, &Out::v0},
                  {named::number("denominator"), always, &Out::vd},
                  {named::number("length_n"), always, [](const Out &at) { return norm(at.n); }},
                  {named::word("origin_way", {"with-n", "against-n", "none"}), &Out::hasPlane,
                   [](const Out &at) { return ToldValue(words("from the origin to the plane"), wayOf(at)); }},
                  {named::word("normal", {"kept", "turned", "none"}), &Out::isProper,
                   [](const Out &at) { return ToldValue(words("the facing normal"), turnOf(at)); }},
                  {named::number("t"), &Out::crosses, &Out::t},
                  {named::vector("point"), &Out::crosses, &Out::H},
                  {named::vector("facing_normal"), &Out::crosses, &Out::facing}},
       .lines = lines(),
       .marks = {"O", "A", "B", "C", "E", "F", "H", "OB", "AB", "QC", "QE", "large", "small", "facing"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
