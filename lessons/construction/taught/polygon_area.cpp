// The area of a polygon, by the cross products of a fan of triangles.
#include "geometry/polygon_area.h"
#include "lessons/construction/parts/flattened_polygon.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/polygon.h"

namespace halfspace {
namespace {

constexpr std::size_t mostTriangles = 6; // of eight corners

struct In : Naming {
  Given<PolygonObject> W;
};

std::vector<Term> fanOf(const In &in, const PolygonArea<Rational> &measured) {
  std::vector<Term> fan;
  for (const ExactVec3 &product : measured.fan)
    fan.push_back(ownName(in, vectorLetter("n", std::to_string(fan.size() + 1)), product));
  return fan;
}

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  PolygonArea<Rational> measured = polygonArea(in.W.object.corners);
  bool isPlanar = measured.which != PolygonAreaCase::NotPlanar;

  std::vector<Term> corners = cornerTermsOf(in.W);
  std::vector<Term> fan = fanOf(in, measured);
  Term n = drawnName(vectorLetter("n"), measured.sum);
  Term A = ownName(letter("A"), measured.area);
};

CaseWords tell(const Out &at) {
  switch (at.measured.which) {
  case PolygonAreaCase::Simple:
    return {"simple", words("The boundary does not meet itself. The area of the polygon is {A}.",
                            {{"A", equation(at.A)}})};
  case PolygonAreaCase::SelfMeeting:
    return {
        "self-meeting",
        words("The boundary meets itself: {A} counts each part as often as the boundary goes round it, and "
              "negative where it goes the other way round.",
              {{"A", equation(at.A)}}),
        true};
  case PolygonAreaCase::OnOneLine:
    return {"on-one-line", words("All corners lie on one line: no area is left."), true};
  case PolygonAreaCase::NotPlanar:
    break;
  }
  return {"not-planar",
          words("The corners do not lie in one plane: no flat polygon is there that has an area."), true};
}

WorkingLine triangleLine(const Out &at, std::size_t index) {
  const Term &first = at.corners[0];
  const Term &second = at.corners[index + 1];
  const Term &third = at.corners[index + 2];
  const Term u = second - first;
  const Term v = third - first;
  return asked(
      withNumbers(at.fan[index] == cross(u, v)),
      words("Its length is twice the area of the triangle of {first}, {second} and {third}.",
            {{"first", plainText(first)}, {"second", plainText(second)}, {"third", plainText(third)}}),
      {{cross(v, u), words("{answer} is the cross product the other way round.")}});
}

std::string sumWords(const Out &at) {
  return at.isPlanar ? words("All triangles together. Where one goes round the other way its vector points "
                             "backwards, and it is taken away.")
                     : words("All triangles together. They do not lie in one plane.");
}

std::string areaWords(const Out &at) {
  switch (at.measured.which) {
  case PolygonAreaCase::Simple:
    return words("Half of the length: the area of the polygon.");
  case PolygonAreaCase::SelfMeeting:
    return words("Half of the length: each part counts as often as the boundary goes round it, and negative "
                 "where it goes the other way round.");
  default:
    return words("0: the corners lie on one line.");
  }
}

WorkingLine areaLine(const Out &at) {
  return asked(
      withNumbers(at.A == norm(at.n) / 2), areaWords(at),
      {{norm(at.n), words("{answer} is twice the area: each cross product is that of a parallelogram.")},
       {dot(at.n, at.n) / 2, words("{answer} is half of n·n: the length of n is its root.")}});
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {linesOfEach<Out>(
           mostTriangles, [](const Out &at, std::size_t index) { return index < at.fan.size(); },
           {{"triangle", triangleLine}}, 1),
       {{"sum", always, [](const Out &at) { return withNumbers(at.n == sum(at.fan)); }, sumWords},
        {"area", &Out::isPlanar, areaLine}}});
}

/// In scene units: twice the area would have no room as a length.
constexpr double drawnNormalLength = 3;

/// The sides of the fan's triangles that are no sides of the polygon.
void drawFan(Figure &figure, const Out &at) {
  const auto &corners = at.in.W.object.corners;
  for (std::size_t i = 2; i + 1 < corners.size(); ++i)
    if (corners[i] != corners[0])
      figure.add(SegmentMark{{partOf(at.mark("fan"), i - 2), Role::Helper, Subject::Measure},
                             place(corners[0]),
                             place(corners[i])});
}

Figure draw(const Out &at) {
  Figure figure;
  drawFan(figure, at);
  addDirection(figure, at.n, place(at.corners[0]), drawnNormalLength, Role::Derived, Subject::Plane);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (at.isPlanar)
    return {};
  return {{isNot("case", "not-planar"), words("The corners would lie in one plane."), "W",
           flattenedPolygon(at.in.W.object)}};
}

} // namespace

Construction polygon_area() {
  return taught<Out, PolygonObject>({.id = "polygon-area",
                                     .word = "area",
                                     .title = [] { return words("area"); },
                                     .roles = {"W"},
                                     .letters = {"n1", "n2", "n3", "n4", "n5", "n6", "n", "A"},
                                     .cases = {"simple", "self-meeting", "on-one-line", "not-planar"},
                                     .values = {{named::vector("normal"), always, &Out::n},
                                                {named::number("area"), &Out::isPlanar, &Out::A}},
                                     .lines = lines(),
                                     .marks = {"fan", "n"},
                                     .tell = tell,
                                     .draw = draw,
                                     .nearby = nearby});
}

} // namespace halfspace
