// Whether three corners make a triangle, by every test of note PG 6.2, and what each of them sees.
#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/two_vectors.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/term/angle.h"

#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
};

std::string sameCorners(const TriangleObject &triangle) {
  const auto &[p0, p1, p2] = triangle;
  if (p0 == p1)
    return p1 == p2 ? "all" : "P0-P1";
  return p0 == p2 ? "P0-P2" : p1 == p2 ? "P1-P2" : "none";
}

struct Out : Computed<In>, TriangleTerms {
  explicit Out(const In &objects) : Computed(objects), TriangleTerms(termsOf(objects.T)) {}

  Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
  bool isTriangle = shapeOf(triangle) == TriangleShape::Proper;
  TrianglePerps<Rational> perps = perpsOf(triangle);
  std::string same = sameCorners(in.T.object); ///< which corners are one point: P0-P1; all, none
  bool hasAngle = perps.uu != 0 && perps.vv != 0;
  /// Whether u and v lead opposite ways along one line.
  bool areOpposite = !isTriangle && perps.uv < 0;

  Term u = drawnName(vectorLetter("u"), perps.u);
  Term v = drawnName(vectorLetter("v"), perps.v);
  Term n = drawnName(vectorLetter("n"), perps.normal);
  Term G = ownName(letter("G"), perps.denominator);
  Term theta = ownName(letter("θ"), std::nullopt).marked(mark("theta"));
  Term cosine = applied(word("cos"), theta, cosineOf(perps));
};

/// Sentences for what is wrong with the corners.
struct FaultSentences {
  Sentence onOneLine;
  CoincidentSentences coincident;
};

std::string faultWords(const Out &at, const FaultSentences &sentences) {
  return at.same == "none" ? words(sentences.onOneLine.english, at.letters)
                           : coincidentWords(at.in.T.object, at, sentences.coincident);
}

CaseWords tell(const Out &at) {
  if (at.isTriangle)
    return {"proper",
            words("{P0}, {P1} and {P2} are the corners of a triangle: u and v point along different "
                  "lines.",
                  at.letters)};
  return {at.same == "none" ? "collinear" : "coincident",
          faultWords(at, {at.areOpposite ? says("{P0}, {P1} and {P2} lie on one line, and u and v point in "
                                                "opposite directions: this is no triangle.")
                                         : says("{P0}, {P1} and {P2} lie on one line, and u and v point in "
                                                "the same direction: this is no triangle."),
                          {says("{first} and {second} are the same point: this is no triangle."),
                           says("{first}, {second} and {third} are the same point: this is no triangle.")}}),
          true};
}

/// Which corners are one point.
Word sameWord(const Out &at) {
  const auto both = [&](const Term &first, const Term &second) {
    return Word{at.same,
                words("{first} and {second}", {{"first", plainText(first)}, {"second", plainText(second)}})};
  };
  if (at.same == "none")
    return noneOfThem();
  if (at.same == "all")
    return {at.same, words("all three")};
  return at.same == "P0-P1"   ? both(at.P0, at.P1)
         : at.same == "P0-P2" ? both(at.P0, at.P2)
                              : both(at.P1, at.P2);
}

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.u, at.v)), crossProductWords(at.n),
               {{cross(at.v, at.u), words("{answer} is the cross product the other way round: v × u.")}});
}

WorkingLine lengthsLine(const Out &at) {
  return asked(withNumbers(norm(at.u) * norm(at.v)),
               at.hasAngle ? words("The two lengths: for the cosine the dot product is divided by them.")
                           : words("0: nothing can be divided by it, so there is no cosine."),
               {{norm(at.u) + norm(at.v), words("{answer} is the sum of the two lengths: multiply them.")}});
}

std::string cosineWords(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return words("θ{degrees}°: the angle between u and v.", {{"degrees", degrees}});
}

