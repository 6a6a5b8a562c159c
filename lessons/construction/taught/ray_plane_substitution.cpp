// Which of several planes a ray meets first: the ray's points put into each plane's equation (note PG 4).
#include "geometry/case_names.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/ray_at_plane.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

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
  Term d = 0, t = 0, H = 0;
  Term slope = 0, rest = 0; ///< of the equation slope·t + rest = 0
};

Meeting meetingWith(const Given<PlaneObject> &given, std::size_t place, const In &in) {
  const auto &[point, normal] = given.object;
  const auto plane = planeThrough(point, normal);
  const PlaneTerms letters = termsOf(given);
  const RayTerms ray = termsOf(in.L);
  const auto ofPlane = [&](Symbol symbol, const TermValue &value) {
    symbol.owner = given.id;
    return name(std::move(symbol), value);
  };
  Meeting meeting{letters, given.id, plainText(given.symbol), meetingOf(in.L.object, given.object)};
  meeting.d = ofPlane(letter("d"), plane.offset).standingFor(-dot(letters.n, letters.P0));
  meeting.slope = dot(letters.n, ray.r);
  meeting.rest = dot(letters.n, ray.Q) + meeting.d;
  meeting.t = ofPlane(letter("t"), meeting.meet.t);
  if (meeting.meet.crosses())
    meeting.t = meeting.t.standingFor(-meeting.rest / meeting.slope);
  meeting.H = ofPlane(letter("H"), meeting.meet.point).marked(in.mark("H" + std::to_string(place)));
  return meeting;
}

std::vector<Meeting> meetingsOf(const In &in) {
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < in.planes.size(); ++i)
    meetings.push_back(meetingWith(in.planes[i], i, in));
  return meetings;
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

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  std::vector<Meeting> meetings = meetingsOf(in);
  std::vector<std::size_t> first = firstOf(meetings); ///< the planes that are hit first, all with the same t
  /// The meeting whose plane is hit first, the one with the smallest place; null where none is hit.
  const Meeting *firstMeeting = first.empty() ? nullptr : &meetings[first.front()];
  Term H = madeName("H", firstMeeting ? firstMeeting->meet.point : in.L.object.origin);

  /// What is no plane, or null.
  [[nodiscard]] const Meeting *withoutNormal() const {
    const auto found = std::find_if(meetings.begin(), meetings.end(), [](const Meeting &meeting) {
      return meeting.meet.which == RayPlaneCase::ZeroNormal;
    });
    return found == meetings.end() ? nullptr : &*found;
  }
  /// Whether there are a ray and planes.
  bool isSound = !withoutNormal() && meetings.front().meet.which != RayPlaneCase::ZeroDirection;
  bool isHit = isSound && firstMeeting;
};

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
                 {{"planes", namesOf(at.first, at)}, {"t", equation(at.firstMeeting->t)}});
  return words("More than one plane has a t of 0 or more: the smallest of these tells which is hit first.");
}

CaseWords tell(const Out &at) {
  if (const Meeting *none = at.withoutNormal())
    return {std::string(nameOf(RayPlaneCase::ZeroNormal)),
            words("The normal {n} is the zero vector: it points nowhere, so {plane} is no plane.",
                  {{"n", plainText(none->n)}, {"plane", none->name}}),
            true};
  if (!at.isSound)
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

Word wordForFirst(const Out &at) {
  if (at.first.empty())
    return liesInPlane(at) ? wordOf(RayPlaneCase::InPlane) : noneOfThem();
  const std::size_t plane = at.first.front();
  return at.first.size() > 1 ? severalOfThem() : Word{planeValue(plane), at.meetings[plane].name};
}

bool hasPlane(const Out &at, std::size_t place) { return at.isSound && place < at.meetings.size(); }

bool crosses(const Out &at, std::size_t place) {
  return hasPlane(at, place) && at.meetings[place].meet.crosses();
}

WorkingLine rayLine(const Out &at) {
  const Term point = at.Q + unknown("t") * at.r;
  return line(Chain(point).then(namesPutIn(point)).then(calculated(point)),
              words("The ray's points: all their coordinates follow from the one number t."));
}

WorkingLine equationLine(const Out &at, std::size_t place) {
  const Meeting &meeting = at.meetings[place];
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

WorkingLine substituteLine(const Out &at, std::size_t place) {
  const Meeting &meeting = at.meetings[place];
  const Term inserted = dot(meeting.n, at.Q + unknown("t") * at.r) + meeting.d;
  const Term products = multipliedOut(inserted);
  return askedEquation(
      condition((0 == inserted).then(products).then(distributed(products)).then(calculated(inserted))),
      substituteWords(meeting));
}

/// The equation slope·t + rest = 0 solved.
WorkingLine parameterLine(const Out &at, std::size_t place) {
  const Meeting &meeting = at.meetings[place];
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
       {slope / solved->parts.front(), words("{answer} is upside down: divide by the coefficient of t.")},
       {slope / rest, words("{answer} is upside down: divide by the coefficient of t.")},
       {-rest, words("{answer} is not divided yet by the number before t.")}});
}

