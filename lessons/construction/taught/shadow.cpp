// The shadows that the sun and a lamp throw of a triangle onto a plane, and where those of the midpoint of
// one of its edges fall.
#include "geometry/project_vector.h"
#include "lessons/construction/parts/lit_points.h"
#include "lessons/construction/parts/triangle_shadow.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <algorithm>
#include <array>
#include <optional>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PointObject> Q;
  Given<PointObject> A;
  Given<PointObject> B;
  Given<PointObject> C;
  Given<VectorObject> r;
};

struct Out : Computed<In>, PlaneTerms {
  explicit Out(const In &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  const ExactVec3 &normal = in.E.object.normal;
  const ExactVec3 &direction = in.r.object.vector;
  ExactVec3 midpoint = (in.A.object.at + in.B.object.at) / Rational(2);
  bool hasPlane = !isZero(normal);
  bool hasSun = hasPlane && !isZero(direction);
  bool isSunCrossing = dot(direction, normal) != 0;

  Term Q = termOf(in.Q);
  Term r = termOf(in.r);
  Term along = dot(r, n);
  Term M = drawnName(letter("M"), midpoint);
  Lights lights{in.E, in.r, in.Q};
  /// The corners, and the midpoint of the edge from A to B.
  std::array<LitPoint, 4> points{litPoint(in, lights, "A", termOf(in.A)),
                                 litPoint(in, lights, "B", termOf(in.B)),
                                 litPoint(in, lights, "C", termOf(in.C)), litPoint(in, lights, "M", M)};
  const LitPoint &A = points[0];
  const LitPoint &B = points[1];
  const LitPoint &C = points[2];
  const LitPoint &ofM = points[3];
  TriangleShadow bySun = triangleShadow({A.bySun, B.bySun, C.bySun});
  TriangleShadow byLamp = triangleShadow({A.byLamp, B.byLamp, C.byLamp});

  /// Whether the places L(A), L(B) and L(M) tell a part: from a lamp in the plane they are all the same.
  bool hasPart = A.byLamp.crosses() && B.byLamp.crosses() && ofM.byLamp.crosses() && A.byLamp.t != 0;
  bool isOneShadow = hasPart && A.byLamp.place == B.byLamp.place;
  Rational share = hasPart ? Rational(A.byLamp.t / (A.byLamp.t + B.byLamp.t)) : Rational(0);
  bool isMiddle = share == Rational(1, 2);
  bool isNearerToA = abs(share) < abs(Rational(1 - share)); ///< L(M) to L(A) than to L(B)
  Term p = ownName(letter("p"), share);

  /// 0 where the sun shines along the triangle, so that it sees it exactly from the side.
  [[nodiscard]] Rational facing() const {
    const ExactVec3 &corner = in.A.object.at;
    return dot(direction, cross(ExactVec3(in.B.object.at - corner), ExactVec3(in.C.object.at - corner)));
  }
  /// How far the ray of the lamp to a corner goes along n: 0 where it runs parallel to the plane.
  [[nodiscard]] Rational aheadOfLamp(const PointObject &corner) const {
    return dot(ExactVec3(corner.at - in.Q.object.at), normal);
  }
};

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return zeroNormalWords(at);
  if (!at.hasSun)
    return {"no-sunlight", words("{r} is the zero vector: the sunlight has no direction.", at.letters), true};
  if (at.bySun.falls)
    return at.byLamp.falls
               ? CaseWords{"both", words("The sun and the lamp throw shadows of {A}, {B} and {C} onto the "
                                         "plane.",
                                         at.letters)}
               : CaseWords{"sun", words("The sun throws shadows of {A}, {B} and {C} onto the plane. The lamp "
                                        "does not throw all three.",
                                        at.letters)};
  return at.byLamp.falls
             ? CaseWords{"lamp", words("The lamp throws shadows of {A}, {B} and {C} onto the plane. The sun "
                                       "does not throw all three.",
                                       at.letters)}
             : CaseWords{"neither", words("Neither the sun nor the lamp throws shadows of all three corners "
                                          "onto the plane.")};
}

WordValues wordsOf(const Out &at, const LitPoint &lit) {
  WordValues all = at.letters;
  all.emplace_back("point", plainText(lit.point));
  return all;
}

