// Which of several planes a ray meets first: the ray's points put into each plane's equation (note PG 4).
#include "geometry/case_names.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

struct In : Naming {
  std::vector<Given<PlaneObject>> planes;
  Given<RayObject> L;
};

/// One of the planes, and where the ray's line meets it.
struct Meeting : PlaneTerms {
  std::string id;
  std::string name; ///< in plain text
  RayPlane<Rational> meet;
  Term d, t, H;
  Term slope; ///< of the equation slope·t + rest = 0
  Term rest;
};

struct Out : Naming, RayTerms {
  std::vector<Meeting> meetings;
  std::vector<std::size_t> first; ///< the places of the planes that are hit first, all with the same t
  Term H;
};

Symbol ofPlane(Symbol symbol, const Given<PlaneObject> &plane) {
  symbol.owner = plane.id;
  return symbol;
}

Meeting meetingWith(const Given<PlaneObject> &given, std::size_t place, const In &in) {
  const auto &[point, normal] = given.object;
  const auto plane = planeThrough(point, normal);
  const auto meet = intersectRayPlane(Ray<Rational>{in.L.object.origin, in.L.object.direction}, plane);
  const PlaneTerms letters = termsOf(given);
  const RayTerms ray = termsOf(in.L);
  const Term d = name(ofPlane(letter("d"), given), plane.offset).standingFor(-dot(letters.n, letters.P0));
  const Term slope = dot(letters.n, ray.r);
  const Term rest = dot(letters.n, ray.Q) + d;
  const Term t = name(ofPlane(letter("t"), given), meet.t);
  return {letters,
          given.id,
          plainText(given.symbol),
          meet,
          d,
          meet.crosses() ? t.standingFor(-rest / slope) : t,
          name(ofPlane(letter("H"), given), meet.point).marked(in.mark("H" + std::to_string(place))),
          slope,
          rest};
}

/// The planes with the smallest t that is not negative.
std::vector<std::size_t> firstOf(const std::vector<Meeting> &meetings) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const auto &meet = meetings[i].meet;
    if (meet.which != RayPlaneCase::Hit)
      continue;
    if (!first.empty() && meet.t < meetings[first.front()].meet.t)
      first.clear();
    if (first.empty() || meet.t == meetings[first.front()].meet.t)
      first.push_back(i);
  }
  return first;
}

Out compute(const In &in) {
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < in.planes.size(); ++i)
    meetings.push_back(meetingWith(in.planes[i], i, in));
  std::vector<std::size_t> first = firstOf(meetings);
  const Term H =
      madeName(in, "H", first.empty() ? ExactVec3(in.L.object.origin) : meetings[first.front()].meet.point);
  return {in, termsOf(in.L), std::move(meetings), std::move(first), H};
}

/// The meeting whose plane is hit first, the one with the smallest place; null where none is hit.
const Meeting *firstMeeting(const Out &at) {
  return at.first.empty() ? nullptr : &at.meetings[at.first.front()];
}

/// What is no plane, or null.
const Meeting *withoutNormal(const Out &at) {
  const auto found = std::find_if(at.meetings.begin(), at.meetings.end(), [](const Meeting &meeting) {
    return meeting.meet.which == RayPlaneCase::ZeroNormal;
  });
  return found == at.meetings.end() ? nullptr : &*found;
}

bool isDegenerate(const Out &at) {
  return withoutNormal(at) || at.meetings.front().meet.which == RayPlaneCase::ZeroDirection;
}

/// The places of all planes that the ray meets as `isSo` says.
template <class Condition> std::vector<std::size_t> placesWhere(const Out &at, const Condition &isSo) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < at.meetings.size(); ++i)
    if (isSo(at.meetings[i].meet))
      places.push_back(i);
  return places;
}

std::vector<std::size_t> placesOf(RayPlaneCase which, const Out &at) {
  return placesWhere(at, [which](const auto &meet) { return meet.which == which; });
}

/// Whether the whole ray lies in one of the planes.
bool liesInPlane(const Out &at) { return !placesOf(RayPlaneCase::InPlane, at).empty(); }

/// “E and F”, “E, F and G”
std::string namesOf(const std::vector<std::size_t> &places, const Out &at) {
  std::string all = at.meetings[places.front()].name;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const bool isLast = i + 1 == places.size();
    const WordValues both{{"before", all}, {"last", at.meetings[places[i]].name}};
    all = isLast ? words("{before} and {last}", both) : words("{before}, {last}", both);
  }
  return all;
}