std::string orderWords(const Out &at) {
  if (!at.first.empty())
    return words("In their order. The first t that is 0 or more tells what the ray hits first.");
  return liesInPlane(at)
             ? words("In their order. No t is 0 or more, so the ray hits no plane at a single point.")
             : words("In their order. No t is 0 or more, so the ray meets no plane.");
}

bool meetsAny(const Out &at) {
  return std::any_of(at.meetings.begin(), at.meetings.end(),
                     [](const Meeting &meeting) { return meeting.meet.crosses(); });
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

void drawMeeting(Figure &figure, const Meeting &meeting, const Out &at) {
  const bool isAhead = meeting.meet.which == RayPlaneCase::Hit;
  figure.reaches.push_back({meeting.id, place(meeting.H)});
  if (!isAhead || meeting.meet.t > 0) // a ray that meets a plane in its start runs on
    addWayTo(figure, at.in.L, meeting.H, isAhead);
  PointMark met = pointOf(meeting.H, isAhead ? Role::Derived : Role::Ghost, Subject::Ray);
  if (&meeting == at.firstMeeting)
    met.label.clear(); // it is called H there
  figure.add(std::move(met));
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isSound)
    return figure;
  for (const Meeting &meeting : at.meetings)
    if (meeting.meet.crosses())
      drawMeeting(figure, meeting, at);
    else if (meeting.meet.which == RayPlaneCase::InPlane)
      figure.reachWithin(meeting.id, at.in.L.id, place(at.Q), unitOf(at.in.L.object.direction));
  if (!at.first.empty())
    figure.add(pointOf(at.H, Role::Result, Subject::Ray));
  return figure;
}

/// A plane slid along its normal until it goes through the point that is hit first.
void addPlaneNear(std::vector<SpecialCase> &all, std::size_t place, const Out &at) {
  const Meeting &meeting = at.meetings[place];
  const Meeting *first = at.firstMeeting;
  if (at.first.size() != 1 || !meeting.meet.crosses() || meeting.meet.t == first->meet.t)
    return;
  const auto &[point, normal] = at.in.planes[place].object;
  all.push_back(
      {is("first", "several"),
       words("The ray would hit {one} and {other} at one point.",
             {{"one", first->name}, {"other", meeting.name}}),
       "planes",
       PlaneObject{point + projectVector(ExactVec3(first->meet.point - point), normal).projection, normal},
       place});
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.isSound)
    return all;
  for (std::size_t i = 0; i < at.meetings.size(); ++i) {
    const WordValues plane{{"plane", at.meetings[i].name}, {"Q", plainText(at.Q)}};
    addRaysAtPlane(at.in.L.object, at.in.planes[i].object,
                   {words("{Q} would lie in {plane}.", plane), words("The ray would lie in {plane}.", plane),
                    words("The ray would run parallel to {plane}.", plane)},
                   all, planeValue(i) + ".");
    addPlaneNear(all, i, at);
  }
  return all;
}

ValueRow<Out> planeRow(std::size_t place) {
  const auto its = [place](const Out &at) -> const Meeting & { return at.meetings[place]; };
  const auto isCrossed = [place](const Out &at) { return crosses(at, place); };
  return valueGroup<Out>(
      planeValue(place), [place](const Out &at) { return hasPlane(at, place); },
      {{named::word("case", {"hit", "behind", "parallel", "in-plane"}), always,
        [its](const Out &at) { return ToldValue(its(at).name, wordOf(its(at).meet.which)); }},
       {named::number("t"), isCrossed, [its](const Out &at) { return its(at).t; }},
       {named::vector("point"), isCrossed, [its](const Out &at) { return its(at).H; }}});
}

ValueTable<Out> values() {
  std::vector<std::string> firstWords{"none", "several", "in-plane"};
  ValueTable<Out> planes;
  for (std::size_t i = 0; i < maxListedObjects; ++i) {
    firstWords.push_back(planeValue(i));
    planes.push_back(planeRow(i));
  }
  return joined<ValueRow<Out>>(
      {{{named::word("first", firstWords), &Out::isSound,
         [](const Out &at) { return Value(wordForFirst(at)); }},
        {named::number("t"), &Out::isHit, [](const Out &at) { return at.firstMeeting->t; }},
        {named::vector("point"), &Out::isHit, &Out::H}},
       planes});
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {{{"ray", &Out::isSound, rayLine}},
       linesOfEach<Out>(
           maxListedObjects, hasPlane,
           {{"equation", equationLine}, {"substitute", substituteLine}, {"t", parameterLine, crosses}}),
       {{"order", [](const Out &at) { return at.isSound && meetsAny(at); }, orderLine},
        {"hit", &Out::isHit,
         [](const Out &at) { return withNumbers(at.H == at.Q + at.firstMeeting->t * at.r); },
         says("The smallest t that is not negative, put into the ray.")}}});
}

} // namespace

Construction ray_plane_substitution() {
  return taught<Out, Several<PlaneObject>, RayObject>(
      {.id = "ray-plane-substitution",
       .title = [] { return words("ray put into the equation"); },
       .roles = {"planes", "L"},
       .makes = {{"H", &Out::isHit, &Out::H}},
       .letters = {"t"},
       .cases = {"hit", "miss", "in-plane", "zero-direction", "zero-normal"},
       .values = values(),
       .lines = lines(),
       .marks = joined({{"H"}, numbered("H", maxListedObjects)}),
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