std::string alongWords(const Out &at) {
  const int sign = dot(at.direction, at.normal).sign();
  return sign < 0   ? words("Negative: the sunlight goes against {n}.", at.letters)
         : sign > 0 ? words("Positive: the sunlight goes to the side that {n} points to.", at.letters)
                    : words("Zero: the sunlight runs along the plane and comes no nearer to it.");
}

std::string sunStepsWords(const Out &at, const LitPoint &lit) {
  const int sign = lit.bySun.t.sign();
  const WordValues names = wordsOf(at, lit);
  return sign > 0 ? words("It takes this many steps {r} to get from {point} to the plane.", names)
         : sign < 0
             ? words("Negative: on its way the light gets to the plane before it comes to {point}.", names)
             : words("0: {point} lies in the plane.", names);
}

WorkingLine sunStepsLine(const Out &at, std::size_t index) {
  const LitPoint &lit = at.points.at(index);
  return asked(
      withNumbers(lit.t == dot(at.P0 - lit.point, at.n) / at.along), sunStepsWords(at, lit),
      {{dot(lit.point - at.P0, at.n) / at.along,
        words("{answer} has the wrong sign: the way leads from {point} to {P0}.", wordsOf(at, lit))}});
}

WorkingLine sunLine(const Out &at, std::size_t index) {
  const LitPoint &lit = at.points.at(index);
  return asked(withNumbers(lit.S == lit.point + lit.t * at.r),
               lit.bySun.falls() ? words("Here the sun throws the shadow of {point}.", wordsOf(at, lit))
                                 : words("Here the light gets to the plane before it comes to {point}: "
                                         "this is no shadow.",
                                         wordsOf(at, lit)));
}

std::string lampStepsWords(const Out &at, const LitPoint &lit) {
  const Rational &k = lit.byLamp.t;
  const WordValues names = wordsOf(at, lit);
  if (k < 0)
    return words("Negative: the ray from {Q} to {point} leads away from the plane.", names);
  if (k == 0)
    return words("0: {Q} lies in the plane.", names);
  return k < 1    ? words("Smaller than 1: the ray gets to the plane before it comes to {point}.", names)
         : k == 1 ? words("1: {point} lies in the plane.", names)
                  : words("It takes this many steps, each as long as the way from {Q} to {point}.", names);
}

WorkingLine lampStepsLine(const Out &at, std::size_t index) {
  const LitPoint &lit = at.points.at(index);
  return asked(withNumbers(lit.k == dot(at.P0 - at.Q, at.n) / dot(lit.point - at.Q, at.n)),
               lampStepsWords(at, lit),
               {{dot(at.P0 - lit.point, at.n) / dot(lit.point - at.Q, at.n),
                 words("{answer} counts from {point}: the ray starts at {Q}.", wordsOf(at, lit))}});
}

std::string lampWords(const Out &at, const LitPoint &lit) {
  switch (lit.byLamp.which) {
  case ShadowCase::Falls:
    return words("Here the lamp throws the shadow of {point}.", wordsOf(at, lit));
  case ShadowCase::Away:
    return words("Only the line backwards from {Q} gets to the plane here: this is no shadow.", at.letters);
  default:
    return words("Here the ray gets to the plane before it comes to {point}: this is no shadow.",
                 wordsOf(at, lit));
  }
}

WorkingLine lampLine(const Out &at, std::size_t index) {
  const LitPoint &lit = at.points.at(index);
  return asked(withNumbers(lit.L == at.Q + lit.k * (lit.point - at.Q)), lampWords(at, lit),
               {{lit.point + lit.k * (lit.point - at.Q),
                 words("{answer} starts at {point}: the ray starts at {Q}.", wordsOf(at, lit))}});
}

WorkingLine partLine(const Out &at) {
  const Term &a = at.A.k;
  const Term &b = at.B.k;
  return asked(
      withNumbers(at.p == a / (a + b)),
      at.isMiddle
          ? words("One half: measured along {n}, {A} and {B} are equally far from {Q}.", at.letters)
          : words("This part of the way from {from} to {to} leads to {middle}.",
                  {{"from", plainText(at.A.L)}, {"to", plainText(at.B.L)}, {"middle", plainText(at.ofM.L)}}),
      {{b / (a + b), words("{answer} is the part from the other end: {A} comes first.", at.letters)}});
}