/// Of a ray that hits one plane or several.
std::string hitWords(const Out &at) {
  // Which plane, or which of them first, is the learner's to find.
  if (placesOf(RayPlaneCase::Hit, at).size() == 1)
    return liesInPlane(at) ? words("It hits another plane at a single point: one t is 0 or more.")
                           : words("One plane has a t of 0 or more: the ray hits this one and no other.");
  if (at.first.size() > 1)
    return words("{planes} have the same t ({t}): the ray hits them at one point.",
                 {{"planes", namesOf(at.first, at)}, {"t", equation(firstMeeting(at)->t)}});
  return words("More than one plane has a t of 0 or more: the smallest of these tells which is hit first.");
}

CaseWords tell(const In &, const Out &at) {
  if (const Meeting *none = withoutNormal(at))
    return {std::string(nameOf(RayPlaneCase::ZeroNormal)),
            words("The normal {n} is the zero vector: it points nowhere, so {plane} is no plane.",
                  {{"n", plainText(none->n)}, {"plane", none->name}}),
            true};
  if (isDegenerate(at))
    return zeroDirectionWords(at);
  const std::vector<std::size_t> inside = placesOf(RayPlaneCase::InPlane, at);
  if (inside.empty())
    return at.first.empty()
               ? CaseWords{"miss", words("No plane has a t of 0 or more: the ray meets none of them.")}
               : CaseWords{"hit", hitWords(at)};
  const std::string planes = namesOf(inside, at);
  return at.first.empty()
             ? CaseWords{"in-plane",
                         words("The whole ray lies in {planes}. It hits no plane at a single point.",
                               {{"planes", planes}})}
             : CaseWords{"hit", words("The whole ray lies in {planes}. {hit}",
                                      {{"planes", planes}, {"hit", hitWords(at)}})};
}

std::string planeValue(std::size_t place) { return "plane" + std::to_string(place); }

std::vector<NamedValue> valuesOfPlane(const Meeting &meeting) {
  std::vector<NamedValue> values{{"case", meeting.name, std::string(nameOf(meeting.meet.which))}};
  if (meeting.meet.crosses()) {
    values.push_back(listed("t", meeting.t));
    values.push_back(listed("point", meeting.H));
  }
  return values;
}

std::string wordForFirst(const Out &at) {
  if (at.first.empty())
    return liesInPlane(at) ? "in-plane" : "none";
  return at.first.size() > 1 ? "several" : planeValue(at.first.front());
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (isDegenerate(at))
    return {};
  std::vector<NamedValue> values{{"first", {}, wordForFirst(at)}};
  if (const Meeting *first = firstMeeting(at)) {
    values.push_back(listed("t", first->t));
    values.push_back(listed("point", at.H));
  }
  for (std::size_t i = 0; i < at.meetings.size(); ++i)
    values.push_back({planeValue(i), {}, valuesOfPlane(at.meetings[i])});
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (isDegenerate(at) || at.first.empty())
    return {};
  return {{"H", PointObject{firstMeeting(at)->meet.point}}};
}

WorkingLine rayLine(const Out &at) {
  const Term point = at.Q + unknown("t") * at.r;
  return line(Chain(point).then(namesPutIn(point)).then(calculated(point)),
              words("The ray's points: all their coordinates follow from the one number t."));
}

WorkingLine equationLine(const Meeting &meeting) {
  const Term left = dot(meeting.n, anyPoint()) + meeting.d;
  return line(condition((0 == left).then(calculated(left))),
              words("The equation of {plane}, with {d} = −{n}·{P0}.", {{"plane", meeting.name},
                                                                       {"d", plainText(meeting.d)},
                                                                       {"n", plainText(meeting.n)},
                                                                       {"P0", plainText(meeting.P0)}}));
}

std::string substituteWords(const Meeting &meeting) {
  const WordValues plane{{"plane", meeting.name}};
  switch (meeting.meet.which) {
  case RayPlaneCase::Parallel:
    return words("t drops out, and what is left is wrong for every t: the ray never meets {plane}.", plane);
  case RayPlaneCase::InPlane:
    return words("t drops out, and 0 = 0 is true for every t: the whole ray lies in {plane}.", plane);
  default:
    return words("The ray's coordinates put into the equation of {plane}, then collected. One unknown is "
                 "left: t.",
                 plane);
  }
}

