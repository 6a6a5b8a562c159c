// Which of many triangles a ray hits first: the one with the smallest parameter that is not negative (note
// PG 7). The ray's parameter is λ here, because s and t belong to the triangles.
#include "lessons/construction/parts/fragment_meetings.h"
#include "lessons/construction/parts/place_rows.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/triangle.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// So many parameters at most are written down in their order.
constexpr std::size_t mostOrdered = 6;

struct In : Naming {
  Given<RayObject> L;
  Given<NumberObject> i; ///< the number of the fragment that is looked at, or none
  GivenMeshes meshes;
};

/// The number that stands for a fragment; nothing where it stands for none.
std::optional<std::size_t> chosenNumber(const Rational &i, std::size_t count) {
  if (i < 1 || i > Rational(static_cast<std::int64_t>(count)) || i.denominator() != 1)
    return {};
  return static_cast<std::size_t>(toDouble(i));
}

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  bool hasRay = !isZero(in.L.object.direction);
  std::size_t fragments = fragmentCount(in.meshes);
  Placements placements = placementsOf(in.meshes);
  std::optional<std::size_t> number = chosenNumber(in.i.object.value, fragments);
  std::optional<Meeting> chosen =
      number ? std::optional(meetingWith(in.L.object, in.meshes, placements, *number)) : std::nullopt;
  bool hasTriangle = chosen && chosen->isTriangle(); ///< that is looked at
  FirstHits first = hasRay ? firstHits(in.L.object, in.meshes) : FirstHits();
  bool isHit = !first.fragments.empty();
  std::optional<Meeting> nearest =
      isHit ? std::optional(meetingWith(in.L.object, in.meshes, placements,
                                        numberOf(in.meshes, first.fragments.front())))
            : std::nullopt;
  std::vector<Meeting> listed = hasRay ? listedMeetings(in.L.object, in.meshes, placements, {nearest, chosen})
                                       : std::vector<Meeting>(); ///< by number
  bool areAllListed = listed.size() == fragments;
  /// The first of those listed that the ray lies in.
  std::optional<Passage> along = firstAlong(in.L.object, listed);

  Term named = ownName(letter("λ", "H"), first.t);
  Term lambda = isHit ? named.standingFor(crossingTerm(*this, nearest->triangle)) : named;
  Term H = madeName("H", isHit ? nearest->meet.plane.point : in.L.object.origin);
};

template <class Condition> std::size_t countWhere(const Out &at, const Condition &isSo) {
  return static_cast<std::size_t>(std::count_if(at.listed.begin(), at.listed.end(), isSo));
}

/// How many of those that are listed are hit at the smallest λ.
std::size_t tieCount(const Out &at) {
  return countWhere(at, [&](const Meeting &each) { return each.isHit() && each.meet.plane.t == at.first.t; });
}

CaseWords tellMiss(const Out &at) {
  if (at.along) {
    const WordValues values{{"fragment", nameOf(at.in.meshes, at.along->fragment)}};
    return {"in-plane",
            at.along->begin < at.along->end
                ? words("The ray runs along {fragment}, in its plane: it hits no triangle at a single point.",
                        values)
                : words("The ray touches {fragment} at one point, within its plane, and that does not count "
                        "as a hit. It hits no triangle.",
                        values)};
  }
  if (at.areAllListed)
    return {"miss", words("No triangle has a hit with λ ≥ 0: the ray meets nothing.")};
  return {"miss", words("No triangle has a hit with λ ≥ 0. Whether the ray lies in the plane of one and runs "
                        "along it is not looked at: there are more than {most} triangles.",
                        {{"most", std::to_string(mostListedFragments)}})};
}

/// Why the triangle that is looked at is none; empty where it is one.
std::string chosenWords(const Out &at) {
  const WordValues values{{"i", equation(coordinateTerm(at.in.i, 0))},
                          {"count", std::to_string(at.fragments)}};
  if (!at.chosen)
    return words("{i} is the number of no triangle: they are numbered from 1 to {count}.", values);
  return at.chosen->isTriangle() ? std::string()
                                 : words("{i} is the number of a triangle without an area.", values);
}