WorkingLine squaresLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(withNumbers(at.G == power(dot(u, v), 2) - dot(u, u) * dot(v, v)),
               at.isTriangle ? words("Not 0: a triangle. G is the denominator of s and t.")
                             : words("0: no triangle. G would be the denominator of s and t."),
               {{-at.G, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}});
}

WorkingLine lagrangeLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(withNumbers((dot(at.n, at.n) == dot(u, u) * dot(v, v) - power(dot(u, v), 2))),
               words("Lagrange's identity. It is −G: so G is 0 exactly where u × v is the zero vector."),
               {{at.G, words("{answer} is G itself: here the two parts have changed places.")}});
}

/// A test's line: its comparison, and what it sees, as `found` says that.
WorkingLine testLine(const Out &at, const Chain &comparison, bool sees) {
  constexpr FaultSentences seen{
      says("It sees that something is wrong: {P0}, {P1} and {P2} lie on one line."),
      {says("It sees that something is wrong: {first} and {second} are the same point."),
       says("It sees that something is wrong: {first}, {second} and {third} are the same point.")}};
  constexpr FaultSentences unseen{
      says("It is blind: {P0}, {P1} and {P2} lie on one line, and this test misses it."),
      {says("It is blind: {first} and {second} are the same point, and this test misses it."),
       Sentence{""}}}; // of three all see it
  return line(comparison, at.isTriangle ? words("It finds nothing wrong, and nothing is.")
                                        : faultWords(at, sees ? seen : unseen));
}

WorkingLine cosineTestLine(const Out &at) {
  if (at.hasAngle)
    return testLine(at, compared(at.cosine, 1), cosineOf(at.perps) == Surd(1));
  return line(
      compared(norm(at.u) * norm(at.v), 0),
      faultWords(
          at,
          {says("There is no cosine, so this test cannot be made: {P0}, {P1} and {P2} lie on one line."),
           {says("There is no cosine, so this test cannot be made: {first} and {second} are the same point."),
            says("There is no cosine, so this test cannot be made: {first}, {second} and {third} are the "
                 "same point.")}}));
}

WorkingLine squaresTestLine(const Out &at) {
  return testLine(at, compared(power(dot(at.u, at.v), 2), dot(at.u, at.u) * dot(at.v, at.v)),
                  at.perps.denominator == 0);
}

LineTable<Out> lines() {
  return {
      {"u", always, [](const Out &at) { return asked(withNumbers(at.u == at.P1 - at.P0)); }},
      {"v", always, [](const Out &at) { return withNumbers(at.v == at.P2 - at.P0); },
       says("Two sides, both from {P0}.")},
      {"uu", always, [](const Out &at) { return asked(withProducts(dot(at.u, at.u))); }},
      {"uv", always, [](const Out &at) { return asked(withProducts(dot(at.u, at.v))); }},
      {"vv", always, [](const Out &at) { return asked(withProducts(dot(at.v, at.v))); }},
      {"normal", always, normalLine},
      {"lengths", always, lengthsLine},
      {"cosine", &Out::hasAngle,
       [](const Out &at) { return withNumbers(at.cosine == dot(at.u, at.v) / (norm(at.u) * norm(at.v))); },
       cosineWords},
      {"squares", always, squaresLine},
      {"lagrange", always, lagrangeLine},
      {"test-u", always,
       [](const Out &at) { return testLine(at, compared(dot(at.u, at.u), 0), at.perps.uu == 0); }},
      {"test-v", always,
       [](const Out &at) { return testLine(at, compared(dot(at.v, at.v), 0), at.perps.vv == 0); }},
      {"test-cosine", always, cosineTestLine},
      {"test-squares", always, squaresTestLine}};
}

ValueRow<Out> testRow(const char *name, Sentence label, bool (*finds)(const TrianglePerps<Rational> &)) {
  return {named::word(name, {"yes", "no"}), always,
          [=](const Out &at) { return ToldValue(words(label.english), yesOrNo(finds(at.perps))); }};
}