WorkingLine substituteLine(const Meeting &meeting, const Out &at) {
  const Term inserted = dot(meeting.n, at.Q + unknown("t") * at.r) + meeting.d;
  return askedEquation(condition((0 == inserted).then(multipliedOut(inserted)).then(calculated(inserted))),
                       substituteWords(meeting));
}

/// The equation slope·t + rest = 0 solved.
WorkingLine parameterLine(const Meeting &meeting) {
  const Term slope = calculated(meeting.slope);
  const Term rest = calculated(meeting.rest);
  const Term solved = calculated(-meeting.rest) / slope;
  const bool isNegative = meeting.meet.t < 0;
  return asked(
      Chain(meeting.t).then(solved).then(calculated(solved)),
      isNegative ? words("Negative: only the line backwards meets {plane}. It is behind the start.",
                         {{"plane", meeting.name}})
                 : words("Not negative: the ray meets {plane} at this t.", {{"plane", meeting.name}}),
      {{rest / slope,
        words("{answer} has the wrong sign: the number without t changes its sign when it goes to the other "
              "side.")},
       {slope / solved->parts.front(), words("{answer} is upside down: divide by the number before t.")},
       {slope / rest, words("{answer} is upside down: divide by the number before t.")},
       {-rest, words("{answer} is not divided yet by the number before t.")}});
}

std::string orderWords(const Out &at) {
  if (!at.first.empty())
    return words("In their order. The first one that is 0 or more tells what the ray hits first.");
  return liesInPlane(at)
             ? words("In their order. None is 0 or more, so the ray hits no plane at a single point.")
             : words("In their order. None is 0 or more, so the ray meets no plane.");
}

/// Which planes the order leaves out.
std::string leftOutWords(const Out &at) {
  const auto without = placesWhere(at, [](const auto &meet) { return !meet.crosses(); });
  return without.empty() ? ""
                         : " " + words("There is no t for {planes}.", {{"planes", namesOf(without, at)}});
}

/// The parameters and 0 in their order, by their names and by their numbers.
WorkingLine orderLine(const Out &at) {
  std::vector<std::pair<Rational, Term>> parameters{{0, Term(0)}};
  for (const Meeting &meeting : at.meetings)
    if (meeting.meet.crosses())
      parameters.emplace_back(meeting.meet.t, meeting.t);
  std::stable_sort(parameters.begin(), parameters.end(),
                   [](const auto &a, const auto &b) { return a.first < b.first; });
  std::vector<Term> names;
  std::vector<Term> numbers;
  for (const auto &[value, name] : parameters) {
    names.push_back(name);
    numbers.push_back(namesPutIn(name));
  }
  return line({inOrder(std::move(names)), inOrder(std::move(numbers))}, orderWords(at) + leftOutWords(at));
}

WorkingLine hitLine(const Out &at) {
  return asked(withNumbers(at.H == at.Q + at.meetings.at(at.first.front()).t * at.r),
               words("The smallest t that is not negative, put into the ray."));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (isDegenerate(at))
    return lines;
  lines.add("ray", [&at] { return rayLine(at); });
  for (std::size_t i = 0; i < at.meetings.size(); ++i) {
    const Meeting &meeting = at.meetings[i];
    const std::string place = std::to_string(i);
    lines.add("equation" + place, [&meeting] { return equationLine(meeting); });
    lines.add("substitute" + place, [&meeting, &at] { return substituteLine(meeting, at); });
    if (meeting.meet.crosses())
      lines.add("t" + place, [&meeting] { return parameterLine(meeting); });
  }
  if (std::any_of(at.meetings.begin(), at.meetings.end(),
                  [](const Meeting &meeting) { return meeting.meet.crosses(); }))
    lines.add("order", [&at] { return orderLine(at); });
  if (!at.first.empty())
    lines.add("hit", [&at] { return hitLine(at); });
  return lines;
}