std::string lampMiddleWords(const Out &at) {
  const WordValues names{{"from", plainText(at.A.L)}, {"to", plainText(at.B.L)}};
  if (at.isOneShadow)
    return words("It is the same point as {from} and {to}.", names);
  if (at.isMiddle)
    return words("The middle between {from} and {to}.", names);
  return at.isNearerToA ? words("Nearer to {from} than to {to}, so not the middle.", names)
                        : words("Nearer to {to} than to {from}, so not the middle.", names);
}

constexpr std::array roles{"A", "B", "C", "M"};

LineTable<Out> lines() {
  LineTable<Out> table{
      {"along", &Out::hasSun, [](const Out &at) { return withProducts(at.along); }, alongWords},
      {"M", always, [](const Out &at) { return withNumbers(at.M == (at.A.point + at.B.point) / 2); },
       says("The midpoint of the edge from {A} to {B}.")}};
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const std::string role = roles.at(i);
    const auto sun = [i](const Out &at) { return at.points.at(i).bySun.crosses(); };
    const auto lamp = [i](const Out &at) { return at.points.at(i).byLamp.crosses(); };
    table.push_back({"t-" + role, sun, [i](const Out &at) { return sunStepsLine(at, i); }});
    table.push_back({"sun-" + role, sun, [i](const Out &at) { return sunLine(at, i); }});
    table.push_back({"k-" + role, lamp, [i](const Out &at) { return lampStepsLine(at, i); }});
    table.push_back({"lamp-" + role, lamp, [i](const Out &at) { return lampLine(at, i); }});
  }
  return joined<LineRow<Out>>(
      {table,
       {{"mean", &Out::isSunCrossing,
         [](const Out &at) { return withNumbers(at.ofM.t == (at.A.t + at.B.t) / 2); },
         says("The mean of both: half-way along the edge, half of the change.")},
        {"sun-middle", &Out::isSunCrossing,
         [](const Out &at) { return withNumbers(at.ofM.S == (at.A.S + at.B.S) / 2); },
         [](const Out &at) {
           return words("The midpoint of {from} and {to}.",
                        {{"from", plainText(at.A.S)}, {"to", plainText(at.B.S)}});
         }},
        {"part", &Out::hasPart, partLine},
        {"lamp-middle", &Out::hasPart,
         [](const Out &at) { return withNumbers(at.ofM.L == at.A.L + at.p * (at.B.L - at.A.L)); },
         lampMiddleWords}}});
}

/// Both halves of the shadow of the edge, from A to M and on to B, each in the colour of its end.
void drawHalves(Figure &figure, const Out &at, const std::string &mark, const std::array<Term, 3> &edge) {
  const std::array looks{Look{at.in.A.look.hue}, Look{at.in.B.look.hue}};
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Place from = place(edge.at(i));
    const Place to = place(edge.at(i + 1));
    if (from != to)
      figure.add(inLook(looks.at(i), SegmentMark{{partOf(mark, i), Role::Result, Subject::Point}, from, to}));
  }
}

Figure draw(const Out &at) {
  Figure figure;
  drawTriangle(figure, {at.mark("triangle"), Role::Given, Subject::Triangle},
               {at.in.A.object.at, at.in.B.object.at, at.in.C.object.at});
  figure.add(pointOf(at.M, Role::Derived, Subject::Triangle));
  for (const LitPoint &lit : at.points) {
    drawSunlight(figure, at.lights, lit);
    drawLamplight(figure, at.lights, lit);
  }
  if (at.bySun.falls)
    drawTriangle(figure, {at.mark("sun"), Role::Derived, Subject::Neutral}, at.bySun.corners);
  if (at.byLamp.falls)
    drawTriangle(figure, {at.mark("lamp"), Role::Derived, Subject::Neutral}, at.byLamp.corners);
  if (at.A.bySun.falls() && at.B.bySun.falls())
    drawHalves(figure, at, at.mark("sun-halves"), {at.A.S, at.ofM.S, at.B.S});
  if (at.A.byLamp.falls() && at.B.byLamp.falls())
    drawHalves(figure, at, at.mark("lamp-halves"), {at.A.L, at.ofM.L, at.B.L});
  return figure;
}

/// The direction turned to be square to a normal, if anything is left of it then, and was not before.
std::optional<ExactVec3> turnedOff(const ExactVec3 &direction, const ExactVec3 &normal) {
  if (isZero(normal) || dot(direction, normal) == 0)
    return {};
  const ExactVec3 left = projectVector(direction, normal).rejection;
  return isZero(left) ? std::nullopt : std::optional(left);
}

