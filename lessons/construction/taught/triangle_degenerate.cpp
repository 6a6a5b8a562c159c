// Whether three corners make a triangle, by every test of note PG 6.2, and what each of them sees.
#include "geometry/intersect_ray_triangle.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/angle.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
};

struct Out : Naming, TriangleTerms {
  TriangleShape shape;
  TrianglePerps<Rational> perps;
  std::string same; ///< which corners are one point: P0-P1; all, none
  Term u, v, n, D;
  Term theta, cosine; ///< of the angle between u and v

  [[nodiscard]] bool isTriangle() const { return shape == TriangleShape::Proper; }
  [[nodiscard]] bool hasAngle() const { return perps.uu != 0 && perps.vv != 0; }
  /// Whether u and v lead opposite ways along one line.
  [[nodiscard]] bool areOpposite() const { return !isTriangle() && perps.uv < 0; }
};

std::string sameCorners(const TriangleObject &triangle) {
  const auto &[p0, p1, p2] = triangle;
  if (p0 == p1)
    return p1 == p2 ? "all" : "P0-P1";
  return p0 == p2 ? "P0-P2" : p1 == p2 ? "P1-P2" : "none";
}

/// 0 where there is no angle.
Surd cosineOf(const TrianglePerps<Rational> &perps) {
  const Rational squares = perps.uu * perps.vv;
  return squares == 0 ? Surd() : overRoot(perps.uv, squares);
}

Out compute(const In &in) {
  const Triangle<Rational> triangle{in.T.object.p0, in.T.object.p1, in.T.object.p2};
  const auto perps = perpsOf(triangle);
  const Term theta = name(in.own(letter("θ")), std::nullopt).marked(in.mark("theta"));
  return {in,
          termsOf(in.T),
          shapeOf(triangle),
          perps,
          sameCorners(in.T.object),
          name(in.own(vectorLetter("u")), perps.u).marked(in.mark("u")),
          name(in.own(vectorLetter("v")), perps.v).marked(in.mark("v")),
          name(in.own(vectorLetter("n")), perps.normal).marked(in.mark("n")),
          name(in.own(letter("D")), perps.denominator),
          theta,
          applied(word("cos"), theta, cosineOf(perps))};
}

/// What is wrong with the corners, as the end of a sentence.
std::string faultWords(const In &in, const Out &at) {
  return at.same == "none" ? words("{P0}, {P1} and {P2} lie on one line", at.letters)
                           : coincidentWords(in.T.object, at);
}

CaseWords tell(const In &in, const Out &at) {
  if (at.isTriangle())
    return {"proper",
            words("{P0}, {P1} and {P2} are the corners of a triangle: u and v point along different "
                  "lines.",
                  at.letters)};
  const std::string fault = faultWords(in, at);
  return {at.same == "none" ? "collinear" : "coincident",
          at.same != "none" ? words("{fault}: this is no triangle.", {{"fault", fault}})
          : at.areOpposite()
              ? words("{fault}, and u and v point in opposite directions: this is no triangle.",
                      {{"fault", fault}})
              : words("{fault}, and u and v point in the same direction: this is no triangle.",
                      {{"fault", fault}}),
          true};
}

const char *yesOrNo(bool holds) { return holds ? "yes" : "no"; }

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  const auto &perps = at.perps;
  std::vector<NamedValue> values{
      listed("uu", dot(at.u, at.u)),
      listed("uv", dot(at.u, at.v)),
      listed("vv", dot(at.v, at.v)),
      listed("normal", at.n),
      listed("denominator", at.D),
      {"same_corners", words("corners that are one point"), at.same},
      {"test_u", words("u·u = 0"), yesOrNo(perps.uu == 0)},
      {"test_v", words("v·v = 0"), yesOrNo(perps.vv == 0)},
      {"test_cosine", words("cosine = 1"), at.hasAngle() ? yesOrNo(cosineOf(perps) == Surd(1)) : "undefined"},
      {"test_squares", words("(u·v)² = (u·u)(v·v)"), yesOrNo(perps.denominator == 0)}};
  if (at.hasAngle())
    values.push_back(listed("cos_angle", at.cosine));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &) { return {}; }