/// What the ray comes to before its first hit although that is no hit; empty where there is nothing.
std::string wordsBefore(const Out &at) {
  if (!at.isHit || !at.along || at.along->begin >= at.first.t)
    return {};
  const WordValues values{{"fragment", nameOf(at.in.meshes, at.along->fragment)}};
  return at.along->begin < at.along->end
             ? words("Before, it runs along {fragment}, in its plane, and that does not count as a hit.",
                     values)
             : words("Before, it touches {fragment} within its plane, and that does not count as a hit.",
                     values);
}

CaseWords tellNearest(const Out &at) {
  if (!at.hasRay)
    return zeroDirectionWords(at);
  if (!at.nearest)
    return tellMiss(at);
  const std::size_t ties = tieCount(at);
  const WordValues found{{"fragment", nameOf(at.in.meshes, at.nearest->fragment)},
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

CaseWords tell(const Out &at) {
  CaseWords told = tellNearest(at);
  for (const std::string &more : {wordsBefore(at), chosenWords(at)})
    if (!more.empty())
      told.description = words("{told} {more}", {{"told", told.description}, {"more", more}});
  return told;
}

std::string meshValue(std::size_t place) { return "mesh" + std::to_string(place); }

Word wordForFirst(const Out &at) {
  if (!at.nearest)
    return at.along ? Word{"in-plane", words("in its plane")} : noneOfThem();
  const std::size_t mesh = at.nearest->fragment.mesh;
  return at.first.fragments.size() > 1 ? severalOfThem()
                                       : Word{meshValue(mesh), plainText(at.in.meshes[mesh].symbol)};
}

std::size_t countOf(const Out &at, RayTriangleCase which) {
  return countWhere(at, [which](const Meeting &each) { return each.meet.which == which; });
}

/// The nearest hit among those asked up to the chosen one; null where there is none, or too many to ask.
const Meeting *nearestSoFar(const Out &at) {
  if (!at.areAllListed)
    return nullptr;
  const Meeting *nearest = nullptr;
  for (const Meeting &meeting : at.listed)
    if (at.chosen && meeting.number <= at.chosen->number && meeting.isHit() &&
        (!nearest || isNearer(meeting, *nearest)))
      nearest = &meeting;
  return nearest;
}

/// The hits and those behind the start, in their order.
std::vector<const Meeting *> crossed(const Out &at) {
  std::vector<const Meeting *> all;
  for (const Meeting &meeting : at.listed)
    if (meeting.isHit() || meeting.isBehind())
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

std::array<std::pair<const char *, ExactVec3>, 3> cornersOf(const Meeting &meeting) {
  const auto &[p0, p1, p2] = meeting.triangle;
  return {{{"P0", p0}, {"P1", p1}, {"P2", p2}}};
}

/// A corner as the mesh has it, from where the mesh stands.
WorkingLine cornerLine(const Out &at, std::size_t index) {
  const auto &mesh = at.in.meshes[at.chosen->fragment.mesh];
  const auto [coordinate, corner] = cornersOf(*at.chosen).at(index);
  const ExactVec3 way = corner - mesh.object.place;
  const Term P = coordinateTerm(mesh, 0);
  return asked(withNumbers(at.madeName("T", coordinate, corner) == P + list({way.x, way.y, way.z})),
               words("A corner of the triangle, as seen from {P}.", {{"P", plainText(P)}}));
}

bool isOrdered(const Out &at) {
  const std::size_t hits = crossed(at).size();
  return at.hasRay && at.areAllListed && hits > 0 && hits <= mostOrdered;
}

PolygonMark faceOf(std::string id, Role role, Subject subject, const Triangle<Rational> &triangle) {
  return {{std::move(id), role, subject}, {place(triangle.p0), place(triangle.p1), place(triangle.p2)}};
}

/// Its corners have the letters of the triangle that later entries look at.
void drawChosen(Figure &figure, const Out &at) {
  figure.add(faceOf(at.mark("T"), Role::Derived, Subject::EdgeU, at.chosen->triangle));
  for (const auto &[coordinate, corner] : cornersOf(*at.chosen))
    figure.add(pointOf(at.madeName("T", coordinate, corner), Role::Derived, Subject::Triangle));
}

std::string hitMark(const In &in, const Meeting &meeting) {
  return in.mark("hits") + "/" + std::to_string(meeting.number);
}

/// The way back from the start to the farthest of those that lie behind it.
void drawWayBack(Figure &figure, const Out &at) {
  const Meeting *farthest = nullptr;
  for (const Meeting &meeting : at.listed)
    if (meeting.isBehind() && (!farthest || isNearer(meeting, *farthest)))
      farthest = &meeting;
  if (farthest)
    figure.add(SegmentMark{{at.mark("H") + "/back", Role::Ghost, Subject::Ray},
                           place(farthest->meet.plane.point),
                           place(at.in.L.object.origin)});
}

/// The hits that come later, and those behind the start.
void drawOthers(Figure &figure, const Out &at) {
  for (const Meeting &meeting : at.listed) {
    if (at.nearest && meeting.number == at.nearest->number)
      continue;
    const Place point = place(meeting.meet.plane.point);
    if (meeting.isHit())
      figure.add(PointMark{{hitMark(at.in, meeting), Role::Derived, Subject::Ray}, point});
    else if (meeting.isBehind())
      figure.add(PointMark{
          {at.mark("H") + "/behind" + std::to_string(meeting.number), Role::Ghost, Subject::Ray}, point});
  }
}

Figure draw(const Out &at) {
  Figure figure;
  if (at.hasTriangle)
    drawChosen(figure, at);
  drawOthers(figure, at);
  drawWayBack(figure, at);
  if (!at.nearest)
    return figure;
  figure.add(faceOf(at.mark("nearest"), Role::Result, Subject::Measure, at.nearest->triangle));
  figure.add(pointOf(at.H, Role::Result, Subject::Ray));
  figure.reaches.push_back({at.in.L.id, place(at.H)});
  return figure;
}

Crossing crossingOf(const Out &at, const Meeting &meeting) {
  Crossing crossing{meeting.number, nameOf(at.in.meshes, meeting.fragment), meeting.meet.which, {}};
  const bool isNearest = at.nearest && at.nearest->number == meeting.number;
  if (meeting.meet.crosses())
    crossing.at = {meeting.meet.plane.t, meeting.meet.s, meeting.meet.tTriangle};
  crossing.marks = {markOf(at.in.meshes[meeting.fragment.mesh], meeting.fragment.index)};
  if (meeting.isHit())
    crossing.marks.push_back(isNearest ? at.mark("H") : hitMark(at.in, meeting));
  return crossing;
}

Crossings crossingsOf(const Out &at) {
  Crossings crossings;
  crossings.fragments = at.fragments;
  for (const Meeting &meeting : at.listed)
    crossings.all.push_back(crossingOf(at, meeting));
  std::stable_sort(crossings.all.begin(), crossings.all.end(), [](const Crossing &a, const Crossing &b) {
    return a.at && b.at ? a.at->t < b.at->t : a.at.has_value() && !b.at;
  });
  if (at.nearest)
    crossings.nearest = at.nearest->number;
  if (at.chosen)
    crossings.chosen = at.chosen->number;
  crossings.choice = at.in.i.id;
  if (const Meeting *soFar = nearestSoFar(at))
    crossings.nearestSoFar = soFar->number;
  return crossings;
}

Object chosenTriangle(const Out &at) {
  const auto &[p0, p1, p2] = at.chosen->triangle;
  return TriangleObject{p0, p1, p2};
}

LineTable<Out> lines() {
  const auto corner = [](std::size_t index) {
    return [index](const Out &at) { return cornerLine(at, index); };
  };
  return {{"P0", &Out::hasTriangle, corner(0)},
          {"P1", &Out::hasTriangle, corner(1)},
          {"P2", &Out::hasTriangle, corner(2)},
          {"order", isOrdered, orderLine},
          {"hit", &Out::isHit, [](const Out &at) { return withNumbers(at.H == at.Q + at.lambda * at.r); },
           says("The smallest λ ≥ 0 of all hits, put into the ray.")}};
}

/// A count that people read.
ValueRow<Out> countRow(const char *name, When<Out> stands, Sentence label,
                       std::function<std::size_t(const Out &)> count) {
  return {named::index(name), std::move(stands), [label, count](const Out &at) {
            return ToldValue(words(label.english), static_cast<int>(count(at)));
          }};
}

Word soFarWord(const Out &at) { return yesOrNo(nearestSoFar(at)->number == at.nearest->number); }

ValueTable<Out> values() {
  std::vector<std::string> firstWords{"none", "several", "in-plane"};
  for (std::size_t i = 0; i < maxListedObjects; ++i)
    firstWords.push_back(meshValue(i));
  const When<Out> areCounted = [](const Out &at) { return at.hasRay && at.areAllListed; };
  const When<Out> hasSoFar = [](const Out &at) { return at.hasRay && nearestSoFar(at); };
  return {
      countRow("fragments", always, says("triangles"), [](const Out &at) { return at.fragments; }),
      {named::word("first", firstWords), &Out::hasRay, [](const Out &at) { return Value(wordForFirst(at)); }},
      countRow("nearest", &Out::isHit, says("number of the nearest"),
               [](const Out &at) { return at.nearest->number; }),
      {named::number("lambda"), &Out::isHit, &Out::lambda},
      {named::vector("point"), &Out::isHit, &Out::H},
      {named::word("location", {"interior", "edge", "vertex"}), &Out::isHit,
       [](const Out &at) { return ToldValue(words("place"), wordOf(at.nearest->meet.location.part)); }},
      countRow("hits", areCounted, says("hits"),
               [](const Out &at) { return countOf(at, RayTriangleCase::Hit); }),
      countRow("behind", areCounted, says("hits behind the start"),
               [](const Out &at) { return countOf(at, RayTriangleCase::Behind); }),
      countRow(
          "ties", [](const Out &at) { return at.isHit && at.areAllListed; }, says("hit at the smallest λ"),
          tieCount),
      countRow("so_far", hasSoFar, says("nearest so far"),
               [](const Out &at) { return nearestSoFar(at)->number; }),
      {named::word("so_far_is_nearest", {"yes", "no"}), hasSoFar,
       [](const Out &at) { return Value(soFarWord(at)); }},
      valueGroup<Out>(
          "chosen", [](const Out &at) { return at.hasRay && at.chosen; },
          {{named::word("case", {"hit", "behind", "miss", "parallel", "in-plane", "coincident", "collinear"}),
            always, [](const Out &at) { return ToldValue(words("case"), wordOf(at.chosen->meet.which)); }}})};
}

} // namespace

Construction nearest_hit() {
  return taught<Out, RayObject, NumberObject, Several<MeshObject>>(
      {.id = "nearest-hit",
       .title = [] { return words("nearest hit"); },
       .roles = {"L", "i", "meshes"},
       .makes = {{"H", &Out::isHit, &Out::H}, {"T", TriangleObject::kind, &Out::hasTriangle, chosenTriangle}},
       .letters = {"λH"},
       .cases = {"hit", "miss", "in-plane", "zero-direction"},
       .values = values(),
       .lines = lines(),
       .marks = {"H", "nearest", "T", "T.P0", "T.P1", "T.P2", "hits"},
       .tell = tell,
       .draw = draw,
       .cross = crossingsOf});
}

} // namespace halfspace