/// A point moved along the normal until it is as far along it as another is.
ExactVec3 levelWith(const ExactVec3 &point, const ExactVec3 &other, const ExactVec3 &normal) {
  return point + projectVector(ExactVec3(other - point), normal).projection;
}

/// A corner in the plane, or level with the lamp, by a change of either.
void addCorner(const Out &at, const LitPoint &lit, std::vector<SpecialCase> &all) {
  const ExactVec3 corner = vectorOf(lit.point);
  const ExactVec3 &lamp = at.in.Q.object.at;
  if (lit.bySun.crosses() && lit.bySun.t != 0)
    all.push_back({is("t_" + lit.role, "0"), words("{point} would lie in the plane.", wordsOf(at, lit)),
                   lit.role, PointObject{levelWith(corner, at.in.E.object.point, at.normal)}});
  if (!lit.byLamp.crosses())
    return;
  const auto addLevel = [&](const std::string &role, const ExactVec3 &moved, const ExactVec3 &other) {
    const bool isAtLamp = moved == other;
    all.push_back({is("lamp_" + lit.role, isAtLamp ? "at-lamp" : "parallel"),
                   isAtLamp
                       ? words("{point} would be at the lamp itself.", wordsOf(at, lit))
                       : words("The ray through {point} would run parallel to the plane.", wordsOf(at, lit)),
                   role, PointObject{moved}});
  };
  addLevel(lit.role, levelWith(corner, lamp, at.normal), lamp);
  addLevel("Q", levelWith(lamp, corner, at.normal), corner);
}

/// Whether light throws shadows of all three corners: castBySun of a direction, or castByLamp of a lamp.
template <class Cast> bool throwsAll(const Out &at, const Cast &cast, const ExactVec3 &light) {
  const Plane<Rational> plane = planeThrough(at.in.E.object.point, at.normal);
  const std::array corners{at.in.A.object.at, at.in.B.object.at, at.in.C.object.at};
  return std::all_of(corners.begin(), corners.end(),
                     [&](const ExactVec3 &corner) { return cast(corner, light, plane).falls(); });
}

/// Light along the triangle, whose shadow is flat then.
void addFlatShadows(const Out &at, std::vector<SpecialCase> &all) {
  const ExactVec3 &start = at.in.A.object.at;
  const ExactVec3 area = areaOf({start, at.in.B.object.at, at.in.C.object.at});
  if (const auto turned = turnedOff(at.direction, area);
      turned && throwsAll(at, castBySun<Rational>, *turned))
    all.push_back({is("sun_shadow", "flat"), words("The sunlight would run along the triangle."), "r",
                   VectorObject{at.in.r.object.start, *turned}});
  if (isZero(area) || dot(ExactVec3(at.in.Q.object.at - start), area) == 0)
    return;
  const ExactVec3 lamp = levelWith(at.in.Q.object.at, start, area);
  if (throwsAll(at, castByLamp<Rational>, lamp))
    all.push_back({is("lamp_shadow", "flat"),
                   words("{Q} would lie in the plane of the triangle.", at.letters), "Q", PointObject{lamp}});
}

/// One end of the edge as far from the plane as the other.
void addMiddle(const Out &at, const LitPoint &moved, const LitPoint &other, std::vector<SpecialCase> &all) {
  if (at.hasPart && at.isMiddle)
    return;
  if (other.byLamp.crosses() && other.byLamp.t != 0)
    all.push_back({is("part", "1/2"), words("The lamp would keep the midpoint of the edge."), moved.role,
                   PointObject{levelWith(vectorOf(moved.point), vectorOf(other.point), at.normal)}});
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasSun)
    return all;
  if (const auto turned = turnedOff(at.direction, at.normal))
    all.push_back({is("sun_A", "parallel"), words("The sunlight would run along the plane."), "r",
                   VectorObject{at.in.r.object.start, *turned}});
  for (const LitPoint *corner : {&at.A, &at.B, &at.C})
    addCorner(at, *corner, all);
  addFlatShadows(at, all);
  addMiddle(at, at.A, at.B, all);
  addMiddle(at, at.B, at.A, all);
  return all;
}

