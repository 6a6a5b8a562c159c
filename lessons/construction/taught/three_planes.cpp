// Where three planes meet, by Cramer's rule: the point of all three, or how they miss to have one.
#include "geometry/case_names.h"
#include "geometry/intersect_three_planes.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/taught.h"

#include <array>
#include <utility>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
  Given<PlaneObject> G;
};

/// Two of the planes, in the order of their cross product, by their places.
constexpr std::array<std::pair<std::size_t, std::size_t>, 3> pairs{{{1, 2}, {2, 0}, {0, 1}}};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  std::array<Given<PlaneObject>, 3> given{in.E, in.F, in.G};
  std::array<Plane<Rational>, 3> planes{planeOf(in.E.object), planeOf(in.F.object), planeOf(in.G.object)};
  ThreePlanes<Rational> meet = intersectPlanes(planes[0], planes[1], planes[2]);
  bool hasPlanes = meet.which != ThreePlanesCase::ZeroNormal;
  bool hasPoint = meet.which == ThreePlanesCase::Point;

  std::array<Term, 3> n{termsOf(in.E).n, termsOf(in.F).n, termsOf(in.G).n};
  std::array<Term, 3> d{constantOf(in.E), constantOf(in.F), constantOf(in.G)};
  /// Along the lines in which two planes meet, which are the marks.
  std::array<Term, 3> along{alongLine("a", 0), alongLine("b", 1), alongLine("c", 2)};
  Term D = ownName(letter("D"), meet.weight);
  Term X = ownName(letter("X"), meet.weighted); ///< the common point times D
  Term S = madeName("S", meet.point);

  [[nodiscard]] Term alongLine(const char *own, std::size_t pair) const {
    return ownName(vectorLetter(own), meet.directions.at(pair)).marked(mark(own));
  }
  /// What two of the planes have in common.
  [[nodiscard]] PlanePlane<Rational> meetingOf(std::size_t pair) const {
    return intersectPlanes(planes.at(pairs.at(pair).first), planes.at(pairs.at(pair).second));
  }
  /// The two planes of a pair, for sentences, and the third one.
  [[nodiscard]] WordValues namesOf(std::size_t pair) const {
    const auto &[first, second] = pairs.at(pair);
    return {{"first", plainText(given.at(first).symbol)},
            {"second", plainText(given.at(second).symbol)},
            {"third", plainText(given.at(pair).symbol)}};
  }
  /// The first pair of planes that stand so to each other; nothing where none does.
  [[nodiscard]] std::optional<std::size_t> pairThatIs(PlanePlaneCase which) const {
    for (std::size_t pair = 0; pair < pairs.size(); ++pair)
      if (meetingOf(pair).which == which)
        return pair;
    return {};
  }
};

std::string commonLineWords(const Out &at) {
  if (const auto same = at.pairThatIs(PlanePlaneCase::Coincident))
    return words("{first} and {second} are the same plane, which {third} meets in a line: each point of the "
                 "line lies in all three.",
                 at.namesOf(*same));
  return words("D = 0 and X is the zero vector: {E}, {F} and {G} all go through one line.", at.letters);
}

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case ThreePlanesCase::Point:
    return {caseName,
            words("{D} is not 0: the planes {E}, {F} and {G} have a single point in common, {point}.",
                  at.letters, {{"D", equation(at.D)}, {"point", equation(at.S)}})};
  case ThreePlanesCase::Line:
    return {caseName, commonLineWords(at)};
  case ThreePlanesCase::Prism:
    return {caseName,
            words("D = 0 and X is not the zero vector: {E}, {F} and {G} meet two by two in three parallel "
                  "lines, and no point lies in all three.",
                  at.letters)};
  case ThreePlanesCase::Parallel:
    return {caseName, words("{first} and {second} are parallel and share no point, so no point lies in all "
                            "three planes.",
                            at.namesOf(at.pairThatIs(PlanePlaneCase::Parallel).value()))};
  case ThreePlanesCase::Coincident:
    return {caseName,
            words("{E}, {F} and {G} are the same plane: each of its points lies in all three.", at.letters)};
  case ThreePlanesCase::ZeroNormal:
    break;
  }
  return zeroNormalAmong({at.n[0], at.n[1], at.n[2]});
}

WorkingLine alongLine(const Out &at, std::size_t pair) {
  const Term &first = at.n.at(pairs.at(pair).first);
  const Term &second = at.n.at(pairs.at(pair).second);
  return asked(withProducts(at.along.at(pair) == cross(first, second)),
               isZero(at.meet.directions.at(pair))
                   ? words("The zero vector: the normals of {first} and {second} lie along one line.",
                           at.namesOf(pair))
                   : words("{first} and {second} meet in a line that goes this way.", at.namesOf(pair)),
               {{cross(second, first), words("{answer} is the cross product the other way round.")}});
}

WorkingLine determinantLine(const Out &at) {
  const Term whole = determinant(3, {at.n[0], at.n[1], at.n[2]});
  return asked(withProducts((at.D == whole) == dot(at.n[0], at.along[0])),
               at.hasPoint ? words("The determinant of the normals. It is not 0, so no direction runs along "
                                   "all three planes.")
                           : words("The determinant of the normals. It is 0: a direction runs along all "
                                   "three planes, so they share more than one point, or none."),
               {{-at.D, words("{answer} has the wrong sign.")}});
}