WorkingLine normalLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.u, at.v)), crossProductWords(at.n),
               {{cross(at.v, at.u), words("{answer} is the cross product the other way round: v × u.")}});
}

WorkingLine lengthsLine(const Out &at) {
  return asked(withNumbers(norm(at.u) * norm(at.v)),
               at.hasAngle() ? words("The two lengths: for the cosine the dot product is divided by them.")
                             : words("0: nothing can be divided by it, so there is no cosine."),
               {{norm(at.u) + norm(at.v), words("{answer} is the sum of the two lengths: multiply them.")}});
}

WorkingLine cosineLine(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return asked(withNumbers(at.cosine == dot(at.u, at.v) / (norm(at.u) * norm(at.v))),
               words("θ{degrees}°: the angle between u and v.", {{"degrees", degrees}}));
}

WorkingLine squaresLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(withNumbers(at.D == power(dot(u, v), 2) - dot(u, u) * dot(v, v)),
               at.isTriangle() ? words("Not 0: a triangle. D is the number that s and t are divided by.")
                               : words("0: no triangle. D is the number that s and t would be divided by."),
               {{-at.D, words("{answer} has the wrong sign: (u·v)² is never the larger part.")}});
}

WorkingLine lagrangeLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(withNumbers((dot(at.n, at.n) == dot(u, u) * dot(v, v) - power(dot(u, v), 2))),
               words("Lagrange's identity. It is −D: so D is 0 exactly where u × v is the zero vector."),
               {{at.D, words("{answer} is D itself: here the two parts have changed places.")}});
}

/// A test's line: its comparison, and what it sees, as `found` says that.
WorkingLine testLine(const In &in, const Out &at, const Chain &comparison, bool sees) {
  const std::string fault = at.isTriangle() ? "" : faultWords(in, at);
  return line(comparison, at.isTriangle() ? words("It finds nothing wrong, and nothing is.")
                          : sees ? words("It sees that something is wrong: {fault}.", {{"fault", fault}})
                                 : words("It is blind: {fault}.", {{"fault", fault}}));
}

WorkingLine cosineTestLine(const In &in, const Out &at) {
  if (at.hasAngle())
    return testLine(in, at, compared(at.cosine, 1), cosineOf(at.perps) == Surd(1));
  return line(
      compared(norm(at.u) * norm(at.v), 0),
      words("There is no cosine, so this test cannot be made: {fault}.", {{"fault", faultWords(in, at)}}));
}

void addTests(const In &in, const Out &at, Explanation &lines) {
  lines.add("test-u", [&] { return testLine(in, at, compared(dot(at.u, at.u), 0), at.perps.uu == 0); });
  lines.add("test-v", [&] { return testLine(in, at, compared(dot(at.v, at.v), 0), at.perps.vv == 0); });
  lines.add("test-cosine", [&] { return cosineTestLine(in, at); });
  lines.add("test-squares", [&] {
    return testLine(in, at, compared(power(dot(at.u, at.v), 2), dot(at.u, at.u) * dot(at.v, at.v)),
                    at.perps.denominator == 0);
  });
}

Explanation explain(const In &in, const Out &at) {
  Explanation lines;
  lines.add("u", [&at] { return asked(withNumbers(at.u == at.P1 - at.P0)); });
  lines.add("v", [&at] {
    return asked(withNumbers(at.v == at.P2 - at.P0), words("Two sides, both from {P0}.", at.letters));
  });
  lines.add("uu", [&at] { return asked(withProducts(dot(at.u, at.u))); });
  lines.add("uv", [&at] { return asked(withProducts(dot(at.u, at.v))); });
  lines.add("vv", [&at] { return asked(withProducts(dot(at.v, at.v))); });
  lines.add("normal", [&at] { return normalLine(at); });
  lines.add("lengths", [&at] { return lengthsLine(at); });
  if (at.hasAngle())
    lines.add("cosine", [&at] { return cosineLine(at); });
  lines.add("squares", [&at] { return squaresLine(at); });
  lines.add("lagrange", [&at] { return lagrangeLine(at); });
  addTests(in, at, lines);
  return lines;
}

