// The planes that halve the angles of two planes: all points that are equally far from both. One normal is
// made as long as the other; then their sum and their difference are the normals.
#include "geometry/bisect_planes.h"
#include "geometry/case_names.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/made_plane.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/taught.h"

#include <vector>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PlaneObject> F;
};

/// vector + factor·other
std::vector<Surd> combined(const ExactVec3 &vector, const Surd &factor, const ExactVec3 &other) {
  return {factor * other.x + vector.x, factor * other.y + vector.y, factor * other.z + vector.z};
}

/// A plane of points that are equally far from both.
struct Bisector {
  std::string name;
  bool isDifference; ///< of the equation of F and k times that of E; else their sum
  PlaneTerms terms;
  Term d;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  BisectedPlanes bisected = bisectPlanes(planeOf(in.E.object), planeOf(in.F.object));
  BisectPlanesCase which = bisected.which;
  bool hasPlanes = which != BisectPlanesCase::ZeroNormal;
  bool areParallel = which == BisectPlanesCase::Parallel;
  /// There is a line of both, and two planes through it.
  bool areCrossing = which == BisectPlanesCase::Crossing || which == BisectPlanesCase::Irrational;
  bool isAnyHalved = areCrossing || areParallel;
  bool makesFirst = isAnyHalved && which != BisectPlanesCase::Irrational;
  bool makesSecond = which == BisectPlanesCase::Crossing;
  /// Of parallel planes: the normals point to different sides.
  bool areOpposite = areParallel && dot(in.E.object.normal, in.F.object.normal) < 0;

  PlaneTerms E = termsOf(in.E);
  PlaneTerms F = termsOf(in.F);
  Term dE = constantOf(in.E);
  Term dF = constantOf(in.F);
  Term k = ownName(letter("k"), bisected.ratio);
  Term v =
      ownName(vectorLetter("v"), ExactVec3(cross(in.E.object.normal, in.F.object.normal))).marked(mark("v"));
  Term moment = dE * F.n - dF * E.n; ///< of the line of both
  /// The line's point that is nearest to the origin; of parallel planes a point halfway between them.
  Term point = areCrossing ? cross(v, moment) / dot(v, v) : (E.P0 + F.P0) / 2;
  Bisector G = bisector("G", point, areOpposite);
  Bisector H = bisector("H", G.terms.P0, true);

  [[nodiscard]] Bisector bisector(const std::string &name, const Term &through, bool isDifference) const {
    const Surd factor = isDifference ? -bisected.ratio : bisected.ratio;
    const std::vector<Surd> normal = combined(in.F.object.normal, factor, in.E.object.normal);
    Symbol constant = letter("d");
    constant.owner = made.at(name).coordinates.at("n").owner;
    const Surd d = factor * planeOf(in.E.object).offset + planeOf(in.F.object).offset;
    return {name, isDifference, madePlane(*this, name, through, normal),
            halfspace::name(std::move(constant), d)};
  }
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.which));
  switch (at.which) {
  case BisectPlanesCase::Crossing:
    return {caseName, words("{G} and {H} halve the angles of {E} and {F}: they have all points that are "
                            "equally far from both.",
                            at.letters)};
  case BisectPlanesCase::Irrational:
    return {
        caseName,
        words("{G} and {H} halve the angles of {E} and {F}. Their equations have roots, because {k} has one: "
              "so they are only drawn, and are no objects of the scene.",
              at.letters, {{"k", plainText(at.k)}})};
  case BisectPlanesCase::Parallel:
    return {caseName, words("{E} and {F} are parallel: the only points that are equally far from both are "
                            "those of {G}, halfway between them.",
                            at.letters)};
  case BisectPlanesCase::Coincident:
    return {caseName,
            words("{E} and {F} are the same plane: every point is equally far from both, and there is no "
                  "angle to halve.",
                  at.letters)};
  case BisectPlanesCase::ZeroNormal:
    break;
  }
  return zeroNormalAmong({at.E.n, at.F.n});
}

WorkingLine ratioLine(const Out &at) {
  const Term ratio = norm(at.F.n) / norm(at.E.n);
  return asked(withNumbers(at.k == ratio),
               words("So many times {E.n} is as long as {F.n}. Then k times the equation of {E} measures "
                     "distances in the same unit as that of {F}.",
                     at.letters),
               {{dot(at.F.n, at.F.n) / dot(at.E.n, at.E.n),
                 words("{answer} is the ratio of the squares: take the root.")}});
}

WorkingLine directionLine(const Out &at) {
  return asked(withProducts(at.v == cross(at.E.n, at.F.n)),
               words("{E} and {F} meet in a line that goes this way.", at.letters),
               {{cross(at.F.n, at.E.n), words("{answer} is the cross product the other way round.")}});
}

std::string pointWords(const Out &at) {
  return at.areCrossing
             ? words("A point of both planes, the nearest one to the origin: it is 0 away from both.")
             : words("Halfway from {E.P0} to {F.P0}: equally far from both planes.", at.letters);
}

