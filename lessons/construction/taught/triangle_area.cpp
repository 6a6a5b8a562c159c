// The area of a triangle: half the length of the cross product of two sides, and half of base times height.
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/two_vectors.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/triangle.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<TriangleObject> T;
};

struct Out : Computed<In>, TriangleTerms {
  explicit Out(const In &objects) : Computed(objects), TriangleTerms(termsOf(objects.T)) {}

  TrianglePerps<Rational> perps = perpsOf(Triangle<Rational>{in.T.object.p0, in.T.object.p1, in.T.object.p2});
  bool isTriangle = perps.denominator != 0;
  Rational square = dot(perps.normal, perps.normal); ///< of twice the area

  Term u = drawnName(vectorLetter("u"), perps.u);
  Term v = drawnName(vectorLetter("v"), perps.v);
  Term n = drawnName(vectorLetter("n"), perps.normal);
  Term A = ownName(letter("A"), Surd::root(square, Rational(1, 2))).marked(in.T.id);
  /// Over u.
  Term h = drawnName(letter("h"), isTriangle ? Surd::root(Rational(square / perps.uu)) : Surd());
};

CaseWords tell(const Out &at) {
  if (at.isTriangle)
    return {"proper", words("The triangle is half of the parallelogram of u and v. Its area is {A}.",
                            at.letters, {{"A", equation(at.A)}})};
  const auto &[p0, p1, p2] = at.in.T.object;
  if (p0 != p1 && p0 != p2 && p1 != p2)
    return {"collinear", words("{P0}, {P1} and {P2} lie on one line: no area is left.", at.letters), true};
  return {"coincident",
          coincidentWords(at.in.T.object, at,
                          {says("{first} and {second} are the same point: no area is left."),
                           says("{first}, {second} and {third} are the same point: no area is left.")}),
          true};
}

WorkingLine areaLine(const Out &at) {
  return asked(withNumbers(at.A == norm(at.n) / 2),
               at.isTriangle ? words("Half of the parallelogram of u and v, whose area is |n|.")
                             : words("0: u and v span no parallelogram."),
               {{norm(at.n), words("{answer} is the area of the parallelogram: the triangle is half of it.")},
                {dot(at.n, at.n) / 2, words("{answer} is half of n·n: the length of n is its root.")}});
}

WorkingLine heightLine(const Out &at) {
  return asked(
      withNumbers(at.h == norm(at.n) / norm(at.u)),
      words("The height over u: the area of the parallelogram divided by its base."),
      {{norm(at.n) / dot(at.u, at.u), words("{answer} is divided by u·u: divide by its root, |u|.")}});
}

WorkingLine byHeightLine(const Out &at) {
  return asked(withNumbers(norm(at.u) * at.h / 2), words("Half of base times height: the same area."));
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {sideLines<Out>(),
       {{"normal", always,
         [](const Out &at) { return sidesNormalLine(at.n, at.u, at.v, crossProductWords(at.n)); }},
        {"area", always, areaLine},
        {"height", &Out::isTriangle, heightLine},
        {"by-height", &Out::isTriangle, byHeightLine}}});
}

/// In scene units: the area would have no room as a length.
constexpr double drawnNormalLength = 3;

Figure draw(const Out &at) {
  Figure figure;
  const Place p0 = place(at.P0);
  if (at.perps.uu != 0)
    figure.add(arrowOf(at.u, p0, Role::Derived, Subject::EdgeU));
  if (at.perps.vv != 0)
    figure.add(arrowOf(at.v, p0, Role::Derived, Subject::EdgeV));
  if (!at.isTriangle)
    return figure;
  addDirection(figure, at.n, p0, drawnNormalLength, Role::Derived, Subject::Plane);
  figure.add(parallelogramOf(at.n->mark + "/area", norm(at.n), p0, place(at.u), place(at.v)));
  addHeight(figure, at.h, p0, at.perps.u, at.perps.v);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (at.isTriangle)
    addFlattened(at.in.T.object, at, all);
  return all;
}

} // namespace

Construction triangle_area() {
  return taught<Out, TriangleObject>({.id = "triangle-area",
                                      .word = "area",
                                      .title = [] { return words("area of the triangle"); },
                                      .roles = {"T"},
                                      .letters = {"u", "v", "n", "A", "h"},
                                      .cases = {"proper", "coincident", "collinear"},
                                      .values = {{named::vector("normal"), always, &Out::n},
                                                 {named::number("area"), always, &Out::A},
                                                 {named::number("height"), &Out::isTriangle, &Out::h}},
                                      .lines = lines(),
                                      .marks = {"u", "v", "n", "h"},
                                      .tell = tell,
                                      .draw = draw,
                                      .nearby = nearby});
}

} // namespace halfspace