void drawMeeting(Figure &figure, const Meeting &meeting, const In &in, const Out &at) {
  const Place point = place(meeting.H);
  const bool isAhead = meeting.meet.which == RayPlaneCase::Hit;
  figure.reaches.push_back({meeting.id, point});
  if (!isAhead)
    figure.add(SegmentMark{{meeting.H->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), point});
  else if (meeting.meet.t > 0) // a ray that meets a plane in its start runs on
    figure.reaches.push_back({in.L.id, point});
  PointMark met = pointOf(meeting.H, isAhead ? Role::Derived : Role::Ghost, Subject::Ray);
  if (&meeting == firstMeeting(at))
    met.label.clear(); // it is called H there
  figure.add(std::move(met));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (isDegenerate(at))
    return figure;
  for (const Meeting &meeting : at.meetings)
    if (meeting.meet.crosses())
      drawMeeting(figure, meeting, in, at);
    else if (meeting.meet.which == RayPlaneCase::InPlane)
      figure.reachWithin(meeting.id, in.L.id, place(at.Q), unitOf(in.L.object.direction));
  if (!at.first.empty())
    figure.add(pointOf(at.H, Role::Result, Subject::Ray));
  return figure;
}

/// The ray moved to start in a plane, or turned to run along it.
void addRaysNear(std::vector<SpecialCase> &all, const Meeting &meeting, const std::string &value,
                 const In &in, const Out &at) {
  const auto &[origin, direction] = in.L.object;
  const ExactVec3 normal = vectorOf(meeting.n);
  const WordValues plane{{"plane", meeting.name}, {"Q", plainText(at.Q)}};
  const bool startsInPlane = meeting.meet.numerator == 0;
  if (!startsInPlane)
    all.push_back(
        {value + (meeting.meet.crosses() ? ".t = 0" : ".case = in-plane"),
         meeting.meet.crosses() ? words("{Q} would lie in {plane}.", plane)
                                : words("The ray would lie in {plane}.", plane),
         "L",
         RayObject{origin - projectVector(ExactVec3(origin - vectorOf(meeting.P0)), normal).projection,
                   direction}});
  if (const ExactVec3 turned = projectVector(direction, normal).rejection;
      meeting.meet.crosses() && !isZero(turned))
    all.push_back({value + (startsInPlane ? ".case = in-plane" : ".case = parallel"),
                   startsInPlane ? words("The ray would lie in {plane}.", plane)
                                 : words("The ray would run parallel to {plane}.", plane),
                   "L", RayObject{origin, turned}});
}

/// A plane slid along its normal until it goes through the point that is hit first.
void addPlaneNear(std::vector<SpecialCase> &all, std::size_t place, const Out &at) {
  const Meeting &meeting = at.meetings[place];
  const Meeting *first = firstMeeting(at);
  if (!first || !meeting.meet.crosses() || meeting.meet.t == first->meet.t)
    return;
  const ExactVec3 point = vectorOf(meeting.P0);
  const ExactVec3 normal = vectorOf(meeting.n);
  all.push_back(
      {"first = several",
       words("The ray would hit {one} and {other} at one point.",
             {{"one", first->name}, {"other", meeting.name}}),
       "planes",
       PlaneObject{point + projectVector(ExactVec3(first->meet.point - point), normal).projection, normal},
       place});
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (isDegenerate(at))
    return all;
  for (std::size_t i = 0; i < at.meetings.size(); ++i) {
    addRaysNear(all, at.meetings[i], planeValue(i), in, at);
    if (at.first.size() == 1)
      addPlaneNear(all, i, at);
  }
  return all;
}

/// The names of all that it can come to with so many planes as there may be.
ConstructionNames names() {
  ConstructionNames all{.cases = {"hit", "miss", "in-plane", "zero-direction", "zero-normal"},
                        .values = {},
                        .lines = {"ray", "order", "hit"},
                        .marks = {"H"}};
  std::vector<std::string> firstWords{"none", "several", "in-plane"};
  std::vector<ValueName> planes;
  for (std::size_t i = 0; i < maxListedObjects; ++i) {
    const std::string place = std::to_string(i);
    firstWords.push_back(planeValue(i));
    planes.push_back(
        named::group(planeValue(i), {named::word("case", {"hit", "behind", "parallel", "in-plane"}),
                                     named::number("t"), named::vector("point")}));
    for (const char *line : {"equation", "substitute", "t"})
      all.lines.push_back(line + place);
    all.marks.push_back("H" + place);
  }
  all.values = {named::word("first", std::move(firstWords)), named::number("t"), named::vector("point")};
  all.values.insert(all.values.end(), planes.begin(), planes.end());
  return all;
}

} // namespace

Construction ray_plane_substitution() {
  return makeConstruction<In, Out, Several<PlaneObject>, RayObject>(
      "ray-plane-substitution", {"planes", "L"}, {{"H", "point"}}, {"t"}, names(),
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