std::string weightedWords(const Out &at) {
  switch (at.meet.which) {
  case ThreePlanesCase::Point:
    return words("The common point, times D.");
  case ThreePlanesCase::Line:
    return words("The zero vector, and D = 0: the three equations hold along a whole line.");
  case ThreePlanesCase::Prism:
    return words("No point fulfils all three equations: only the direction of the parallel lines is left.");
  case ThreePlanesCase::Parallel:
  case ThreePlanesCase::Coincident:
  case ThreePlanesCase::ZeroNormal:
    break;
  }
  return at.pairThatIs(PlanePlaneCase::Line)
             ? words("No point fulfils all three equations: only a direction along all three planes is left.")
             : words("The zero vector, because all three cross products are. It does not tell whether the "
                     "planes are the same.");
}

WorkingLine weightedLine(const Out &at) {
  const Term total = at.d[0] * at.along[0] + at.d[1] * at.along[1] + at.d[2] * at.along[2];
  return asked(withNumbers(at.X == -total), weightedWords(at),
               {{total, words("{answer} has the wrong sign: each d stands on the other side of its "
                              "equation, n·P = −d.")}});
}

LineTable<Out> lines() {
  LineTable<Out> all;
  const auto addOfEach = [&all](const std::array<const char *, 3> &ids, auto make) {
    for (std::size_t i = 0; i < ids.size(); ++i)
      all.push_back({ids.at(i), &Out::hasPlanes, [=](const Out &at) { return make(at, i); }});
  };
  addOfEach({"d1", "d2", "d3"},
            [](const Out &at, std::size_t plane) { return givenConstantLine(at.given.at(plane)); });
  addOfEach({"a", "b", "c"}, alongLine);
  all.push_back({"det", &Out::hasPlanes, determinantLine});
  all.push_back({"weighted", &Out::hasPlanes, weightedLine});
  all.push_back({"point", &Out::hasPoint, [](const Out &at) { return withNumbers(at.S == at.X / at.D); },
                 says("Divided by D: the common point.")});
  return all;
}

/// Each line in which two planes meet, and the planes as far as its point.
void drawMeetings(Figure &figure, const Out &at) {
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    const PlanePlane<Rational> meet = at.meetingOf(pair);
    if (meet.which != PlanePlaneCase::Line)
      continue;
    const Place through = at.hasPoint ? place(at.S) : place(meet.nearest);
    const Role role = at.meet.which == ThreePlanesCase::Line ? Role::Result : Role::Helper;
    figure.add(LineMark{{at.along.at(pair)->mark, role, Subject::Ray}, through, unitOf(meet.line.direction)});
    figure.reaches.push_back({at.given.at(pairs.at(pair).first).id, through});
    figure.reaches.push_back({at.given.at(pairs.at(pair).second).id, through});
  }
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlanes)
    return figure;
  drawMeetings(figure, at);
  if (at.hasPoint)
    figure.add(pointOf(at.S, Role::Result, Subject::Measure));
  return figure;
}

ToldValue homogeneousValue(const Out &at) {
  const auto &[x, y, z] = at.meet.weighted;
  return {words("homogeneous coordinates"), std::vector<Surd>{x, y, z, at.meet.weight}};
}

/// The last plane turned about its point until it runs along the line of the others, or slid until it
/// contains that.
std::vector<SpecialCase> nearby(const Out &at) {
  const PlanePlane<Rational> others = at.meetingOf(2);
  PlaneObject changed = at.in.G.object;
  if (at.meet.which == ThreePlanesCase::Prism)
    changed.point += projectVector(ExactVec3(others.nearest - changed.point), changed.normal).projection;
  else if (at.hasPoint)
    changed.normal = projectVector(changed.normal, others.line.direction).rejection;
  else
    return {};
  const ThreePlanesCase which = intersectPlanes(at.planes[0], at.planes[1], planeOf(changed)).which;
  if (which == ThreePlanesCase::ZeroNormal)
    return {};
  return {{is("case", nameOf(which)),
           which == ThreePlanesCase::Line ? words("The three planes would have a line in common.")
                                          : words("No point would lie in all three planes."),
           "G", changed}};
}

} // namespace

Construction three_planes() {
  return taught<Out, PlaneObject, PlaneObject, PlaneObject>(
      {.id = "three-planes",
       .word = "intersect",
       .title = [] { return words("common point of the planes"); },
       .roles = {"E", "F", "G"},
       .makes = {{"S", &Out::hasPoint, &Out::S}},
       .letters = {"a", "b", "c", "D", "X"},
       .cases = {"point", "line", "prism", "parallel", "coincident", "zero-normal"},
       .values = {{named::number("det"), &Out::hasPlanes, &Out::D},
                  {named::list("homogeneous", 4), &Out::hasPlanes, homogeneousValue},
                  {named::vector("point"), &Out::hasPoint, &Out::S}},
       .lines = lines(),
       .marks = {"a", "b", "c", "S"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
