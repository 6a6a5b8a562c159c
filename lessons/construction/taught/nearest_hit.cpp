// Which of many triangles a ray hits first: the one with the smallest parameter that is not negative (note
// PG 7). The ray's parameter is λ here, because s and t belong to the triangles.
#include "geometry/barycentric.h"
#include "geometry/case_names.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/fragments.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace halfspace {
namespace {

/// Nobody reads a longer list: of meshes with more triangles, what is hit first and what is looked at are
/// told.
constexpr std::size_t mostListedFragments = 128;
/// So many parameters at most are written down in their order.
constexpr std::size_t mostOrdered = 6;

struct In : Naming {
  Given<RayObject> L;
  Given<NumberObject> i; ///< the number of the fragment that is looked at, or none
  GivenMeshes meshes;
};

/// A triangle, and how the ray meets it.
struct Meeting {
  Fragment fragment;
  std::size_t number = 0;
  Triangle<Rational> triangle;
  RayTriangle<Rational> meet;
};

/// What a ray and a triangle in whose plane it lies have in common, by the ray's λ.
struct Passage {
  Rational begin;
  Rational end;
};

/// A triangle in whose plane the ray lies, and what both have in common.
struct Along {
  Fragment fragment;
  Passage passage;
};

struct Out : Naming, RayTerms {
  std::size_t fragments = 0;
  std::vector<Meeting> listed; ///< by number
  FirstHits first;
  std::optional<Meeting> nearest;
  std::optional<Meeting> chosen;
  std::optional<Along> along; ///< the first of those listed that the ray lies in
  Term lambda, H;
};

bool isHit(const Meeting &meeting) { return meeting.meet.which == RayTriangleCase::Hit; }

/// Earlier hits come first, and of those with the same λ the one with the lower number.
bool isNearer(const Meeting &a, const Meeting &b) {
  return a.meet.plane.t != b.meet.plane.t ? a.meet.plane.t < b.meet.plane.t : a.number < b.number;
}

/// Where all meshes stand: that takes a root for each of them.
using Placements = std::vector<MeshPlacement>;

Placements placementsOf(const GivenMeshes &meshes) {
  Placements placements;
  for (const auto &mesh : meshes)
    placements.emplace_back(mesh.object);
  return placements;
}

Meeting meetingWith(const In &in, const Placements &placements, std::size_t number) {
  const Fragment fragment = fragmentOf(in.meshes, number);
  const MeshShape &shape = *in.meshes[fragment.mesh].object.shape;
  const Triangle<Rational> triangle =
      placements[fragment.mesh].toScene(shape.mesh()->triangle(fragment.index));
  return {fragment, number, triangle,
          intersectRayTriangle(Ray<Rational>{in.L.object.origin, in.L.object.direction}, triangle)};
}

/// The number that stands for a fragment; nothing where it stands for none.
std::optional<std::size_t> chosenNumber(const Rational &i, std::size_t count) {
  if (i < 1 || i > Rational(static_cast<std::int64_t>(count)) || i.denominator() != 1)
    return {};
  return static_cast<std::size_t>(toDouble(i));
}

/// The numbers of those that are listed: all of meshes with few triangles, and what is hit first or looked
/// at.
std::set<std::size_t> listedNumbers(const In &in, const Out &at) {
  std::set<std::size_t> numbers;
  std::size_t before = 0;
  for (const auto &mesh : in.meshes) {
    const std::size_t count = mesh.object.shape->triangleCount();
    if (numbers.size() + count <= mostListedFragments)
      for (std::size_t number = before + 1; number <= before + count; ++number)
        numbers.insert(number);
    before += count;
  }
  for (const auto *needed : {&at.nearest, &at.chosen})
    if (*needed)
      numbers.insert((*needed)->number);
  return numbers;
}

/// Along the ray each corner's weight changes evenly, and those of inside are never negative: each weight
/// leaves a piece of the ray. Nothing where no piece is left.
std::optional<Passage> passageThrough(const RayObject &ray, const Triangle<Rational> &triangle) {
  const auto atStart = barycentricOf(ray.origin, triangle).weights;
  const auto stepLater = barycentricOf(ExactVec3(ray.origin + ray.direction), triangle).weights;
  Rational begin;
  std::optional<Rational> end;
  for (std::size_t i = 0; i < atStart.size(); ++i) {
    const Rational slope = stepLater[i] - atStart[i];
    if (slope == 0 && atStart[i] < 0)
      return {};
    if (slope == 0)
      continue;
    const Rational zero = -atStart[i] / slope;
    if (slope > 0)
      begin = std::max(begin, zero);
    else
      end = end ? std::min(*end, zero) : zero;
  }
  // The weights add up to 1, so one of them falls along the ray.
  return end && begin <= *end ? std::optional(Passage{begin, *end}) : std::nullopt;
}

/// The first along the ray of those in whose planes it lies; nothing where there is none.
std::optional<Along> firstAlong(const RayObject &ray, const std::vector<Meeting> &meetings) {
  std::optional<Along> first;
  for (const Meeting &meeting : meetings) {
    if (meeting.meet.which != RayTriangleCase::InPlane)
      continue;
    const auto passage = passageThrough(ray, meeting.triangle);
    if (passage && (!first || passage->begin < first->passage.begin))
      first = {meeting.fragment, *passage};
  }
  return first;
}

Out compute(const In &in) {
  Out out{in, termsOf(in.L), fragmentCount(in.meshes), {}, {}, {}, {}, {}, Term(0), Term(0)};
  const Placements placements = placementsOf(in.meshes);
  if (const auto number = chosenNumber(in.i.object.value, out.fragments))
    out.chosen = meetingWith(in, placements, *number);
  if (!isZero(in.L.object.direction)) {
    out.first = firstHits(in.L.object, in.meshes);
    if (!out.first.fragments.empty())
      out.nearest = meetingWith(in, placements, numberOf(in.meshes, out.first.fragments.front()));
    for (const std::size_t number : listedNumbers(in, out))
      out.listed.push_back(meetingWith(in, placements, number));
    out.along = firstAlong(in.L.object, out.listed);
  }
  const ExactVec3 point = out.nearest ? out.nearest->meet.plane.point : ExactVec3(in.L.object.origin);
  out.lambda = name(in.own(letter("λ", "H")), out.first.t);
  if (out.nearest)
    out.lambda = out.lambda.standingFor(crossingTerm(out, out.nearest->triangle));
  out.H = madeName(in, "H", point);
  return out;
}

bool isDegenerate(const In &in) { return isZero(in.L.object.direction); }
bool areAllListed(const Out &at) { return at.listed.size() == at.fragments; }

/// How many of those that are listed are hit at the smallest λ.
int tieCount(const Out &at) {
  return static_cast<int>(std::count_if(at.listed.begin(), at.listed.end(), [&at](const Meeting &meeting) {
    return isHit(meeting) && meeting.meet.plane.t == at.first.t;
  }));
}

bool isTriangle(const Meeting &meeting) { return meeting.meet.perps.denominator != 0; }

CaseWords tellMiss(const In &in, const Out &at) {
  if (at.along) {
    const WordValues values{{"fragment", nameOf(in.meshes, at.along->fragment)}};
    return {"in-plane",
            at.along->passage.begin < at.along->passage.end
                ? words("The ray runs along {fragment}, in its plane: it hits no triangle at a single point.",
                        values)
                : words("The ray touches {fragment} at one point, within its plane, and that does not count "
                        "as a hit. It hits no triangle.",
                        values)};
  }
  if (areAllListed(at))
    return {"miss", words("No triangle has a hit with λ ≥ 0: the ray meets nothing.")};
  return {"miss", words("No triangle has a hit with λ ≥ 0. Whether the ray lies in the plane of one and runs "
                        "along it is not looked at: there are more than {most} triangles.",
                        {{"most", std::to_string(mostListedFragments)}})};
}

/// Why the triangle that is looked at is none; empty where it is one.
std::string chosenWords(const In &in, const Out &at) {
  const WordValues values{{"i", equation(coordinateTerm(in.i, 0))}, {"count", std::to_string(at.fragments)}};
  if (!at.chosen)
    return words("{i} is the number of no triangle: they are numbered from 1 to {count}.", values);
  return isTriangle(*at.chosen) ? std::string()
                                : words("{i} is the number of a triangle without an area.", values);
}

/// What the ray comes to before its first hit although that is no hit; empty where there is nothing.
std::string wordsBefore(const In &in, const Out &at) {
  if (!at.nearest || !at.along || at.along->passage.begin >= at.first.t)
    return {};
  const WordValues values{{"fragment", nameOf(in.meshes, at.along->fragment)}};
  return at.along->passage.begin < at.along->passage.end
             ? words("Before, it runs along {fragment}, in its plane, and that does not count as a hit.",
                     values)
             : words("Before, it touches {fragment} within its plane, and that does not count as a hit.",
                     values);
}

CaseWords tellNearest(const In &in, const Out &at) {
  if (isDegenerate(in))
    return zeroDirectionWords(at);
  if (!at.nearest)
    return tellMiss(in, at);
  const int ties = tieCount(at);
  const WordValues found{{"fragment", nameOf(in.meshes, at.nearest->fragment)},
                         {"lambda", equation(at.lambda)},
                         {"others", std::to_string(ties - 1)}};
  switch (ties) {
  case 1:
    return {"hit", words("The ray hits {fragment} first, at {lambda}.", found)};
  case 2:
    return {"hit", words("The ray hits {fragment} and one other first, both at {lambda}.", found)};
  default:
    return {"hit", words("The ray hits {fragment} and {others} others first, all at {lambda}.", found)};
  }
}

CaseWords tell(const In &in, const Out &at) {
  CaseWords told = tellNearest(in, at);
  for (const std::string &more : {wordsBefore(in, at), chosenWords(in, at)})
    if (!more.empty())
      told.description = words("{told} {more}", {{"told", told.description}, {"more", more}});
  return told;
}

std::string meshValue(std::size_t place) { return "mesh" + std::to_string(place); }

std::string wordForFirst(const Out &at) {
  if (!at.nearest)
    return at.along ? "in-plane" : "none";
  return at.first.fragments.size() > 1 ? "several" : meshValue(at.nearest->fragment.mesh);
}

int countOf(const Out &at, RayTriangleCase which) {
  return static_cast<int>(std::count_if(at.listed.begin(), at.listed.end(), [which](const Meeting &meeting) {
    return meeting.meet.which == which;
  }));
}

/// The nearest hit among those asked up to the chosen one; null where there is none, or too many to ask.
const Meeting *nearestSoFar(const Out &at) {
  if (!areAllListed(at))
    return nullptr;
  const Meeting *nearest = nullptr;
  for (const Meeting &meeting : at.listed)
    if (at.chosen && meeting.number <= at.chosen->number && isHit(meeting) &&
        (!nearest || isNearer(meeting, *nearest)))
      nearest = &meeting;
  return nearest;
}

std::vector<NamedValue> valuesOf(const In &in, const Out &at) {
  std::vector<NamedValue> values{{"fragments", words("triangles"), static_cast<int>(at.fragments)}};
  if (isDegenerate(in))
    return values;
  values.push_back({"first", {}, wordForFirst(at)});
  if (at.nearest) {
    values.push_back({"nearest", words("number of the nearest"), static_cast<int>(at.nearest->number)});
    values.push_back(listed("lambda", at.lambda));
    values.push_back(listed("point", at.H));
    values.push_back({"location", words("place"), std::string(nameOf(at.nearest->meet.location.part))});
  }
  if (areAllListed(at)) {
    values.push_back({"hits", words("hits"), countOf(at, RayTriangleCase::Hit)});
    values.push_back({"behind", words("hits behind the start"), countOf(at, RayTriangleCase::Behind)});
    if (at.nearest)
      values.push_back({"ties", words("hit at the smallest λ"), tieCount(at)});
    if (const Meeting *soFar = nearestSoFar(at)) {
      values.push_back({"so_far", words("nearest so far"), static_cast<int>(soFar->number)});
      values.push_back(
          {"so_far_is_nearest", {}, std::string(soFar->number == at.nearest->number ? "yes" : "no")});
    }
  }
  if (at.chosen)
    values.push_back(
        {"chosen",
         {},
         std::vector<NamedValue>{{"case", words("case"), std::string(nameOf(at.chosen->meet.which))}}});
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  std::vector<MadeObject> made;
  if (at.nearest)
    made.push_back({"H", PointObject{at.nearest->meet.plane.point}});
  if (at.chosen && isTriangle(*at.chosen)) {
    const auto &[p0, p1, p2] = at.chosen->triangle;
    made.push_back({"T", TriangleObject{p0, p1, p2}});
  }
  return made;
}

/// The hits and those behind the start, in their order.
std::vector<const Meeting *> crossed(const Out &at) {
  std::vector<const Meeting *> all;
  for (const Meeting &meeting : at.listed)
    if (meeting.meet.which == RayTriangleCase::Hit || meeting.meet.which == RayTriangleCase::Behind)
      all.push_back(&meeting);
  std::sort(all.begin(), all.end(), [](const Meeting *a, const Meeting *b) { return isNearer(*a, *b); });
  return all;
}

Term parameterOf(const Meeting &meeting, const Out &at) {
  return name(at.own(letter("λ", std::to_string(meeting.number))), meeting.meet.plane.t)
      .standingFor(crossingTerm(at, meeting.triangle));
}

WorkingLine orderLine(const Out &at) {
  std::vector<Chain> order;
  for (const Meeting *meeting : crossed(at))
    order.push_back(withResult(parameterOf(*meeting, at)));
  return line(
      std::move(order),
      at.nearest
          ? words("In their order, each with the number of its triangle. The ray stops at the first one "
                  "that is 0 or more.")
          : words("In their order, each with the number of its triangle. None is 0 or more, so none is a "
                  "hit."));
}

/// A corner as the mesh has it, from where the mesh stands.
WorkingLine cornerLine(const In &in, const Meeting &chosen, const std::string &coordinate,
                       const ExactVec3 &corner) {
  const auto &mesh = in.meshes[chosen.fragment.mesh];
  const ExactVec3 way = corner - mesh.object.place;
  const Term P = coordinateTerm(mesh, 0);
  return asked(withNumbers(madeName(in, "T", coordinate, corner) == P + list({way.x, way.y, way.z})),
               words("A corner of the triangle, as seen from {P}.", {{"P", plainText(P)}}));
}

std::array<std::pair<const char *, ExactVec3>, 3> cornersOf(const Meeting &meeting) {
  const auto &[p0, p1, p2] = meeting.triangle;
  return {{{"P0", p0}, {"P1", p1}, {"P2", p2}}};
}

Explanation explain(const In &in, const Out &at) {
  Explanation lines;
  if (at.chosen && isTriangle(*at.chosen))
    for (const auto &[coordinate, corner] : cornersOf(*at.chosen))
      lines.add(coordinate, [&in, &at, coordinate = coordinate, corner = corner] {
        return cornerLine(in, *at.chosen, coordinate, corner);
      });
  if (isDegenerate(in))
    return lines;
  if (const auto hits = crossed(at); areAllListed(at) && !hits.empty() && hits.size() <= mostOrdered)
    lines.add("order", [&at] { return orderLine(at); });
  if (at.nearest)
    lines.add("hit", [&at] {
      return asked(withNumbers(at.H == at.Q + at.lambda * at.r),
                   words("The smallest λ ≥ 0 of all hits, put into the ray."));
    });
  return lines;
}

PolygonMark faceOf(std::string id, Role role, Subject subject, const Triangle<Rational> &triangle) {
  return {{std::move(id), role, subject}, {place(triangle.p0), place(triangle.p1), place(triangle.p2)}};
}

/// Its corners have the letters of the triangle that later entries look at.
void drawChosen(Figure &figure, const In &in, const Meeting &chosen) {
  figure.add(faceOf(in.mark("T"), Role::Derived, Subject::EdgeU, chosen.triangle));
  for (const auto &[coordinate, at] : cornersOf(chosen))
    figure.add(pointOf(madeName(in, "T", coordinate, at), Role::Derived, Subject::Triangle));
}

std::string hitMark(const In &in, const Meeting &meeting) {
  return in.mark("hits") + "/" + std::to_string(meeting.number);
}

/// The way back from the start to the farthest of those that lie behind it.
void drawWayBack(Figure &figure, const In &in, const Out &at) {
  const Meeting *farthest = nullptr;
  for (const Meeting &meeting : at.listed)
    if (meeting.meet.which == RayTriangleCase::Behind && (!farthest || isNearer(meeting, *farthest)))
      farthest = &meeting;
  if (farthest)
    figure.add(SegmentMark{{in.mark("H") + "/back", Role::Ghost, Subject::Ray},
                           place(farthest->meet.plane.point),
                           place(in.L.object.origin)});
}

/// The hits that come later, and those behind the start.
void drawOthers(Figure &figure, const In &in, const Out &at) {
  for (const Meeting &meeting : at.listed) {
    if (at.nearest && meeting.number == at.nearest->number)
      continue;
    const Place point = place(meeting.meet.plane.point);
    if (isHit(meeting))
      figure.add(PointMark{{hitMark(in, meeting), Role::Derived, Subject::Ray}, point});
    else if (meeting.meet.which == RayTriangleCase::Behind)
      figure.add(PointMark{
          {in.mark("H") + "/behind" + std::to_string(meeting.number), Role::Ghost, Subject::Ray}, point});
  }
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (at.chosen && isTriangle(*at.chosen))
    drawChosen(figure, in, *at.chosen);
  drawOthers(figure, in, at);
  drawWayBack(figure, in, at);
  if (!at.nearest)
    return figure;
  figure.add(faceOf(in.mark("nearest"), Role::Result, Subject::Measure, at.nearest->triangle));
  figure.add(pointOf(at.H, Role::Result, Subject::Ray));
  figure.reaches.push_back({in.L.id, place(at.H)});
  return figure;
}

std::vector<SpecialCase> nearby(const In &, const Out &) { return {}; }

Crossing crossingOf(const In &in, const Out &at, const Meeting &meeting) {
  Crossing crossing{meeting.number, nameOf(in.meshes, meeting.fragment), meeting.meet.which, {}};
  const bool isNearest = at.nearest && at.nearest->number == meeting.number;
  if (meeting.meet.crosses())
    crossing.at = {meeting.meet.plane.t, meeting.meet.s, meeting.meet.tTriangle};
  crossing.marks = {markOf(in.meshes[meeting.fragment.mesh], meeting.fragment.index)};
  if (isHit(meeting))
    crossing.marks.push_back(isNearest ? in.mark("H") : hitMark(in, meeting));
  return crossing;
}

Crossings cross(const In &in, const Out &at) {
  Crossings crossings;
  crossings.fragments = at.fragments;
  for (const Meeting &meeting : at.listed)
    crossings.all.push_back(crossingOf(in, at, meeting));
  std::stable_sort(crossings.all.begin(), crossings.all.end(), [](const Crossing &a, const Crossing &b) {
    return a.at && b.at ? a.at->t < b.at->t : a.at.has_value() && !b.at;
  });
  if (at.nearest)
    crossings.nearest = at.nearest->number;
  if (at.chosen)
    crossings.chosen = at.chosen->number;
  crossings.choice = in.i.id;
  if (const Meeting *soFar = nearestSoFar(at))
    crossings.nearestSoFar = soFar->number;
  return crossings;
}

/// The names of all that it can come to with so many meshes as there may be.
ConstructionNames names() {
  std::vector<std::string> firstWords{"none", "several", "in-plane"};
  for (std::size_t i = 0; i < maxListedObjects; ++i)
    firstWords.push_back(meshValue(i));
  return {.cases = {"hit", "miss", "in-plane", "zero-direction"},
          .values = {named::index("fragments"), named::word("first", std::move(firstWords)),
                     named::index("nearest"), named::number("lambda"), named::vector("point"),
                     named::index("hits"), named::index("behind"), named::index("ties"),
                     named::index("so_far"), named::word("so_far_is_nearest", {"yes", "no"}),
                     named::word("location", {"interior", "edge", "vertex"}),
                     named::group("chosen", {named::word("case", {"hit", "behind", "miss", "parallel",
                                                                  "in-plane", "coincident", "collinear"})})},
          .lines = {"P0", "P1", "P2", "order", "hit"},
          .marks = {"H", "nearest", "T", "T.P0", "T.P1", "T.P2", "hits"}};
}

} // namespace

Construction nearest_hit() {
  return makeConstruction<In, Out, RayObject, NumberObject, Several<MeshObject>>(
      "nearest-hit", {"L", "i", "meshes"}, {{"H", "point"}, {"T", "triangle"}}, {"λH"}, names(),
      {compute, tell, valuesOf, make, explain, draw, nearby, cross});
}

} // namespace halfspace