ToldValue cosineTestValue(const Out &at) {
  return {words("cosine = 1"),
          at.hasAngle ? yesOrNo(cosineOf(at.perps) == Surd(1)) : Word{"undefined", words("undefined")}};
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;

/// The words speak of the normal's length, which would have no room: so its label says that it is not shown.
void drawNormal(Figure &figure, const Out &at, const Place &p0) {
  MarkBase normal = drawn(at.n, Role::Derived, Subject::Plane);
  normal.numbers = "\\ {\\scriptstyle\\text{" + words("direction only") + "}}";
  figure.add(arrowOfLength(std::move(normal), p0, at.perps.normal, drawnNormalLength));
}

Figure draw(const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  if (at.perps.uu != 0)
    figure.add(arrowOf(at.u, p0, Role::Given, Subject::EdgeU));
  if (at.perps.vv != 0) {
    ArrowMark v = arrowOf(at.v, p0, Role::Given, Subject::EdgeV);
    const bool isAlongU = !at.isTriangle && at.perps.uv > 0;
    v.look.rank = isAlongU ? 1 : 0; // dashed, so that u is seen in it
    figure.add(std::move(v));
  }
  if (at.hasAngle)
    figure.add(ArcMark{drawn(at.theta, Role::Derived, Subject::Neutral), p0, place(at.u), place(at.v)});
  if (at.isTriangle) {
    drawNormal(figure, at, p0);
    figure.add(parallelogramOf(at.n->mark + "/area", norm(at.n), p0, place(at.u), place(at.v)));
  }
  return figure;
}

/// A corner on another, and on the line of the two others.
std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (at.same != "none")
    return all;
  const auto &[p0, p1, p2] = at.in.T.object;
  const auto addSame = [&](const char *same, const Term &first, const Term &second,
                           const TriangleObject &triangle) {
    all.push_back({is("same_corners", same),
                   words("{first} and {second} would be the same point.",
                         {{"first", plainText(first)}, {"second", plainText(second)}}),
                   "T", triangle});
  };
  addSame("P0-P1", at.P0, at.P1, {p0, p0, p2});
  addSame("P0-P2", at.P0, at.P2, {p0, p1, p0});
  addSame("P1-P2", at.P1, at.P2, {p0, p1, p1});
  if (at.isTriangle)
    addFlattened(at.in.T.object, at, all);
  return all;
}

} // namespace

Construction triangle_degenerate() {
  return taught<Out, TriangleObject>(
      {.id = "triangle-degenerate",
       .title = [] { return words("is it a triangle?"); },
       .roles = {"T"},
       .letters = {"u", "v", "n", "G", "θ"},
       .cases = {"proper", "coincident", "collinear"},
       .values = {{named::number("uu"), always, [](const Out &at) { return dot(at.u, at.u); }},
                  {named::number("uv"), always, [](const Out &at) { return dot(at.u, at.v); }},
                  {named::number("vv"), always, [](const Out &at) { return dot(at.v, at.v); }},
                  {named::vector("normal"), always, &Out::n},
                  {named::number("denominator"), always, &Out::G},
                  {named::word("same_corners", {"none", "P0-P1", "P0-P2", "P1-P2", "all"}), always,
                   [](const Out &at) {
                     return ToldValue(words("corners that are one point"), sameWord(at));
                   }},
                  testRow("test_u", says("u·u = 0"), [](const auto &perps) { return perps.uu == 0; }),
                  testRow("test_v", says("v·v = 0"), [](const auto &perps) { return perps.vv == 0; }),
                  {named::word("test_cosine", {"yes", "no", "undefined"}), always, cosineTestValue},
                  testRow("test_squares", says("(u·v)² = (u·u)(v·v)"),
                          [](const auto &perps) { return perps.denominator == 0; }),
                  {named::number("cos_angle"), &Out::hasAngle, &Out::cosine}},
       .lines = lines(),
       .marks = {"u", "v", "theta", "n"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