/// Which of L(A) and L(B) is nearer to L(M).
Word nearerWord(const Out &at) {
  if (!at.hasPart || at.isOneShadow)
    return noneOfThem();
  if (at.isMiddle)
    return {"middle", words("neither")};
  return at.isNearerToA ? Word{"A", plainText(at.A.L)} : Word{"B", plainText(at.B.L)};
}

ValueTable<Out> pointRows(std::size_t i) {
  const std::string role = roles.at(i);
  const auto sun = [i](const Out &at) { return at.points.at(i).bySun.crosses(); };
  const auto lamp = [i](const Out &at) { return at.points.at(i).byLamp.crosses(); };
  return {{named::number("t_" + role), sun, [i](const Out &at) { return at.points.at(i).t; }},
          {named::vector("S_" + role), sun, [i](const Out &at) { return at.points.at(i).S; }},
          {named::number("k_" + role), lamp, [i](const Out &at) { return at.points.at(i).k; }},
          {named::vector("L_" + role), lamp, [i](const Out &at) { return at.points.at(i).L; }}};
}

/// How the shadow of a corner is in both lights.
ValueTable<Out> cornerRows(std::size_t i) {
  const std::string role = roles.at(i);
  return {
      {named::word("sun_" + role, {"falls", "plane-first", "parallel"}), &Out::hasSun,
       [i](const Out &at) {
         const LitPoint &lit = at.points.at(i);
         return ToldValue(words("shadow of {point} by the sun", wordsOf(at, lit)), wordOf(lit.bySun.which));
       }},
      {named::word("lamp_" + role, {"falls", "plane-first", "away", "parallel", "at-lamp"}), &Out::hasPlane,
       [i](const Out &at) {
         const LitPoint &lit = at.points.at(i);
         return ToldValue(words("shadow of {point} by the lamp", wordsOf(at, lit)), wordOf(lit.byLamp.which));
       }}};
}

ValueTable<Out> values() {
  const std::vector<std::string> shapes{"triangle", "flat", "none"};
  return joined<ValueRow<Out>>(
      {{{named::number("denominator"), &Out::hasSun, &Out::along}, {named::vector("M"), always, &Out::M}},
       pointRows(0),
       pointRows(1),
       pointRows(2),
       pointRows(3),
       cornerRows(0),
       cornerRows(1),
       cornerRows(2),
       {{named::number("facing"), always, [](const Out &at) { return Value(Surd(at.facing())); }},
        {named::number("ahead_A"), always,
         [](const Out &at) { return Value(Surd(at.aheadOfLamp(at.in.A.object))); }},
        {named::number("ratio"), [](const Out &at) { return at.aheadOfLamp(at.in.A.object) != 0; },
         [](const Out &at) {
           return Value(Surd(Rational(at.aheadOfLamp(at.in.B.object) / at.aheadOfLamp(at.in.A.object))));
         }},
        {named::word("sun_shadow", shapes), always,
         [](const Out &at) {
           return ToldValue(words("shadow of the triangle by the sun"), wordOf(at.bySun));
         }},
        {named::word("lamp_shadow", shapes), always,
         [](const Out &at) {
           return ToldValue(words("shadow of the triangle by the lamp"), wordOf(at.byLamp));
         }},
        {named::number("part"), &Out::hasPart, &Out::p},
        {named::word("nearer", {"A", "B", "middle", "none"}), always, [](const Out &at) {
           return ToldValue(words("nearer to {middle}", {{"middle", plainText(at.ofM.L)}}), nearerWord(at));
         }}}});
}

} // namespace

Construction shadow() {
  return taught<Out, PlaneObject, PointObject, PointObject, PointObject, PointObject, VectorObject>(
      {.id = "shadow",
       .title = [] { return words("shadow on the plane"); },
       .roles = {"E", "Q", "A", "B", "C", "r"},
       .letters = {"tA", "tB", "tC", "tM", "kA", "kB", "kC", "kM", "S", "L", "M", "p"},
       .cases = {"both", "sun", "lamp", "neither", "no-sunlight", "zero-normal"},
       .values = values(),
       .lines = lines(),
       .marks = {"triangle", "M", "sun-A", "sun-B", "sun-C", "sun-M", "lamp-A", "lamp-B", "lamp-C", "lamp-M",
                 "sun", "lamp", "sun-halves", "lamp-halves"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