/// The normal is drawn this long in every picture, whatever u×v is: only its direction matters here.
constexpr double drawnNormalLength = 3;

/// The words speak of the normal's length, which would have no room: so its label says that it is not shown.
void drawNormal(Figure &figure, const Out &at, const Place &p0) {
  MarkBase normal = drawn(at.n, Role::Derived, Subject::Plane);
  normal.numbers = "\\ {\\scriptstyle\\text{" + words("direction only") + "}}";
  figure.add(arrowOfLength(std::move(normal), p0, at.perps.normal, drawnNormalLength));
}

/// Its area is the length of the normal.
void drawParallelogram(Figure &figure, const In &in, const Out &at) {
  const auto &[p0, p1, p2] = in.T.object;
  const Term area = norm(at.n);
  MarkBase base{at.n->mark + "/area", Role::Helper, Subject::Plane, latexOf(area)};
  base.numbers = relatedLatex(calculated(area));
  figure.add(PolygonMark{std::move(base), {place(p0), place(p1), place(ExactVec3(p1 + p2 - p0)), place(p2)}});
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  if (at.perps.uu != 0)
    figure.add(arrowOf(at.u, p0, Role::Given, Subject::EdgeU));
  if (at.perps.vv != 0) {
    ArrowMark v = arrowOf(at.v, p0, Role::Given, Subject::EdgeV);
    const bool isAlongU = !at.isTriangle() && at.perps.uv > 0;
    v.look.rank = isAlongU ? 1 : 0; // dashed, so that u is seen in it
    figure.add(std::move(v));
  }
  if (at.hasAngle())
    figure.add(ArcMark{drawn(at.theta, Role::Derived, Subject::Neutral), p0, place(at.u), place(at.v)});
  if (at.isTriangle()) {
    drawNormal(figure, at, p0);
    drawParallelogram(figure, in, at);
  }
  return figure;
}

/// A corner on another, and on the line of the two others.
std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (at.same != "none")
    return all;
  const auto &[p0, p1, p2] = in.T.object;
  const auto addSame = [&](const char *same, const Term &first, const Term &second,
                           const TriangleObject &triangle) {
    all.push_back({std::string("same_corners = ") + same,
                   words("{first} and {second} would be the same point.",
                         {{"first", plainText(first)}, {"second", plainText(second)}}),
                   "T", triangle});
  };
  addSame("P0-P1", at.P0, at.P1, {p0, p0, p2});
  addSame("P0-P2", at.P0, at.P2, {p0, p1, p0});
  addSame("P1-P2", at.P1, at.P2, {p0, p1, p1});
  if (at.isTriangle())
    addFlattened(in.T.object, at, all);
  return all;
}

} // namespace

Construction triangle_degenerate() {
  const std::vector<std::string> verdicts{"yes", "no"};
  return makeConstruction<In, Out, TriangleObject>(
      "triangle-degenerate", {"T"}, {}, {"u", "v", "n", "D", "θ"},
      {.cases = {"proper", "coincident", "collinear"},
       .values = {named::number("uu"), named::number("uv"), named::number("vv"), named::vector("normal"),
                  named::number("denominator"),
                  named::word("same_corners", {"none", "P0-P1", "P0-P2", "P1-P2", "all"}),
                  named::word("test_u", verdicts), named::word("test_v", verdicts),
                  named::word("test_cosine", {"yes", "no", "undefined"}),
                  named::word("test_squares", verdicts), named::number("cos_angle")},
       .lines = {"u", "v", "uu", "uv", "vv", "normal", "lengths", "cosine", "squares", "lagrange", "test-u",
                 "test-v", "test-cosine", "test-squares"},
       .marks = {"u", "v", "theta", "n"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