/// What stands for F with k times that of E.
Term combined(const Out &at, const Bisector &plane, const Term &ofF, const Term &ofE) {
  return plane.isDifference ? ofF - at.k * ofE : ofF + at.k * ofE;
}

WorkingLine normalLine(const Out &at, const Bisector &plane) {
  return asked(withNumbers(plane.terms.n == combined(at, plane, at.F.n, at.E.n)),
               words("The normal of {plane}, from two vectors of one length.",
                     {{"plane", plainText(at.made.at(plane.name).symbol)}}));
}

WorkingLine sumLine(const Out &at, const Bisector &plane) {
  return asked(withNumbers(plane.d == combined(at, plane, at.dF, at.dE)),
               words("The constant, from those of {E} and {F} likewise.", at.letters));
}

WorkingLine rightAngleLine(const Out &at) {
  return line(withProducts(dot(at.G.terms.n, at.H.terms.n)),
              words("0: {G} and {H} are perpendicular to each other, whatever the angle of {E} and {F} is.",
                    at.letters));
}

void addBisectorLines(LineTable<Out> &all, Bisector Out::*plane, const std::string &name,
                      const When<Out> &stands) {
  all.push_back({"normal-" + name, stands, [=](const Out &at) { return normalLine(at, at.*plane); }});
  all.push_back({"d-" + name, stands, [=](const Out &at) { return sumLine(at, at.*plane); }});
  all.push_back({"equation-" + name, stands,
                 [=](const Out &at) { return equationLine(at, name, (at.*plane).terms, (at.*plane).d); }});
}

LineTable<Out> lines() {
  LineTable<Out> all{{"d1", &Out::hasPlanes, [](const Out &at) { return givenConstantLine(at.in.E); }},
                     {"d2", &Out::hasPlanes, [](const Out &at) { return givenConstantLine(at.in.F); }},
                     {"ratio", &Out::hasPlanes, ratioLine},
                     {"direction", &Out::areCrossing, directionLine},
                     {"point", &Out::isAnyHalved,
                      [](const Out &at) { return withNumbers(at.G.terms.P0 == at.point); }, pointWords}};
  addBisectorLines(all, &Out::G, "G", &Out::isAnyHalved);
  addBisectorLines(all, &Out::H, "H", &Out::areCrossing);
  all.push_back({"right-angle", &Out::areCrossing, rightAngleLine});
  return all;
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isAnyHalved)
    return figure;
  const Place point = place(at.point);
  addMadePlane(figure, at, "G", at.G.terms);
  if (!at.areCrossing)
    return figure;
  addMadePlane(figure, at, "H", at.H.terms, Look{.rank = 1});
  figure.add(LineMark{{at.v->mark, Role::Helper, Subject::Ray}, point, unitOf(vectorOf(at.v))});
  figure.reaches = {{at.in.E.id, point}, {at.in.F.id, point}};
  return figure;
}

/// The plane E turned about its point, until it is parallel to the other one or perpendicular.
std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.areCrossing)
    return all;
  const auto &[point, normal] = at.in.E.object;
  const auto parts = projectVector(normal, at.in.F.object.normal);
  const bool isInBoth = evaluate(planeOf(at.in.F.object), point) == 0;
  if (!isZero(parts.projection))
    all.push_back({is("case", isInBoth ? "coincident" : "parallel"),
                   isInBoth ? words("{E} and {F} would be the same plane.", at.letters)
                            : words("The planes would be parallel."),
                   "E", PlaneObject{point, parts.projection}});
  return all;
}

ToldValue coefficientsOf(const Out &at, const Bisector &plane) {
  std::vector<Surd> numbers = exactNumbers(*plane.terms.n->value).value();
  numbers.push_back(*numberOf(plane.d)->exact());
  return {words("coefficients of {plane}", {{"plane", plainText(at.made.at(plane.name).symbol)}}),
          std::move(numbers)};
}

} // namespace

Construction plane_bisectors() {
  return taught<Out, PlaneObject, PlaneObject>(
      {.id = "plane-bisectors",
       .title = [] { return words("planes that halve the angle"); },
       .roles = {"E", "F"},
       .makes = {{"G", PlaneObject::kind, &Out::makesFirst,
                  [](const Out &at) { return planeOf(at.G.terms); }},
                 {"H", PlaneObject::kind, &Out::makesSecond,
                  [](const Out &at) { return planeOf(at.H.terms); }}},
       .letters = {"k", "v"},
       .cases = {"crossing", "irrational", "parallel", "coincident", "zero-normal"},
       .values = {{named::number("ratio"), &Out::hasPlanes, &Out::k},
                  {named::list("coefficients_G", 4), &Out::isAnyHalved,
                   [](const Out &at) { return coefficientsOf(at, at.G); }},
                  {named::list("coefficients_H", 4), &Out::areCrossing,
                   [](const Out &at) { return coefficientsOf(at, at.H); }},
                  {named::vector("point"), &Out::isAnyHalved, [](const Out &at) { return at.G.terms.P0; }}},
       .lines = lines(),
       .marks = {"G", "G.n", "G.P0", "H", "H.n", "H.P0", "v"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
