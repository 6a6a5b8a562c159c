// How far two points are from each other: the length of the way from one to the other.
#include "lessons/construction/parts/two_points.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct Out : WayBetweenPoints {
  explicit Out(const TwoPoints &objects) : WayBetweenPoints(objects) {}

  Term dist = ownName(word("dist"), Surd::root(dot(way, way))).marked(mark("w")); ///< the length of w
};

CaseWords tell(const Out &at) {
  if (at.areApart)
    return {"apart", words("{A} and {B} are different points: {distance}.", at.letters,
                           {{"distance", equation(name(word(words("distance")), at.dist->value))}})};
  return {"same", words("{A} and {B} are the same point: their distance is 0.", at.letters)};
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers((at.dist == norm(at.w)) == root(dot(at.w, at.w))),
               at.areApart ? words("The distance is the length of this arrow.")
                           : words("0: the way has no length."),
               {{dot(at.w, at.w), words("{answer} is w·w: its root is still to be taken.")}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (at.areApart)
    figure.add(arrowOf(at.w, place(at.A), Role::Result, Subject::Measure));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.areApart)
    return {};
  return {{is("case", "same"), words("{A} and {B} would be the same point.", at.letters), "B",
           PointObject{at.in.A.object.at}}};
}

} // namespace

Construction point_point() {
  return taught<Out, PointObject, PointObject>(
      {.id = "point-point",
       .word = "distance",
       .title = [] { return words("distance of the points"); },
       .roles = {"A", "B"},
       .letters = {"w", "dist"},
       .cases = {"apart", "same"},
       .values = {{named::number("squared"), always, [](const Out &at) { return dot(at.w, at.w); }},
                  {named::number("distance"), always, &Out::dist}},
       .lines = {{"w", always, wayLine},
                 {"squared", always, [](const Out &at) { return withProducts(dot(at.w, at.w)); },
                  says("The square of the distance: the sum of the squares of the three coordinates.")},
                 {"distance", always, distanceLine}},
       .marks = {"w"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
